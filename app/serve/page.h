// SPDX-License-Identifier: MIT
// The page's files, as embed.cmake writes them into the build. These and no others are served: no request names a file
// on the disk.
#pragma once

#include <span>
#include <string_view>

namespace flipbook::app::serve {

struct PageFile {
  std::string_view name, text; ///< "index.html"
  /// By the ending of its name.
  [[nodiscard]] std::string_view type() const;
};
[[nodiscard]] std::span<const PageFile> page_files();
/// The file behind "/page.css"; "/" is index.html. Null: there is none.
[[nodiscard]] const PageFile* page_file(std::string_view path);

} // namespace flipbook::app::serve
