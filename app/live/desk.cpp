// SPDX-License-Identifier: MIT
#include "app/live/desk.h"

#include "app/live/told.h"

#include <cstdio>

namespace flipbook::app::live {

Desk::Desk(std::string folder, render::Context& context, const render::Workers& workers, Budget& budget,
           Simulator& simulator, std::function<void(const std::string&)> tell)
    : folder_(std::move(folder)), context_(context), workers_(workers), budget_(budget), simulator_(simulator),
      tell_(std::move(tell)) {}

void Desk::begin(const std::string& kind) {
  const LiveStatus status = simulator_.status();
  if (recording_ || !status.take) return;
  try {
    recording_ = std::make_unique<Recording>(folder_, kind, *status.take, context_, workers_, budget_);
    simulator_.record(true);
  } catch (const std::exception& e) {
    failed(e.what());
  }
}

void Desk::write_recorded() {
  const auto frame = simulator_.take_recorded();
  if (!frame || !recording_) return;
  try {
    recording_->add(*frame);
  } catch (const std::exception& e) {
    recording_.reset();
    simulator_.record(false);
    failed(std::string("the recording ended: ") + e.what());
  }
}

void Desk::take(const Report& r) {
  try {
    if (r.what == Report::What::save) saved("study", write_study(folder_, *r.study));
    if (r.what == Report::What::picture)
      saved("snapshot", write_snapshot(folder_, *r.frame, *r.study, context_, workers_));
    if (r.what == Report::What::recorded) end(*r.study);
  } catch (const std::exception& e) {
    failed(e.what());
  }
}

void Desk::end(const Study& study) {
  if (!recording_) return;
  const auto recording = std::move(recording_);
  recording->finish(study);
  const std::size_t n = recording->frames();
  saved("recording", recording->name(), std::to_string(n) + (n == 1 ? " frame" : " frames"));
}

void Desk::saved(const std::string& kind, const std::string& name, const std::string& more) {
  const std::string text =
      "Saved " + (std::filesystem::path(folder_) / name).string() + (more.empty() ? "" : " (" + more + ")");
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
  tell_(tell_saved(kind, name, text));
}

void Desk::failed(const std::string& why) {
  std::fprintf(stderr, "flipbook: %s\n", why.c_str());
  tell_(tell_message("error", why));
}

} // namespace flipbook::app::live
