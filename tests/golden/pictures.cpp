// SPDX-License-Identifier: MIT
#include "tests/golden/pictures.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace flipbook::test {

std::shared_ptr<const Snapshot> stored(const std::string& name) {
  static std::map<std::string, std::shared_ptr<const Snapshot>> known;
  auto& s = known[name];
  if (s == nullptr)
    s = std::make_shared<Snapshot>(
        load_snapshot(std::string(FLIPBOOK_SOURCE_DIR "/tests/golden/snapshots/") + name + ".snap"));
  return s;
}

render::Frame frame_of(const std::string& title, const std::vector<std::string>& names) {
  render::Frame f;
  f.title = title;
  f.duration = 1;
  for (const std::string& n : names) {
    f.panes.push_back({stored(n)->title, stored(n)});
    f.time = stored(n)->time;
  }
  return f;
}

render::Frame dam_frame(std::size_t panes) {
  const std::array<std::string, 3> names{"dam_pic", "dam_flip", "dam_apic"};
  std::vector<std::string> chosen;
  for (std::size_t i = 0; i < panes; ++i) chosen.push_back(names[i % names.size()]);
  render::Frame f = frame_of("Dam break: what the transfer does", chosen);
  for (std::size_t i = names.size(); i < panes; ++i) f.panes[i].title += ", again " + std::to_string(i / names.size());
  return f;
}

render::ViewSettings view_with(const std::vector<std::string>& changes) {
  render::ViewSettings view;
  for (const std::string& change : changes) {
    const std::size_t equals = change.find('=');
    const Refusal r = set_parameter(view, change.substr(0, equals), parse_value(change.substr(equals + 1)));
    if (!r.message.empty()) throw std::runtime_error(change + ": " + r.message);
  }
  return view;
}

render::Image read_png(const std::string& path) {
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<unsigned char, decltype(&std::free)> pixels(
      stbi_load(path.c_str(), &width, &height, &channels, 4), &std::free);
  if (pixels == nullptr) return {};
  const std::size_t bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
  return {width, height, {pixels.get(), pixels.get() + bytes}};
}

void write_png(const render::Image& image, const std::string& path) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  // Stored pictures are opaque: three channels are a quarter smaller.
  std::vector<unsigned char> rgb;
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) rgb.push_back(image.rgba[i]);
  stbi_write_png_compression_level = 12;
  if (stbi_write_png(path.c_str(), image.width, image.height, 3, rgb.data(), 0) == 0)
    throw std::runtime_error("cannot write " + path);
}

Difference difference(const render::Image& a, const render::Image& b) {
  if (a.width != b.width || a.height != b.height) return {255, 255};
  Difference d;
  double total = 0;
  for (int y = 0; y < a.height; y += 4)
    for (int x = 0; x < a.width; x += 4)
      for (int c = 0; c < 4; ++c) {
        int sum = 0, n = 0;
        for (int j = y; j < std::min(y + 4, a.height); ++j)
          for (int i = x; i < std::min(x + 4, a.width); ++i, ++n) {
            const auto at = static_cast<std::size_t>((j * a.width + i) * 4 + c);
            const int one = a.rgba[at] - b.rgba[at];
            sum += one;
            total += std::abs(one);
          }
        d.largest = std::max(d.largest, std::abs(static_cast<double>(sum)) / n);
      }
  d.mean = total / static_cast<double>(std::max<std::size_t>(a.rgba.size(), 1));
  return d;
}

render::Image difference_picture(const render::Image& a, const render::Image& b) {
  render::Image out = a;
  if (a.rgba.size() != b.rgba.size()) return out;
  for (std::size_t i = 0; i < out.rgba.size(); ++i)
    out.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(std::min(255, 64 + 3 * std::abs(a.rgba[i] - b.rgba[i])));
  return out;
}

} // namespace flipbook::test
