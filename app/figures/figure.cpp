// SPDX-License-Identifier: MIT
#include "app/figures/figure.h"

#include <array>
#include <cstdio>

namespace flipbook::app {

std::string FigureTable::cell(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", x);
  return text.data();
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
