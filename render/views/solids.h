// SPDX-License-Identifier: MIT
// Solid bodies: areas with an outline in 2D, lit surfaces in 3D.
#pragma once

#include "render/gl/handles.h"
#include "render/gl/program.h"
#include "render/theme.h"
#include "render/views/pane_view.h"
#include "render/views/surroundings.h"

#include <memory>
#include <vector>

namespace flipbook::render {

/// 2D.
void draw_solid_areas(gui::Ink& ink, const PaneView& pane, const Palette& palette);

/// A position and a normal, three numbers each, for each corner of each triangle. Where neighbouring triangles meet at
/// less than 35 degrees the surface is taken to be smooth.
[[nodiscard]] std::vector<float> lit_corners(const TriangleMesh& mesh);

/// 3D.
class SolidView {
public:
  explicit SolidView(const gl::Functions& gl);
  /// Draws into the layer that is bound, whose pixels are those of `viewport` in the picture.
  void draw(const PaneView& pane, const Rect& viewport, Colour colour, const Surroundings& around);

private:
  /// A surface that was uploaded; it stays as long as anyone holds the mesh.
  struct Uploaded {
    explicit Uploaded(const gl::Functions& gl, const std::shared_ptr<const TriangleMesh>& mesh);
    std::weak_ptr<const TriangleMesh> mesh;
    gl::VertexArray array;
    gl::Buffer vertices;
    GLsizei count = 0;
  };
  void upload(const Surroundings& around);
  [[nodiscard]] const Uploaded& uploaded(const std::shared_ptr<const TriangleMesh>& mesh);

  const gl::Functions* gl_;
  gl::Program program_;
  gl::Texture around_;
  std::vector<Uploaded> known_;
};

} // namespace flipbook::render
