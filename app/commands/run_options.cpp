// SPDX-License-Identifier: MIT
#include "app/commands/run_options.h"

#include "app/commands/outputs.h"
#include "app/commands/variants.h"
#include "app/encode/staging.h"
#include "app/study/memory.h"
#include "app/study/with_mistake.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <thread>

namespace flipbook::app {

namespace {

/// "1280x720" as the numbers 1280 and 720; a single number as itself.
Value parse_extent(const std::string& text, const std::string& option, const std::string& wanted) {
  std::vector<double> numbers;
  std::string word;
  for (const char c : text + "x") {
    if (c != 'x' && c != 'X' && c != ',') {
      word += c;
      continue;
    }
    const bool digits = !word.empty() && word.size() < 10 &&
                        std::all_of(word.begin(), word.end(), [](char d) { return d >= '0' && d <= '9'; });
    if (!digits) throw UserError(option + " " + text + ": it is " + wanted);
    numbers.push_back(std::stod(word));
    word.clear();
  }
  return numbers.size() == 1 ? Value(numbers.front()) : Value(numbers);
}

const std::array<std::string, 3> backends{"auto", "osmesa", "egl"};

render::Backend parse_backend(const std::string& name) {
  const auto at = std::find(backends.begin(), backends.end(), name);
  if (at == backends.end())
    throw UserError("--gl " + name + ": it is auto, osmesa or egl", {}, nearest_name(name, backends));
  constexpr std::array all{render::Backend::automatic, render::Backend::osmesa, render::Backend::egl};
  return all[static_cast<std::size_t>(at - backends.begin())];
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& w : warnings) std::cerr << "warning: " << w << '\n';
}

/// "pane 2 makes a mistake on purpose"
std::string panes_with_mistake(const Resolved& r) {
  std::string panes;
  bool several = false;
  for (std::size_t i = 0; i < r.variants.size(); ++i) {
    if (!r.variants[i].mistake) continue;
    several = !panes.empty();
    panes += (several ? ", " : "") + std::to_string(i + 1);
  }
  return (several ? "panes " : "pane ") + panes + (several ? " make" : " makes") + " a mistake on purpose";
}

std::string folder_of(const std::string& file) {
  return std::filesystem::absolute(file).parent_path().string();
}

/// "12 steps of 0.01 to 0.02 s", "10 to 14 steps of ..."
std::string steps_of(const Summary& s) {
  std::string text = std::to_string(s.least_steps);
  if (s.most_steps != s.least_steps) text += " to " + std::to_string(s.most_steps);
  if (s.most_steps == 0) return text + " steps";
  char length[64];
  std::snprintf(length, sizeof length, " of %.3g to %.3g s", s.least_dt, s.most_dt);
  return text + (s.most_steps == 1 ? " step" : " steps") + length;
}

void report(const Summary& s) {
  print_warnings(s.warnings);
  const double seconds = std::max(s.seconds, 1e-3);
  char text[256];
  std::snprintf(text, sizeof text, "%llu %s%s in %.1f s (%.1f a second)", static_cast<unsigned long long>(s.pictures),
                s.context.empty() ? "frame" : "picture", s.pictures == 1 ? "" : "s", s.seconds,
                static_cast<double>(s.pictures) / seconds);
  std::cerr << text;
  if (s.particle_steps > 0) { // else nothing was simulated
    std::snprintf(text, sizeof text, ", %.2f million particle-steps/s",
                  1e-6 * static_cast<double>(s.particle_steps) / seconds);
    std::cerr << text << "; " << steps_of(s);
  }
  std::cerr << (s.context.empty() ? "\n" : "; drawn with " + s.context + "\n");
}

} // namespace

/// What changes the study.
void RunOptions::describe_run(OptionVisitor& v) {
  v.texts("--set", sets_, {"PATH=VALUE", Argument::Kind::assignment},
          "Give a parameter a value (flipbook list parameters); may be repeated");
  v.text("--dim", dim_, one_of({"2", "3"}), "Dimension; one scene serves both");
  v.text("--cells", cells_, "N[xN[xN]]", "Cells along x; those along y and z follow, as cells are cubic, or are given");
  v.text("--fps", fps_, "N", "Frames in a second of video");
  v.text("--size", size_, "WxH", "Width and height of a picture in pixels");
  v.text("--precision", precision_, one_of({"single", "double"}), "Numbers that the solvers compute with");
}

void RunOptions::describe_machine(OptionVisitor& v) {
  v.text("--threads", threads_, "N", "How many threads compute; the pictures do not depend on it");
  v.text("--gl", gl_, one_of({backends.begin(), backends.end()}),
         "What draws; auto if not given: the first that works");
}

void RunOptions::describe_live(OptionVisitor& v) {
  describe_run(v);
  describe_machine(v);
  v.texts("-o,--output", outputs_, {"FOLDER", Argument::Kind::folder},
          "Where recordings, snapshots and studies go (out if not given)");
}

void RunOptions::describe_stages(OptionVisitor& v) {
  describe_run(v);
  v.text("--threads", threads_, "N", "How many threads compute; the pictures do not depend on it");
  v.texts("-o,--output", outputs_, {"X.png|X.mp4|FOLDER/", Argument::Kind::file},
          "A sheet of all stages (also .pdf, .svg), a video, or a folder for a picture of each; may be repeated");
  v.text("--with-mistake", mistake_, {"NAME|mystery:N", Argument::Kind::mistake},
         "Beside each pane the same with a classic mistake (flipbook list mistakes)");
}

std::string RunOptions::folder() const {
  if (outputs_.size() > 1) throw UserError("-o: a live session has one folder");
  return outputs_.empty() ? "out" : outputs_.front();
}

void RunOptions::describe(OptionVisitor& v, const std::string& outputs) {
  describe_run(v);
  v.text("--frames", frames_, "N", "Number of frames");
  v.text("--duration", duration_, "S", "Seconds to simulate");
  describe_machine(v);
  v.texts("-o,--output", outputs_, {outputs, Argument::Kind::file},
          (outputs.find(".mp4") != std::string::npos ? "A video (" + video_extensions() + "), its subtitles (.vtt)"
                                                     : "A single picture") +
              ", or a folder for PNG pictures; may be repeated (out/ if not given)");
  if (outputs.find(".mp4") != std::string::npos) {
    std::vector<std::string> formats;
    for (const Option& o : particle_format_options()) formats.emplace_back(o.name);
    v.text("--particles", particles_, {"FOLDER", Argument::Kind::folder},
           "Write the particles of every frame there; without -o nothing is drawn");
    v.text("--particle-format", particle_format_, one_of(formats), "Format of these files");
    v.text("--ledger", ledger_, {"FILE.csv", Argument::Kind::file},
           "Write what every stage changed as a table; without -o nothing is drawn");
  }
  v.text("--save-study", save_study_, {"FILE", Argument::Kind::file}, "Write what was run as a study");
  v.text("--with-mistake", mistake_, {"NAME|mystery:N", Argument::Kind::mistake},
         "Beside each pane the same with a classic mistake (flipbook list mistakes)");
  v.flag("-q,--quiet", quiet_, "Print nothing but the paths of the results");
}

std::vector<Assignment> RunOptions::changes() const {
  std::vector<Assignment> all;
  for (const std::string& text : sets_) all.push_back(parse_assignment(text, "--set"));
  const auto add = [&](const std::string& option, const std::string& path, Value value) {
    all.push_back({path, std::move(value), {option, 0, 0}});
  };
  if (!dim_.empty()) add("--dim", "dim", parse_value(dim_));
  if (!cells_.empty())
    add("--cells", "grid.cells", parse_extent(cells_, "--cells", "N, NxN or NxNxN, for example 128x64"));
  if (!frames_.empty()) add("--frames", "output.frames", parse_number(frames_, "--frames", 1, 1e6));
  if (!duration_.empty()) add("--duration", "output.duration", parse_number(duration_, "--duration", 1e-6, 1e6));
  if (!fps_.empty()) add("--fps", "output.fps", parse_value(fps_));
  if (!size_.empty())
    add("--size", "output.size", parse_extent(size_, "--size", "WxH in pixels, for example 1280x720"));
  if (!precision_.empty()) add("--precision", "precision", precision_);
  if (!particle_format_.empty()) {
    if (particles_.empty()) throw UserError("--particle-format belongs to --particles");
    add("--particle-format", "output.particle_format", particle_format_);
  }
  return all;
}

Study RunOptions::applied_to(Study study) const {
  std::vector<Assignment> all = changes();
  if (!all.empty()) {
    try {
      pin_keys(study);
    } catch (const UserError&) { // the study has mistakes, which may be what the options put right
    }
  }
  for (Assignment& a : all) {
    complete_cells(a, study);
    assign(study, std::move(a));
  }
  return study;
}

SessionOptions RunOptions::session_options() const {
  SessionOptions options;
  options.threads = parse_threads(threads_);
  options.gl = parse_backend(gl_);
  options.quiet = quiet_;
  return options;
}

/// What is asked for is known without simulating.
bool RunOptions::only_subtitles(const Resolved& r) const {
  const auto is_vtt = [](const std::string& name) { return name.ends_with(".vtt"); };
  return !outputs_.empty() && std::all_of(outputs_.begin(), outputs_.end(), is_vtt) && particles_.empty() &&
         ledger_.empty() && r.output.ledger.empty();
}

int RunOptions::make_video(Study study) const {
  const auto video = [&](const Resolved& r, const std::string& toml) {
    const bool tables_only = outputs_.empty() && !(particles_.empty() && ledger_.empty());
    return video_sinks(outputs_.empty() && !tables_only ? std::vector{"out/" + r.name + ".mp4"} : outputs_, r, toml);
  };
  const auto schedule = [&](const Resolved& r) {
    return only_subtitles(r) ? Schedule::stills(r.output.fps, r.scale, {})
                             : Schedule::video(r.output.fps, r.scale, r.frames);
  };
  return run(std::move(study), schedule, video, true);
}

int RunOptions::make_stills(Study study, const std::vector<double>& times) const {
  const auto stills = [&](const Resolved& r, const std::string&) {
    const std::vector<std::string> named = outputs_.empty() ? std::vector<std::string>{"out/"} : outputs_;
    return still_sinks(named, r, times.size());
  };
  return run(
      std::move(study), [&](const Resolved& r) { return Schedule::stills(r.output.fps, r.scale, times); }, stills,
      false);
}

/// What the option names, or else the study.
std::unique_ptr<LedgerFile> RunOptions::ledger_file(const Resolved& resolved) const {
  if (!ledger_.empty()) return std::make_unique<LedgerFile>(ledger_, "--ledger", resolved);
  if (!resolved.output.ledger.empty())
    return std::make_unique<LedgerFile>(resolved.output.ledger, "output.ledger", resolved);
  return nullptr;
}

int RunOptions::run(Study study, const MakeSchedule& make_schedule, const MakeSinks& make_sinks, bool video) const {
  (void)session_options(); // their mistakes come before the work
  std::optional<museum::Choice> mistake;
  if (!mistake_.empty()) mistake = museum::parse_choice(mistake_);
  const Resolved resolved = resolve(mistake ? with_mistake(study, *mistake) : study);
  const std::string head = mistake ? mistake_header(*mistake) : "";
  refuse_too_large(resolved);
  std::vector<std::string> warnings = drop_idle_keys(study, resolved);
  if (mistake) warnings.insert(warnings.begin(), panes_with_mistake(resolved));
  if (video)
    for (std::string& w : late_keys(study, resolved)) warnings.push_back(std::move(w));
  for (std::string& w : long_run(resolved)) warnings.push_back(std::move(w));
  const std::string toml = head + to_toml(study);
  if (!save_study_.empty()) write_file(save_study_, head + to_toml(for_folder(study, folder_of(save_study_))));
  Outputs outputs{make_sinks(resolved, toml), nullptr, video ? ledger_file(resolved) : nullptr};
  if (!particles_.empty())
    outputs.particles = std::make_unique<SeriesWriter>(particles_, resolved,
                                                       head + to_toml(for_folder(study, folder_of(particles_ + "/"))));
  return finish(resolved, toml, make_schedule(resolved), std::move(outputs), warnings);
}

int RunOptions::finish(const Resolved& resolved, const std::string& toml, const Schedule& schedule, Outputs outputs,
                       const std::vector<std::string>& warnings) const {
  std::vector<std::string> paths;
  for (const auto& sink : outputs.pictures) paths.push_back(sink->path().string());
  if (outputs.particles) paths.push_back(outputs.particles->folder().string());
  if (outputs.ledger) paths.push_back(outputs.ledger->file().string());
  if (!quiet_) print_warnings(warnings);
  const Summary summary = run_session(resolved, toml, schedule, std::move(outputs), session_options());
  if (!quiet_) report(summary);
  for (const std::string& path : paths) std::cout << path << '\n';
  return 0;
}

double parse_number(const std::string& text, const std::string& option, double lo, double hi) {
  const Value value = parse_value(text);
  const double* x = std::get_if<double>(&value);
  if (!x || !(*x >= lo && *x <= hi))
    throw UserError(option + " " + text + ": it is a number from " + to_toml(Value(lo)) + " to " + to_toml(Value(hi)));
  return *x;
}

int parse_threads(const std::string& text) {
  if (text.empty()) return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return static_cast<int>(parse_number(text, "--threads", 1, 1024));
}

} // namespace flipbook::app
