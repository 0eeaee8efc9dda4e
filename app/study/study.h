// SPDX-License-Identifier: MIT
// A study: a scene, the variants to compare, a timeline, and how it is shown. One TOML file;
// assets/studies/annotated.toml documents every key.
#pragma once

#include "app/study/edits.h"
#include "sim/museum/museum.h"
#include "sim/scene/read_scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook::app {

using flipbook::to_toml; // joined by the one for studies below

struct Variant {
  std::string label; ///< empty: the title comes from the solver
  std::vector<Assignment> parameters;
  Location where;
  std::optional<museum::Hung> mistake = std::nullopt; ///< no text can say this: see with_mistake.h
};

enum class Ease { smooth, linear, step };

/// From time t on (seconds simulated) a parameter moves to a value, within `over` seconds.
struct Key {
  double t = 0, over = 0;
  Ease ease = Ease::smooth;
  std::string variant;    ///< a label, title or scheme name
  std::vector<int> panes; ///< instead of a name: numbers from 1; neither: every variant that has the parameter
  std::string path;       ///< empty: it only has a label
  Value value;
  Location where;
  std::string label = {}; ///< what picture and subtitles say; empty: the subtitles tell the value
};

struct Study {
  std::string name; ///< for the names of outputs
  std::string title;
  SceneText scene;
  std::vector<Assignment> parameters; ///< for all variants
  std::vector<Assignment> view, output;
  std::vector<Variant> variants;
  std::vector<Key> keys;          ///< in time order
  std::vector<Edit> edits;        ///< by hand, in order
  std::optional<Node> references; ///< [[reference]], beside those of the scene
  bool overridden = false; ///< the command line changed what the keys were written for: those without use are left out
};

/// A study by name or path; a scene by name or path becomes a study of one variant. Throws UserError.
[[nodiscard]] Study read_study(const std::string& name_or_path);
[[nodiscard]] Study study_of_scene(const std::string& name_or_path);
/// From a text; `file` is named in messages, its stem is the study's name, and a scene's path is relative to it.
[[nodiscard]] Study parse_study(std::string_view text, const std::string& file);

/// A change from the command line: it overrides what the study says for all and for single variants.
void assign(Study& study, Assignment change);

/// The study as one text with what is explicit in a fixed order. It needs no other file but those of particles and
/// meshes, which it names as the scene does. Reads back to the same study.
[[nodiscard]] std::string to_toml(const Study& study);
/// The study for a text in `folder`: relative paths of the scene's files are rewritten so that they still find them.
[[nodiscard]] Study for_folder(Study study, const std::string& folder);

/// The names of all studies.
[[nodiscard]] std::vector<std::string> list_studies();

/// Of a contact sheet; other layouts show fewer (render/compose/sheet_settings.h).
inline constexpr std::size_t most_variants = 36;

/// What is said of a study with so many variants where there may be `most`.
[[nodiscard]] std::string too_many_variants(std::size_t variants, std::size_t most);

} // namespace flipbook::app
