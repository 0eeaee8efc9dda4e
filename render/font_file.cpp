// SPDX-License-Identifier: MIT
#include "render/font_file.h"

#include <array>
#include <cstdlib>
#include <filesystem>

namespace flipbook::render {

std::string find_font(const char* file) {
  std::array<std::string, 7> folders{"",
                                     "/usr/share/fonts/truetype/dejavu",
                                     "/usr/share/fonts/dejavu-sans-fonts",
                                     "/usr/share/fonts/dejavu",
                                     "/usr/share/fonts/TTF",
                                     "/usr/local/share/fonts",
                                     "/opt/homebrew/share/fonts"};
  if (const char* own = std::getenv("FLIPBOOK_FONTS"); own != nullptr) folders[0] = own;
  for (const std::string& folder : folders) {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::path(folder) / file;
    if (!folder.empty() && std::filesystem::is_regular_file(path, error)) return path.string();
  }
  return {};
}

} // namespace flipbook::render
