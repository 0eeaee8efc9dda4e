// SPDX-License-Identifier: MIT
// What assets/figures/NAME.toml says of a figure.
#pragma once

#include "app/figures/figure.h"
#include "sim/scene/toml_reader.h"

#include <string>
#include <vector>

namespace flipbook::app {

struct FigureSpec {
  std::string name;            ///< of the file
  int number = 0;              ///< its place among all figures
  std::string kind;            ///< who computes and draws it
  std::string claim, caption;  ///< one sentence that the picture shows; what was run and what is drawn
  double width = 0;            ///< mm, where none is asked for
  std::vector<Assignment> run; ///< parameters of the kind, in the order of the file
};

/// The figure of that name, or of a file. With `fast` what its [fast] says replaces what [run] says: fewer cells,
/// shorter times. Throws UserError with every mistake of the text.
[[nodiscard]] FigureSpec read_figure(const std::string& name_or_path, bool fast);

/// The names of all figures, by their numbers.
[[nodiscard]] std::vector<std::string> list_figures();

/// Its kind with the parameters set. Throws UserError for those that the kind does not have.
[[nodiscard]] std::unique_ptr<FigureKind> kind_of(const FigureSpec& spec);

/// "84mm", "17.4 cm", "6.5in", or "column" (84 mm) and "text" (174 mm). Throws UserError.
[[nodiscard]] double parse_width(const std::string& text);

} // namespace flipbook::app
