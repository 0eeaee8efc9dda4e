// SPDX-License-Identifier: MIT
// A teaching figure: a claim, a caption and a picture whose data the solvers compute when it is asked for. What it
// claims and what it runs stand in assets/figures/NAME.toml; how it is computed and drawn is its kind, a file each in
// this folder and a line in kinds.cpp.
#pragma once

#include "app/validate/case.h"
#include "render/chart/pen.h"
#include "sim/frame/parameters.h"

#include <concepts>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

class ParticlePictures; // particle_pictures.h

/// Numbers beside the picture: NAME.csv, or NAME_part.csv where a figure has several.
struct FigureTable {
  std::string part; ///< may be empty
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows{};

  /// A row of numbers and words.
  template <class... Cells> void add(const Cells&... cells) { rows.push_back({cell(cells)...}); }
  [[nodiscard]] std::string csv() const;

private:
  static std::string cell(const std::string& text) { return text; }
  static std::string cell(const char* text) { return text; }
  template <std::integral T> static std::string cell(T n) { return std::to_string(n); }
  static std::string cell(double x); ///< 17 digits
};

/// Where a body draws. Lengths are in units of 0.6 points, so that text of the usual size 12 is 7.2 points on paper.
struct FigureArea {
  render::Pen& pen;
  double x, y, width;         ///< upper left corner
  ParticlePictures* pictures; ///< null while only the height is wanted

  [[nodiscard]] double right() const { return x + width; }
  /// Too narrow for panels side by side: a column of a paper.
  [[nodiscard]] bool narrow() const { return width < 600; }
};

/// The computed figure. It draws itself any number of times, in any width.
class FigureBody {
public:
  virtual ~FigureBody() = default;
  /// Returns where it ends: the y of its lower edge.
  virtual double draw(const FigureArea& area) const = 0;
  [[nodiscard]] virtual std::vector<FigureTable> tables() const = 0;
};

class FigureKind {
public:
  virtual ~FigureKind() = default;
  /// What the figure's [run] may set.
  virtual void describe(ParameterVisitor& v) = 0;
  /// Runs the solvers. The results do not depend on the number of threads.
  [[nodiscard]] virtual std::unique_ptr<FigureBody> compute(const Lab& lab) const = 0;
};

struct FigureKindEntry {
  std::string name, summary;
  std::unique_ptr<FigureKind> (*make)();
};

/// Numbers that a [run] lists as texts, as lists of any length are. Throws UserError for one that is none.
[[nodiscard]] std::vector<double> numbers_of(const std::vector<std::string>& texts, const std::string& what);

/// All kinds.
[[nodiscard]] std::span<const FigureKindEntry> figure_kinds();

} // namespace flipbook::app
