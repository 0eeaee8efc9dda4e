// SPDX-License-Identifier: MIT
#include "app/commands/run_options.h"

#include "app/commands/outputs.h"
#include "app/commands/variants.h"
#include "app/encode/staging.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>

namespace flipbook::app {

namespace {

/// "1280x720" as the list "1280,720".
std::string comma_list(std::string text) {
  std::replace(text.begin(), text.end(), 'x', ',');
  return text;
}

render::Backend parse_backend(const std::string& name) {
  const std::array<std::string, 3> names{"auto", "osmesa", "egl"};
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw UserError("--gl " + name + ": it is auto, osmesa or egl", {}, nearest_name(name, names));
  constexpr std::array backends{render::Backend::automatic, render::Backend::osmesa, render::Backend::egl};
  return backends[static_cast<std::size_t>(at - names.begin())];
}

void report(const Summary& s) {
  for (const std::string& w : s.warnings) std::cerr << "warning: " << w << '\n';
  const double seconds = std::max(s.seconds, 1e-3);
  char text[256];
  std::snprintf(text, sizeof text, "%llu pictures in %.1f s (%.1f a second), %.2f million particle-steps/s",
                static_cast<unsigned long long>(s.pictures), s.seconds, static_cast<double>(s.pictures) / seconds,
                1e-6 * static_cast<double>(s.particle_steps) / seconds);
  std::cerr << text;
  std::cerr << "; " << s.least_steps;
  if (s.most_steps != s.least_steps) std::cerr << " to " << s.most_steps;
  std::snprintf(text, sizeof text, " steps of %.3g to %.3g s; drawn with %s\n", s.least_dt, s.most_dt,
                s.context.c_str());
  std::cerr << (s.most_steps > 0 ? text : " steps; drawn with " + s.context + "\n");
}

} // namespace

void RunOptions::describe(OptionVisitor& v) {
  v.texts("--set", sets_, "PATH=VALUE", "Give a parameter a value (flipbook list parameters); may be repeated");
  v.text("--dim", dim_, "2|3", "Dimension");
  v.text("--cells", cells_, "N[xN]", "Cells along x (and along the other axes)");
  v.text("--frames", frames_, "N", "Number of frames");
  v.text("--duration", duration_, "S", "Seconds to simulate");
  v.text("--fps", fps_, "N", "Frames in a second of video");
  v.text("--size", size_, "WxH", "Width and height of a picture in pixels");
  v.text("--precision", precision_, "single|double", "Numbers that the solvers compute with");
  v.text("--threads", threads_, "N", "How many threads compute; the pictures do not depend on it");
  v.text("--gl", gl_, "auto|osmesa|egl", "What draws");
  v.texts("-o,--output", outputs_, "X.mp4|FOLDER/",
          "A video, or a folder for PNG pictures; may be repeated (out/ if not given)");
  v.text("--save-study", save_study_, "FILE", "Write what was run as a study");
  v.flag("-q,--quiet", quiet_, "Print nothing but the paths of the results");
}

void RunOptions::apply(Study& study) const {
  struct Short {
    std::string option, path, value;
  };
  const std::array<Short, 7> all{{{"--dim", "dim", dim_},
                                  {"--cells", "grid.cells", comma_list(cells_)},
                                  {"--frames", "output.frames", frames_},
                                  {"--duration", "output.duration", duration_},
                                  {"--fps", "output.fps", fps_},
                                  {"--size", "output.size", comma_list(size_)},
                                  {"--precision", "precision", precision_}}};
  const auto change = [&](const std::string& text, const std::string& option) {
    Assignment a = parse_assignment(text, option);
    complete_cells(a, study);
    assign(study, std::move(a));
  };
  for (const std::string& text : sets_) change(text, "--set");
  for (const Short& s : all)
    if (!s.value.empty()) change(s.path + "=" + s.value, s.option);
}

SessionOptions RunOptions::session_options() const {
  SessionOptions options;
  if (!threads_.empty()) options.threads = static_cast<int>(parse_number(threads_, "--threads", 1, 1024));
  options.gl = parse_backend(gl_);
  options.quiet = quiet_;
  return options;
}

int RunOptions::make_video(Study study) const {
  const auto video = [&](const Resolved& r, const std::string& toml) {
    const std::vector<std::string> named = outputs_.empty() ? std::vector{"out/" + r.name + ".mp4"} : outputs_;
    return video_sinks(named, r, toml);
  };
  return run(
      std::move(study), [](const Resolved& r) { return Schedule::video(r.output.fps, r.scale, r.frames); }, video);
}

int RunOptions::make_stills(Study study, const std::vector<double>& times) const {
  const auto stills = [&](const Resolved& r, const std::string&) {
    const std::vector<std::string> named = outputs_.empty() ? std::vector<std::string>{"out/"} : outputs_;
    return still_sinks(named, r, times.size());
  };
  return run(
      std::move(study), [&](const Resolved& r) { return Schedule::stills(r.output.fps, r.scale, times); }, stills);
}

int RunOptions::run(Study study, const MakeSchedule& make_schedule, const MakeSinks& make_sinks) const {
  apply(study);
  const SessionOptions options = session_options();
  const Resolved resolved = resolve(study);
  const std::string toml = to_toml(study);
  if (!save_study_.empty()) write_file(save_study_, toml);
  std::vector<std::unique_ptr<Sink>> sinks = make_sinks(resolved, toml);
  std::vector<std::string> paths;
  for (const auto& sink : sinks) paths.push_back(sink->path().string());
  const Summary summary = run_session(resolved, toml, make_schedule(resolved), std::move(sinks), options);
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

} // namespace flipbook::app
