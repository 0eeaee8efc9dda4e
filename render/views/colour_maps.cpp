// SPDX-License-Identifier: MIT
#include "render/views/colour_maps.h"

#include <array>
#include <cmath>

namespace flipbook::render {

// viridis, magma, inferno and cividis are the CC0 maps of matplotlib (S. van der Walt, N. Smith, E. Firing; J. Nunez,
// C. Anderton, R. Renslow) at ten places. The others are our own: on a dark page slow or zero has to be visible without
// glowing, on a light page fast has to be dark, so each theme has its sequential and its diverging map.
std::span<const ColourMap> colour_maps() {
  using enum MapKind;
  static const std::vector<ColourMap> maps{
      // clang-format off
      {"lagoon", "deep blue to pale yellow; for dark pages", sequential, {0x2d3fa6, 0x2463b8, 0x1f8cc6, 0x3fb3c6, 0x83d2b9, 0xcdecb0, 0xfffbd1}},
      {"ink", "pale green to dark blue; for light pages", sequential, {0x9ad3c0, 0x55bac4, 0x2596c1, 0x2068ad, 0x263f96, 0x141d5c}},
      {"viridis", "purple, green, yellow", sequential, {0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725}},
      {"magma", "black, purple, cream", sequential, {0x000004, 0x180f3d, 0x440f76, 0x721f81, 0x9e2f7f, 0xcd4071, 0xf1605d, 0xfd9668, 0xfeca8d, 0xfcfdbf}},
      {"inferno", "black, red, yellow", sequential, {0x000004, 0x1b0c41, 0x4a0c6b, 0x781c6d, 0xa52c60, 0xcf4446, 0xed6925, 0xfb9b06, 0xf7d13d, 0xfcffa4}},
      {"cividis", "blue to yellow; the same for colour-blind readers", sequential, {0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55, 0xfee838}},
      {"glow", "light blue, grey, light orange; diverging, for dark pages", diverging, {0x8fd3ff, 0x3f9be8, 0x3d6ea8, 0x59616b, 0xa8653a, 0xec8a35, 0xffcb85}},
      {"vane", "dark blue, grey, dark red; diverging, for light pages", diverging, {0x0b2f73, 0x2166ac, 0x6ca4cf, 0xc9ced3, 0xdf8f6e, 0xb5302b, 0x6b0a1c}},
      {"wheel", "all hues, equally light; cyclic", cyclic, {0xe0708a, 0xd0814a, 0xa59a3a, 0x62ad69, 0x22aea6, 0x4a9fd6, 0x8f8adb, 0xc777bd, 0xe0708a}},
      // clang-format on
  };
  return maps;
}

std::span<const Option> colour_map_options() {
  static const std::vector<Option> options = [] {
    std::vector<Option> o{{"auto", "suits the quantity and the theme"}};
    for (const ColourMap& m : colour_maps()) o.push_back({m.name, m.help});
    return o;
  }();
  return options;
}

const ColourMap& choose_map(int index, MapKind kind, Theme theme) {
  const std::span<const ColourMap> maps = colour_maps();
  if (index > 0 && static_cast<std::size_t>(index) <= maps.size()) return maps[static_cast<std::size_t>(index) - 1];
  const bool dark = theme == Theme::dark;
  const std::string_view name = kind == MapKind::cyclic      ? "wheel"
                                : kind == MapKind::diverging ? (dark ? "glow" : "vane")
                                                             : (dark ? "lagoon" : "ink");
  for (const ColourMap& m : maps)
    if (m.name == name) return m;
  return maps.front();
}

static double to_linear(std::uint8_t c) {
  const double s = c / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

static std::uint8_t to_srgb(double x) {
  const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(std::clamp(s, 0.0, 1.0) * 255));
}

Oklab to_oklab(Colour c) {
  const double r = to_linear(c.r), g = to_linear(c.g), b = to_linear(c.b);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Colour from_oklab(const Oklab& c) {
  const double l = std::pow(c.l + 0.3963377774 * c.a + 0.2158037573 * c.b, 3);
  const double m = std::pow(c.l - 0.1055613458 * c.a - 0.0638541728 * c.b, 3);
  const double s = std::pow(c.l - 0.0894841775 * c.a - 1.2914855480 * c.b, 3);
  return {to_srgb(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          to_srgb(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          to_srgb(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s), 255};
}

double distance(const Oklab& p, const Oklab& q) {
  return std::hypot(p.l - q.l, p.a - q.a, p.b - q.b);
}

/// `n` colours from `from` to `to` (indices of control colours), at equal distances along the way.
static void append(std::vector<Colour>& out, const std::vector<Oklab>& control, std::size_t from, std::size_t to,
                   std::size_t n, bool with_end) {
  std::vector<double> at{0};
  for (std::size_t i = from; i < to; ++i) at.push_back(at.back() + distance(control[i], control[i + 1]));
  const auto steps = static_cast<double>(with_end ? n - 1 : n);
  for (std::size_t k = 0; k < n; ++k) {
    const double s = at.back() * static_cast<double>(k) / steps;
    std::size_t i = 1;
    while (i + 1 < at.size() && at[i] < s) ++i;
    const double f = (s - at[i - 1]) / (at[i] - at[i - 1]);
    const Oklab &p = control[from + i - 1], &q = control[from + i];
    out.push_back(from_oklab({p.l + f * (q.l - p.l), p.a + f * (q.a - p.a), p.b + f * (q.b - p.b)}));
  }
}

std::vector<Colour> table(const ColourMap& map) {
  std::vector<Oklab> control;
  for (const std::uint32_t c : map.colours) control.push_back(to_oklab(Colour::hex(c)));
  std::vector<Colour> out;
  const std::size_t last = control.size() - 1;
  if (map.kind == MapKind::diverging) { // each half on its own, so that zero stays in the middle
    append(out, control, 0, last / 2, 128, false);
    append(out, control, last / 2, last, 128, true);
  } else {
    append(out, control, 0, last, 256, true);
  }
  return out;
}

} // namespace flipbook::render
