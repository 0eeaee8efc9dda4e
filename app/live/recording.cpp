// SPDX-License-Identifier: MIT
#include "app/live/recording.h"

#include "app/encode/png.h"
#include "app/encode/staging.h"
#include "app/encode/video.h"
#include "app/panel/panel.h"
#include "app/session/compose.h"

#include <array>
#include <cstdio>

namespace flipbook::app::live {

namespace fs = std::filesystem;

namespace {

std::unique_ptr<Sink> make_sink(const fs::path& file, const std::string& kind, const Take& take) {
  const OutputSettings& o = take.resolved.output;
  if (kind == "png") return png_sequence(file);
  return video_file(file, {.width = o.size[0],
                           .height = o.size[1],
                           .fps = o.fps,
                           .crf = o.crf,
                           .title = take.resolved.title,
                           .comment = ""}); // the study is not known before the end: it goes beside
}

Picture draw(const LiveFrame& frame, const std::string& study, render::Renderer& renderer) {
  const Resolved& resolved = frame.take->resolved;
  const render::Frame composed = compose(resolved, frame.bundle, frame.warnings);
  return {renderer.draw(composed, frame.bundle.view),
          provenance_of(describe_run(resolved, study), frame.bundle.stop, composed)};
}

std::string numbered(const std::string& study, int n) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "_live_%03d", n);
  return study + number.data();
}

Study for_this_folder(const Study& study, const fs::path& folder) {
  return for_folder(study, fs::absolute(folder).string());
}

} // namespace

std::string free_name(const fs::path& folder, const std::string& study) {
  std::error_code none;
  for (int n = 1;; ++n) {
    const std::string name = numbered(study, n);
    bool taken = false;
    for (const char* ending : {"", ".toml", ".mp4", ".png"})
      taken = taken || fs::exists(folder / (name + ending), none);
    if (!taken) return name;
  }
}

Recording::Recording(const fs::path& folder, const std::string& kind, const Take& take, render::Context& context,
                     const render::Workers& workers, Budget& budget)
    : folder_(folder), stem_(free_name(folder, take.study.name)), kind_(kind),
      name_(stem_ + (kind == "png" ? "" : ".mp4")), budget_(budget),
      renderer_(context, take.resolved.output.size[0], take.resolved.output.size[1], make_panel(), workers),
      sink_(make_sink(folder / name_, kind, take), budget, failure_) {}

void Recording::add(const LiveFrame& frame) {
  auto picture = std::make_shared<Picture>();
  {
    const Budget::Permit permit(budget_, true);
    *picture = draw(frame, frame.study, renderer_);
  }
  sink_.put(std::move(picture));
  failure_.rethrow();
  ++frames_;
}

void Recording::finish(const Study& study) {
  sink_.drain();
  failure_.rethrow();
  sink_.sink().commit();
  write_file(folder_ / (stem_ + ".toml"), to_toml(for_this_folder(study, folder_)));
}

std::string write_snapshot(const fs::path& folder, const LiveFrame& frame, const Study& study, render::Context& context,
                           const render::Workers& workers) {
  const auto& size = frame.take->resolved.output.size;
  render::Renderer renderer(context, size[0], size[1], make_panel(), workers);
  const std::string name = free_name(folder, frame.take->study.name) + ".png";
  const auto fixed = [&](const Provenance&) { return name; };
  const auto sink = png_files(folder, fixed, name);
  sink->write(draw(frame, to_toml(study), renderer));
  sink->finish();
  sink->commit();
  return name;
}

std::string write_study(const fs::path& folder, const Study& study) {
  const std::string name = free_name(folder, study.name) + ".toml";
  write_file(folder / name, to_toml(for_this_folder(study, folder)));
  return name;
}

} // namespace flipbook::app::live
