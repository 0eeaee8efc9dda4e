// SPDX-License-Identifier: MIT
// Where the commands that write scenes and studies put them.
#pragma once

#include <filesystem>
#include <string>

namespace flipbook::app {

/// NAME.toml in the current folder, in the folder that -o names, or the file that it names. Throws UserError for a name
/// that is neither a folder's nor ends in .toml.
[[nodiscard]] std::filesystem::path toml_path(const std::string& output, const std::string& name);

/// Throws UserError where something is there already, unless it shall be replaced.
void refuse_to_replace(const std::filesystem::path& file, bool force);

/// Puts `by` in the place of every `mark`.
void replace_all(std::string& text, const std::string& mark, const std::string& by);

} // namespace flipbook::app
