// SPDX-License-Identifier: MIT
// A formula written in a scene, for example "sin(2*pi*x)*cos(2*pi*y)".
#pragma once

#include "sim/frame/errors.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace flipbook {

/// Operators + - * / ^, comparisons, && || and ?:, pi and e, and the usual functions (sin cos tan asin acos atan atan2
/// sinh cosh tanh exp ln log10 sqrt abs min max sign ...).
class Expression {
public:
  /// Throws UserError at `where` if the text is not a formula in these variables.
  Expression(const std::string& text, const std::vector<std::string>& variables, const Location& where);

  /// One number for each variable. May be called from several threads; throws UserError where the result is not finite.
  [[nodiscard]] double operator()(std::span<const double> values) const;

private:
  struct Parser;
  std::shared_ptr<Parser> parser_;
  std::string text_;
  Location where_;
};

} // namespace flipbook
