// SPDX-License-Identifier: MIT
#include "render/particle_picture.h"

#include "render/theme.h"
#include "render/views/flat.h"

namespace flipbook::render {

struct ParticlePicture::Impl {
  explicit Impl(Context& context) : gl(context), flat(gl, {}) {}
  gl::Functions gl;
  FlatView flat;
};

ParticlePicture::ParticlePicture(Context& context) : impl_(std::make_unique<Impl>(context)) {}
ParticlePicture::~ParticlePicture() = default;

Image ParticlePicture::draw(const std::shared_ptr<const Snapshot>& snapshot, const ViewSettings& view,
                            const Window& window, int width, int height, float point) {
  const gl::Functions& gl = impl_->gl;
  const gl::Canvas canvas(gl, width, height);
  canvas.bind();
  const Colour page = palette(view.theme).page;
  gl.Disable(GL_SCISSOR_TEST);
  gl.ClearColor(page.r / 255.F, page.g / 255.F, page.b / 255.F, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  const auto metre = static_cast<float>(width / (window.hi[0] - window.lo[0]));
  const Rect frame{0, 0, static_cast<float>(width), static_cast<float>(height)};
  // The domain's lower left corner, wherever it lies; the pane measures from there.
  const Rect domain{static_cast<float>(snapshot->lo[0] - window.lo[0]) * metre, 0, frame.w,
                    frame.h + static_cast<float>(window.lo[1] - snapshot->lo[1]) * metre};
  const PaneView pane{.snapshot = snapshot.get(), .frame = frame, .domain = domain, .metre = metre, .colour = page};
  Frame shown;
  shown.panes.push_back({"", snapshot});
  const std::vector<std::vector<float>> values{colour_values(*snapshot, chosen_quantity(view))};
  impl_->flat.draw(pane, values.front(), shared_scale(shown, view, values), view, point, canvas);
  return canvas.read();
}

} // namespace flipbook::render
