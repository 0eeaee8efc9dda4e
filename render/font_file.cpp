// SPDX-License-Identifier: MIT
#include "render/font_file.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace flipbook::render {

namespace {

std::vector<std::string> folders() {
  if (const char* own = std::getenv("FLIPBOOK_FONTS"); own != nullptr && *own != '\0') return {own};
  return {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu-sans-fonts",
          "/usr/share/fonts/dejavu",          "/usr/share/fonts/TTF",
          "/usr/local/share/fonts",           "/opt/homebrew/share/fonts"};
}

} // namespace

std::string find_font(const char* file) {
  for (const std::string& folder : folders()) {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::path(folder) / file;
    if (std::filesystem::is_regular_file(path, error)) return path.string();
  }
  return {};
}

std::string no_font(const char* file) {
  std::string text = std::string("there is no ") + file + " in ";
  const std::vector<std::string> all = folders();
  for (std::size_t i = 0; i < all.size(); ++i) text += (i == 0 ? "" : i + 1 == all.size() ? " or " : ", ") + all[i];
  return text + " (package fonts-dejavu-core, or FLIPBOOK_FONTS=folder)";
}

} // namespace flipbook::render
