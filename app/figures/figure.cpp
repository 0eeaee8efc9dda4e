// SPDX-License-Identifier: MIT
#include "app/figures/figure.h"

#include "sim/frame/errors.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace flipbook::app {

std::string FigureTable::cell(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", x);
  return text.data();
}

std::vector<double> numbers_of(const std::vector<std::string>& texts, const std::string& what) {
  std::vector<double> numbers;
  for (const std::string& text : texts) {
    const Value value = parse_value(text);
    const double* x = std::get_if<double>(&value);
    if (!x || !std::isfinite(*x)) throw UserError(what + ": \"" + text + "\" is no number");
    numbers.push_back(*x);
  }
  return numbers;
}

std::string FigureTable::csv() const {
  std::string text;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string& c = cells[i];
      text += i == 0 ? "" : ",";
      if (c.find_first_of(",\"\n") == std::string::npos) {
        text += c;
        continue;
      }
      text += '"';
      for (const char ch : c) text += ch == '"' ? "\"\"" : std::string(1, ch);
      text += '"';
    }
    text += '\n';
  };
  line(columns);
  for (const auto& row : rows) line(row);
  return text;
}

} // namespace flipbook::app
