// SPDX-License-Identifier: MIT
// The page's own files (app/gallery/page), as the build writes them into the program.
#pragma once

#include <span>
#include <string_view>

namespace flipbook::app::gallery {

struct PageFile {
  std::string_view name, text; ///< "page.html"
};
[[nodiscard]] std::span<const PageFile> page_files();

} // namespace flipbook::app::gallery
