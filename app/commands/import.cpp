// SPDX-License-Identifier: MIT
// flipbook import FILE.json: the input of the fluid notes' program as a scene, and as a study of several schemes.
#include "app/commands/command.h"
#include "app/commands/text_output.h"
#include "app/encode/staging.h"
#include "app/import/notes_json.h"
#include "app/import/notes_scene.h"
#include "app/study/relative_path.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"
#include "sim/scene/read_scene.h"
#include "sim/simulation.h"

#include <iostream>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

class Import final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"FILE.json", Argument::Kind::file}, file_, "Input of the fluid notes' program");
    v.text("-o,--output", output_, {"SCENE.toml|FOLDER/", Argument::Kind::file},
           "Where the scene goes; FILE.toml in the current folder if not given");
    v.text("--preset", preset_, {"tutorial", Argument::Kind::choice, {"tutorial"}},
           "Run the notes' own algorithm, step for step, instead of Flipbook's method");
    v.flag("--study", study_, "Also write a study beside the scene: PIC, the file's FLIP, FLIP 1 and APIC");
    v.flag("--force", force_, "Replace files that are there");
  }

  int run() override {
    if (!preset_.empty() && preset_ != "tutorial")
      throw UserError("--preset " + preset_ + ": it is tutorial", {}, nearest_name(preset_, preset_names_));
    const NotesJson notes = read_notes_json(file_);
    const std::string particles = particles_of(notes);
    const fs::path scene = toml_path(output_, stem(file_));
    const fs::path study = fs::path(scene).replace_filename(scene.stem().string() + "_study.toml");
    refuse_to_replace(scene, force_);
    if (study_) refuse_to_replace(study, force_);

    const std::string called = relative_path(particles, fs::absolute(scene).parent_path());
    const std::shared_ptr<const ParticleRows> rows = checked_particles(notes, particles);
    for (const std::string& warning : notes.warnings) std::cerr << "warning: " << warning << '\n';
    const bool preset = !preset_.empty();
    write_file(scene, notes_scene(notes, called, particles_per_axis(notes, *rows), preset));
    if (study_) write_file(study, notes_study(notes, scene.filename().string(), preset));
    report(rows->size(), scene.string(), study.string());
    return 0;
  }

private:
  /// The particles, if the notes' program could start with them: a scene that is written can be run.
  static std::shared_ptr<const ParticleRows> checked_particles(const NotesJson& notes, const std::string& particles) {
    const std::string absolute = fs::absolute(particles).string();
    Mistakes mistakes;
    SceneText text{"", parse_toml(notes_scene(notes, absolute, 2, true), notes.file)};
    const Scene scene = make_scene(text, {}, mistakes);
    mistakes.raise();
    check_scene(scene);
    return scene.particles.front().rows;
  }

  void report(std::size_t particles, const std::string& scene, const std::string& study) const {
    std::cout << scene << '\n';
    if (study_) std::cout << study << '\n';
    std::cerr << particles << " particles\n";
    std::cerr << "try: flipbook render " << (study_ ? study : scene) << '\n';
  }

  std::string file_, output_, preset_;
  bool study_ = false, force_ = false;
  const std::vector<std::string> preset_names_{"tutorial"};
};

} // namespace

std::unique_ptr<Command> make_import() {
  return std::make_unique<Import>();
}

} // namespace flipbook::app
