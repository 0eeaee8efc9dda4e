// SPDX-License-Identifier: MIT
// Where scenes and studies are found by name: $FLIPBOOK_ASSETS, the share/flipbook folder beside the installed program,
// the source tree that it was built from. The first that has the name wins.
#pragma once

#include "sim/frame/errors.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook {

/// A path ("a/b.toml", "b.toml") as given, relative to `base` if it is not empty; or a name in `folder` ("scenes").
/// Nothing if there is no such file.
[[nodiscard]] std::optional<std::string> find_asset(std::string_view folder, const std::string& name_or_path,
                                                    const std::string& base = {});

/// The file of this name ("martin_moyce.csv") in `folder` ("reference") of the assets. Nothing if there is none.
[[nodiscard]] std::optional<std::string> find_asset_file(std::string_view folder, const std::string& name);

/// Was a path given, rather than a name?
[[nodiscard]] bool is_path(const std::string& name_or_path);

/// A file that a scene names at `where`: relative to the scene's file, else by its last part beside that file (scene
/// and data were moved to one folder), else by its last part in `folder` ("particles") of the assets. Throws UserError
/// with the paths that were tried.
[[nodiscard]] std::string find_input(std::string_view folder, const std::string& written, const Location& where);

/// Every name in `folder`, sorted.
[[nodiscard]] std::vector<std::string> list_assets(std::string_view folder);

/// "dam_break" of "assets/scenes/dam_break.toml".
[[nodiscard]] std::string stem(const std::string& path);

} // namespace flipbook
