// SPDX-License-Identifier: MIT
// Text becomes part of a page. Everything that comes from studies, figures and files goes through escape().
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flipbook::app::gallery {

/// For the content of an element and for an attribute between double quotes. Control characters, which no page may
/// hold, become spaces; bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string escape(std::string_view text);

/// "a_b%20c.mp4": a relative address of a file in a folder; `file` is a path with / between its parts.
[[nodiscard]] std::string address(std::string_view file);

/// The text with @NAME@ replaced, once each and in one pass: what is filled in is never looked at again. Throws
/// std::logic_error for a mark that is not given, as that is a mistake in the page's files.
[[nodiscard]] std::string fill(std::string_view text,
                               const std::vector<std::pair<std::string_view, std::string>>& marks);

/// As a shell reads it back: quoted where it must be.
[[nodiscard]] std::string shell_word(const std::string& word);
[[nodiscard]] std::string shell_command(const std::vector<std::string>& words);

/// "data:video/mp4;base64,...": the whole file. Throws UserError for one that cannot be read.
[[nodiscard]] std::string data_uri(const std::filesystem::path& file);

/// What a browser calls a file of this ending.
[[nodiscard]] std::string_view media_type(std::string_view file);

} // namespace flipbook::app::gallery
