// SPDX-License-Identifier: MIT
// The page: one file with its style and its script inside, which loads nothing from anywhere but its own folder and
// works from a disk.
#pragma once

#include "app/gallery/piece.h"

#include <filesystem>
#include <string>
#include <vector>

namespace flipbook::app::gallery {

struct PageText {
  std::string title, intro;
  std::vector<Piece> pieces;
};

/// `folder`: of the gallery, where the files of the pieces are. `inlined`: they become part of the page.
[[nodiscard]] std::string page_html(const PageText& text, const std::filesystem::path& folder, bool inlined);

/// What a page of ours has in its head; nothing else is replaced.
inline constexpr const char* page_mark = "<meta name=\"generator\" content=\"Flipbook";

} // namespace flipbook::app::gallery
