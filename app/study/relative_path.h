// SPDX-License-Identifier: MIT
// How a scene or a study calls a file that lies elsewhere.
#pragma once

#include <filesystem>
#include <string>

namespace flipbook::app {

/// `file` as a text in `folder` shall name it. Of what exists the real places are compared: ".." of a link is not where
/// the link is.
[[nodiscard]] std::string relative_path(const std::filesystem::path& file, const std::filesystem::path& folder);

} // namespace flipbook::app
