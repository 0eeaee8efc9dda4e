// SPDX-License-Identifier: MIT
// The drawing surface of charts and figures: Cairo behind a few verbs, on pixels or as PDF or SVG. Lengths are in units
// of the page, y down; a text of size 12 is the usual one.
//   PDF  fonts are embedded (the letters in use), so that text can be searched and copied
//   SVG  letters are outlines: the same picture in every viewer, whether or not it has the fonts or reads embedded ones
// Nothing of the clock gets into a file: equal drawings are equal bytes.
#pragma once

#include "render/chart/rich_text.h"
#include "render/image.h"
#include "render/shapes.h"

#include <cstdint>
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
enum class Dash { solid, dashes, dots, dash_dot, short_dashes, dash_dot_dot, long_dashes };
enum class Medium { pixels, pdf, svg };

struct Sheet {
  double width, height; ///< units
  double unit = 1;      ///< pixels of a unit; points (1/72 inch) on paper
  Medium medium = Medium::pixels;
  Colour page{255, 255, 255, 255};
  std::string title{}, subject{}; ///< what a PDF or SVG says about itself
};

class Pen {
public:
  /// Throws MachineError without fonts.
  explicit Pen(const Sheet& sheet);
  /// Pixels.
  Pen(double width, double height, double scale, Colour page);
  ~Pen();
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  void line(std::span<const ChartPoint> points, Colour colour, double width, Dash dash = Dash::solid);
  void line(ChartPoint from, ChartPoint to, Colour colour, double width, Dash dash = Dash::solid);
  void fill(std::span<const ChartPoint> outline, Colour colour);
  void fill(const Rect& box, Colour colour, double corner = 0);
  void outline(const Rect& box, Colour colour, double width, double corner = 0, Dash dash = Dash::solid);
  void disc(ChartPoint centre, double radius, Colour colour);
  void ring(ChartPoint centre, double radius, Colour colour, double width);
  /// Over the box; of pixels at least as fine as the sheet's.
  void picture(const Image& image, const Rect& box);
  /// `at` is on the base line. Mathematics as in rich_text.h.
  void text(ChartPoint at, const std::string& text, double size, Colour colour, Weight weight = Weight::regular,
            Align align = Align::left);
  [[nodiscard]] double width(const std::string& text, double size, Weight weight = Weight::regular) const;
  /// Broken at spaces into lines of at most `width`.
  [[nodiscard]] std::vector<std::string> wrapped(const std::string& text, double size, double width,
                                                 Weight weight = Weight::regular) const;
  /// Nothing is drawn outside until released.
  void clip(const Rect& box);
  void release();

  [[nodiscard]] const Sheet& sheet() const { return sheet_; }
  [[nodiscard]] Image image() const; ///< of pixels
  /// The whole file, of PDF and SVG; ends the drawing. Throws MachineError where Cairo failed.
  [[nodiscard]] std::vector<std::uint8_t> file();
  [[nodiscard]] const std::vector<TextBox>& texts() const { return texts_; } ///< so far, for tests

private:
  struct Surface;
  void use(double size, Weight weight, bool italic) const;
  [[nodiscard]] TextLine line_of(const std::string& text, double size, Weight weight) const;
  void box_path(const Rect& box, double corner);
  std::unique_ptr<Surface> surface_;
  Sheet sheet_;
  std::vector<TextBox> texts_;
};

} // namespace flipbook::render
