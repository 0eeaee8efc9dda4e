// SPDX-License-Identifier: MIT
// A recorded step as pictures: a page for each stage, or one sheet of all of them. The variants stand side by side on a
// page, and one below the other on a sheet, in the same window and on the same scales throughout.
#pragma once

#include "app/stages/painter.h"
#include "render/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipbook::app {

class StageBook {
public:
  /// Takes the steps of all variants; they must be of 2D domains of the same size. Throws UserError.
  StageBook(std::string title, std::vector<RecordedStep> steps, const std::string& window, render::Theme theme);

  [[nodiscard]] std::size_t pages() const { return story_.size(); }
  [[nodiscard]] const StoryStage& stage(std::size_t k) const { return story_[k]; }
  [[nodiscard]] const render::Window& window() const { return window_; }

  /// Pixels; `texts`, if given, gets where the text is.
  [[nodiscard]] render::Image page(std::size_t k, int width, int height,
                                   std::vector<render::TextBox>* texts = nullptr) const;

  struct Sheet {
    render::Sheet page;                 ///< with its size
    render::Image image;                ///< of pixels
    std::vector<std::uint8_t> file;     ///< of PDF and SVG
    std::vector<render::TextBox> texts; ///< in units of the page
  };
  /// `width`: in pixels, or points on paper. Its height follows.
  [[nodiscard]] Sheet sheet(render::Medium medium, double width) const;

private:
  [[nodiscard]] StagePicture picture(std::size_t variant, std::size_t k) const {
    return {steps_[variant], story_[k], window_, scales_, shown_[variant], colours_};
  }
  [[nodiscard]] double aspect() const; ///< width over height of the window
  [[nodiscard]] bool nodes() const;
  [[nodiscard]] std::string when() const; ///< "t = 0.4 s, Δt = 3.2 ms"
  [[nodiscard]] double cell_in(double window_width) const;

  void draw_header(render::Pen& pen, double width) const;
  void draw_stage_line(render::Pen& pen, std::size_t k, double width) const;
  void draw_windows(render::Pen& pen, std::size_t k, const render::Rect& area) const;
  struct Windows {
    std::size_t columns = 1;
    double width = 0;
  };
  [[nodiscard]] Windows windows_in(const render::Rect& area) const;
  double draw_list(render::Pen& pen, std::size_t k, render::ChartPoint at, double width, double height) const;
  void draw_side(render::Pen& pen, std::size_t k, const render::Rect& area, double cell) const;
  [[nodiscard]] std::size_t sheet_columns() const;
  double draw_sheet(render::Pen& pen, double width) const;
  double draw_sheet_windows(render::Pen& pen, double y, double wide) const;
  void draw_reading(render::Pen& pen, std::size_t variant, std::size_t k, double x, double y) const;
  void draw_sheet_label(render::Pen& pen, std::size_t k, double x, double y, double width) const;

  std::string title_;
  std::vector<RecordedStep> steps_;
  std::vector<StoryStage> story_;                ///< of all of them
  std::vector<std::vector<StoryStage>> stories_; ///< of each
  render::Window window_;
  StageScales scales_;
  std::vector<ShownParticle> shown_; ///< of each variant
  StageColours colours_;
};

} // namespace flipbook::app
