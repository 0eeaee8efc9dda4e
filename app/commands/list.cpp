// SPDX-License-Identifier: MIT
// flipbook list WHAT: every name that a study or an option may use.
#include "app/commands/command.h"
#include "app/encode/video.h"
#include "app/figures/spec.h"
#include "app/study/paths.h"
#include "app/study/study.h"
#include "render/chart/rich_text.h"
#include "render/view_settings.h"
#include "sim/files/read_mesh.h"
#include "sim/files/read_particles.h"
#include "sim/files/write_particles.h"
#include "sim/frame/errors.h"
#include "sim/kernels/kernels.h"
#include "sim/materials/material_settings.h"
#include "sim/museum/museum.h"
#include "sim/scene/read_scene.h"
#include "sim/scene/read_shape.h"
#include "sim/transfer/schemes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

namespace flipbook::app {

namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Columns padded to their widest entry; the last one is not.
void print(const Rows& rows) {
  std::vector<std::size_t> width;
  for (const auto& row : rows)
    for (std::size_t c = 0; c + 1 < row.size(); ++c) {
      width.resize(std::max(width.size(), c + 1));
      width[c] = std::max(width[c], row[c].size());
    }
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += c + 1 < row.size() ? row[c] + std::string(width[c] + 2 - row[c].size(), ' ') : row[c];
    std::cout << line << '\n';
  }
}

/// Cut at an entry so that one parameter does not spread the table; `list views` has the whole lists.
std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 36;
  if (text.size() <= longest) return text;
  return text.substr(0, text.find_last_of("|,", longest - 4) + 1) + " ...";
}

/// "0 to 1 m", "quadratic | cubic", ...
std::string values(const Parameter& p) {
  std::string text;
  for (const std::string& o : p.options) text += (text.empty() ? "" : "|") + o;
  if (p.kind == Kind::flag) return "true|false";
  if (!p.options.empty() || p.kind == Kind::text || p.kind == Kind::names) return text;
  const bool below = std::isfinite(p.min), above = std::isfinite(p.max);
  if (below && above) text = to_toml(Value(p.min)) + " to " + to_toml(Value(p.max));
  if (below && !above) text = "at least " + to_toml(Value(p.min));
  if (!below && above) text = "at most " + to_toml(Value(p.max));
  return p.unit.empty() ? text : text + (text.empty() ? "" : " ") + p.unit;
}

void list_parameters() {
  Rows rows{{"PATH", "DEFAULT", "VALUES", "WHEN", "MEANING"}};
  for (const Parameter& p : known_parameters())
    rows.push_back({p.path, shortened(to_toml(p.value)), shortened(values(p)),
                    p.effect == Effect::live ? "live" : "start", p.help});
  print(rows);
}

/// What a scene is beyond water in a plane: "3D, obstacles". Only its text is looked at, not the files that it names.
std::string kind_of(const Node& scene) {
  std::string kind;
  const auto add = [&](bool holds, const char* word) {
    kind += holds ? (kind.empty() ? "" : ", ") + std::string(word) : "";
  };
  const Node* dim = scene.find("dim");
  add(dim && dim->number == 3, "3D");
  add(scene.find("obstacle") != nullptr, "obstacles");
  add(scene.find("particles") != nullptr, "particles from a file");
  return kind;
}

void list_scene_names() {
  Rows rows;
  for (const std::string& name : list_scenes()) {
    const Node scene = load_scene(name).table;
    const Node* summary = scene.find("summary");
    const std::string kind = kind_of(scene);
    rows.push_back({name, (summary ? summary->text : "") + (kind.empty() ? "" : " (" + kind + ")")});
  }
  print(rows);
}

void list_study_names() {
  Rows rows;
  for (const std::string& name : list_studies()) rows.push_back({name, read_study(name).title});
  print(rows);
}

void list_schemes() {
  Rows rows;
  for (const SchemeInfo& s : scheme_infos())
    rows.push_back(
        {std::string(s.name) + (s.first ? "[:" + s.first->path.substr(s.first->path.rfind('.') + 1) + "]" : ""),
         std::string(s.label), std::string(s.summary)});
  print(rows);
}

void list_materials() {
  Rows rows;
  for (const MaterialInfo& m : material_infos())
    rows.push_back({std::string(m.name), std::string(m.label), std::string(m.summary)});
  print(rows);
}

void list_kernels() {
  Rows rows;
  for (const Option& k : kernel_options()) rows.push_back({std::string(k.name), std::string(k.help)});
  print(rows);
}

void list_shape_names() {
  Rows rows;
  for (const ShapeInfo& s : list_shapes())
    rows.push_back({std::string(s.name), std::string(s.keys), std::string(s.help)});
  print(rows);
}

/// What goes in and out as files, and how a study or the command line names it.
void list_formats() {
  Rows rows{{"WHAT", "FORMAT", "WHERE", "MEANING"}};
  for (const Option& o : particle_input_options())
    rows.push_back({"particles in", std::string(o.name), "[[particles]] file =", std::string(o.help)});
  for (const Option& o : particle_format_options())
    rows.push_back({"particles out", std::string(o.name), "--particle-format", std::string(o.help)});
  for (const std::string_view extension : mesh_extensions)
    rows.push_back({"meshes in", std::string(extension.substr(1)), "shape = \"mesh\"", "Closed triangle meshes"});
  for (const VideoFormat& f : video_formats()) {
    const std::string extension(f.extension);
    rows.push_back({"pictures out", extension.substr(1), "-o X" + extension, std::string(f.help)});
  }
  rows.push_back({"pictures out", "png", "-o FOLDER/", "A picture for each frame, which carries its study"});
  rows.push_back({"subtitles", "vtt", "-o X.vtt", "What the keys of the timeline do (WebVTT)"});
  print(rows);
}

/// What can be drawn: the options of the view's choices.
void list_views() {
  render::ViewSettings view;
  Rows rows;
  for (const Parameter& p : parameters_of(view))
    for (std::size_t i = 0; i < p.options.size(); ++i)
      rows.push_back({p.path, p.options[i], i < p.option_help.size() ? p.option_help[i] : ""});
  print(rows);
}

void list_commands() {
  Rows rows;
  for (const CommandEntry& c : commands()) rows.push_back({c.name, c.summary});
  print(rows);
}

void list_mistakes() {
  Rows rows{{"NAME", "SHOWN BY", "WHAT IS WRONG"}};
  for (const museum::Exhibit& e : museum::exhibits())
    rows.push_back({std::string(e.name), std::string(e.shows), std::string(e.wrong)});
  rows.push_back({"mystery:N", "the ledger, or a curve", "One of them, which is not told: --reveal N tells."});
  print(rows);
}

/// The mistakes in the order in which mystery:N tries them, up to the first that can act in any run.
void reveal(const std::string& number) {
  const museum::Choice choice = museum::parse_choice("mystery:" + number);
  std::cout << choice.option() << " is the first of these that can act in one of the panes:\n";
  Rows rows;
  for (const std::size_t i : choice.candidates) {
    const museum::Exhibit& e = museum::exhibits()[i];
    rows.push_back({std::string(e.name), std::string(e.wrong)});
    if (e.anywhere) break;
  }
  print(rows);
}

void list_figure_names() {
  Rows rows;
  for (const std::string& name : list_figures())
    rows.push_back({name, render::plain_text(read_figure(name, false).claim)});
  print(rows);
}

struct Subject {
  const char* name;
  void (*print)();
};
constexpr std::array<Subject, 12> subjects{{{"scenes", list_scene_names},
                                            {"studies", list_study_names},
                                            {"figures", list_figure_names},
                                            {"schemes", list_schemes},
                                            {"kernels", list_kernels},
                                            {"materials", list_materials},
                                            {"shapes", list_shape_names},
                                            {"formats", list_formats},
                                            {"mistakes", list_mistakes},
                                            {"parameters", list_parameters},
                                            {"views", list_views},
                                            {"commands", list_commands}}};

std::vector<std::string> subject_names() {
  std::vector<std::string> names;
  for (const Subject& s : subjects) names.emplace_back(s.name);
  return names;
}

class List final : public Command {
public:
  void options(OptionVisitor& v) override {
    std::string help;
    for (const Subject& s : subjects)
      help += (help.empty() ? "" : &s == &subjects.back() ? " or " : ", ") + std::string(s.name);
    v.positional({"WHAT", Argument::Kind::choice, subject_names()}, what_, help);
    v.text("--reveal", reveal_, "N", "With mistakes: which one is mystery:N");
  }
  int run() override {
    if (!reveal_.empty()) {
      if (what_ != "mistakes") throw UserError("--reveal belongs to flipbook list mistakes");
      return reveal(reveal_), 0;
    }
    for (const Subject& s : subjects)
      if (what_ == s.name) return s.print(), 0;
    throw UserError("there is no list of \"" + what_ + "\"", {}, nearest_name(what_, subject_names()));
  }

private:
  std::string what_, reveal_;
};

} // namespace

std::unique_ptr<Command> make_list() {
  return std::make_unique<List>();
}

} // namespace flipbook::app
