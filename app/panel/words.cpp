// SPDX-License-Identifier: MIT
#include "app/panel/words.h"

#include "render/views/ticks.h"

#include <cmath>

namespace flipbook::app {
namespace {

/// Numbers of a list; the third axis of a 2D run says nothing.
std::string joined(const std::vector<double>& x, int dim, std::string_view between) {
  const std::size_t n = x.size() == 3 ? static_cast<std::size_t>(dim) : x.size();
  std::string out;
  for (std::size_t i = 0; i < n; ++i) out.append(i == 0 ? "" : between).append(value_of(x[i]));
  return out;
}

} // namespace

std::string label_of(std::string_view path) {
  std::size_t dot = path.rfind('.');
  if (dot != std::string_view::npos && path.size() - dot - 1 <= 2) dot = dot == 0 ? dot : path.rfind('.', dot - 1);
  std::string label(dot == std::string_view::npos ? path : path.substr(dot + 1));
  for (char& c : label)
    if (c == '_' || c == '.') c = ' ';
  return label;
}

/// Three digits keep a moving value from growing and shrinking; large numbers are not cut.
std::string value_of(double x) {
  return render::number(x, std::abs(x) < 100 ? 3 : 6);
}

std::string value_text(const Parameter& p, int dim) {
  std::string text;
  if (const auto* flag = std::get_if<bool>(&p.value)) text = *flag ? "on" : "off";
  if (const auto* x = std::get_if<double>(&p.value)) text = value_of(*x);
  if (const auto* s = std::get_if<std::string>(&p.value)) text = *s;
  if (const auto* list = std::get_if<std::vector<double>>(&p.value))
    text = joined(*list, dim, p.kind == Kind::integers ? " × " : ", ");
  if (const auto* list = std::get_if<std::vector<std::string>>(&p.value))
    for (const std::string& s : *list) text += (text.empty() ? "" : ", ") + s;
  return p.unit.empty() ? text : text + " " + render::unit_text(p.unit);
}

std::string ends_of(const Parameter& p) {
  if (p.at_min.empty() && p.at_max.empty()) return "";
  return value_of(p.min) + " " + p.at_min + " – " + value_of(p.max) + " " + p.at_max;
}

bool has_slider(const Parameter& p) {
  const bool number = p.kind == Kind::real || p.kind == Kind::integer;
  return number && std::isfinite(p.min) && std::isfinite(p.max) && p.max > p.min;
}

SliderScale::SliderScale(const Parameter& p)
    : logarithmic_(p.min > 0 && p.max / p.min >= 1e4), lo_(warp(p.min)), hi_(warp(p.max)) {}

double SliderScale::warp(double x) const {
  return logarithmic_ ? std::log10(x) : x;
}
double SliderScale::unwarp(double y) const {
  return logarithmic_ ? std::pow(10, y) : y;
}

} // namespace flipbook::app
