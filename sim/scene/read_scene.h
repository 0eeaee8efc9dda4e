// SPDX-License-Identifier: MIT
// Scenes from TOML. assets/scenes/annotated.toml documents every key.
#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/scene_files.h"

#include <span>
#include <string>
#include <vector>

namespace flipbook {

/// A scene file as it was read, before its parameters are applied.
struct SceneText {
  std::string name;
  Node table;
  std::shared_ptr<SceneFiles> files = std::make_shared<SceneFiles>(); ///< what it names, read once for all its variants
};

/// Finds a scene by name, or by its path relative to `base`. Throws UserError with the nearest name.
[[nodiscard]] SceneText load_scene(const std::string& name_or_path, const std::string& base = {});

/// The scene with `changes` applied over its own parameters; throws one UserError of all mistakes.
[[nodiscard]] Scene make_scene(const SceneText& text, std::span<const Assignment> changes = {});
/// The same, adding to `mistakes` instead.
[[nodiscard]] Scene make_scene(const SceneText& text, std::span<const Assignment> changes, Mistakes& mistakes);

/// load_scene and make_scene in one.
[[nodiscard]] Scene read_scene(const std::string& name_or_path, std::span<const Assignment> changes = {});
/// A scene from a text; `file` is named in messages and its stem is the scene's name.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& file,
                                std::span<const Assignment> changes = {});

/// The names of all scenes.
[[nodiscard]] std::vector<std::string> list_scenes();

/// Applies assignments, of which a later one of the same path wins, in the order in which the parameters are described
/// (so that a scheme is chosen before its parameters). An axis for which the last grid.cells has no entry gets cubic
/// cells.
void apply(Settings& settings, std::span<const Assignment> changes, Mistakes& mistakes);

} // namespace flipbook
