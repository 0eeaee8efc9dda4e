// SPDX-License-Identifier: MIT
// The drawing surface of charts: Cairo behind a few verbs. Lengths are in points of a page that is 960 wide.
#pragma once

#include "render/image.h"
#include "render/shapes.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace flipbook::render {

struct ChartPoint {
  double x, y;
};

enum class Weight { regular, bold };
enum class Align { left, centre, right };

class Pen {
public:
  /// A page in one colour. Throws MachineError without fonts.
  Pen(double width, double height, double scale, Colour page);
  ~Pen();
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  void line(std::span<const ChartPoint> points, Colour colour, double width, bool dashed = false);
  void fill(std::span<const ChartPoint> outline, Colour colour);
  void disc(ChartPoint centre, double radius, Colour colour);
  /// `at` is on the base line.
  void text(ChartPoint at, const std::string& text, double size, Colour colour, Weight weight = Weight::regular,
            Align align = Align::left);
  [[nodiscard]] double width(const std::string& text, double size, Weight weight = Weight::regular) const;
  /// Broken at spaces into lines of at most `width`.
  [[nodiscard]] std::vector<std::string> wrapped(const std::string& text, double size, double width,
                                                 Weight weight = Weight::regular) const;
  /// Nothing is drawn outside until released.
  void clip(const Rect& box);
  void release();

  [[nodiscard]] Image image() const;
  [[nodiscard]] const std::vector<TextBox>& texts() const { return texts_; } ///< so far, for tests

private:
  struct Surface;
  void use(double size, Weight weight) const;
  std::unique_ptr<Surface> surface_;
  std::vector<TextBox> texts_;
};

} // namespace flipbook::render
