// SPDX-License-Identifier: MIT
// flipbook new scene|study|scheme NAME: a commented file to start from, which runs as it is.
#include "app/commands/command.h"
#include "app/commands/new_scheme.h"
#include "app/commands/text_output.h"
#include "app/encode/staging.h"
#include "app/study/relative_path.h"
#include "app/study/study.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

struct What {
  const char *name, *folder, *run;
};
constexpr std::array<What, 2> kinds{{{"scene", "scenes", "compare"}, {"study", "studies", "render"}}};

/// Letters, digits, '_', '-', '.' and what UTF-8 has beyond ASCII: a name that needs no quotes in any shell.
bool is_sensible(const std::string& name) {
  const auto fine = [](char c) {
    return static_cast<unsigned char>(c) >= 0x80 || std::string_view("_-.").find(c) != std::string_view::npos ||
           (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  constexpr std::size_t longest = 100;
  return !name.empty() && name.size() <= longest && name[0] != '-' && name[0] != '.' &&
         std::all_of(name.begin(), name.end(), fine);
}

class New final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"WHAT", Argument::Kind::choice, {"scene", "study", "scheme"}}, what_, "scene, study or scheme");
    v.positional("NAME", name_, "What it is called; the file is NAME.toml, or of a scheme NAME.h");
    v.text("--scene", scene_, {"SCENE", Argument::Kind::scene},
           "The scene of a study: a name or a path; dam_break if not given");
    v.text(
        "-o,--output", output_, {"FILE|FOLDER/", Argument::Kind::file},
        "Where to write it; the current folder if not given, for a scheme sim/transfer/ of the source tree around it");
    v.flag("--force", force_, "Replace a file that is there");
  }

  int run() override {
    if (what_ == "scheme") {
      if (!scene_.empty()) throw UserError("--scene belongs to flipbook new study");
      if (force_) throw UserError("--force belongs to flipbook new scene and study: a scheme replaces no file");
      new_scheme(name_, output_);
      return 0;
    }
    const What& kind = chosen();
    if (name_.ends_with(".toml")) name_.resize(name_.size() - 5);
    if (!is_sensible(name_)) throw UserError("\"" + name_ + "\" is no name for a file: use letters, digits, _ - and .");
    if (!scene_.empty() && what_ != "study") throw UserError("--scene belongs to flipbook new study");
    const fs::path file = toml_path(output_, name_);
    const std::string text = filled(kind, file);
    refuse_to_replace(file, force_);
    write_file(file, text);
    std::cout << file.string() << '\n';
    report(kind, file.string());
    return 0;
  }

private:
  [[nodiscard]] const What& chosen() const {
    std::vector<std::string> names;
    for (const What& k : kinds) {
      if (what_ == k.name) return k;
      names.emplace_back(k.name);
    }
    names.emplace_back("scheme");
    throw UserError("new makes a scene, a study or a scheme, not \"" + what_ + "\"", {}, nearest_name(what_, names));
  }

  /// The scene as the study must call it: the path of a file is relative to the study's.
  [[nodiscard]] std::string scene_for(const fs::path& file) const {
    const std::string scene = scene_.empty() ? "dam_break" : scene_;
    (void)load_scene(scene); // says which name is near
    if (!is_path(scene) || fs::path(scene).is_absolute()) return scene;
    return relative_path(scene, fs::absolute(file).parent_path());
  }

  [[nodiscard]] std::string filled(const What& kind, const fs::path& file) const {
    const auto path = find_asset("templates", kind.name);
    if (!path) throw MachineError(std::string("templates/") + kind.name + ".toml is missing where the scenes are");
    std::string text = read_text_file(*path);
    const auto quoted = [](const std::string& s) { return to_toml(Value(s)); };
    if (what_ == "study") replace_all(text, "\"@SCENE@\"", quoted(scene_for(file)));
    replace_all(text, "@NAME@", name_);
    replace_all(text, "@FILE@", file.stem());
    return text;
  }

  void report(const What& kind, const std::string& file) const {
    const std::vector<std::string> names = list_assets(kind.folder);
    if (std::find(names.begin(), names.end(), name_) != names.end())
      std::cerr << "note: there is a " << kind.name << " called " << name_ << " already; yours is meant by " << file
                << " only\n";
    std::cerr << "try: flipbook " << kind.run << ' ' << file << '\n';
  }

  std::string what_, name_, scene_, output_;
  bool force_ = false;
};

} // namespace

std::unique_ptr<Command> make_new() {
  return std::make_unique<New>();
}

} // namespace flipbook::app
