// SPDX-License-Identifier: MIT
#include "app/live/take.h"

#include "app/study/memory.h"
#include "app/study/paths.h"

#include <algorithm>

namespace flipbook::app::live {

namespace {

void put(std::vector<Assignment>& all, const std::string& path, const Value& value) {
  std::erase_if(all, [&](const Assignment& a) { return a.path == path; });
  all.push_back({path, value, {}});
}

} // namespace

std::shared_ptr<const Take> make_take(Study study, std::string kind, std::uint64_t number) {
  auto take = std::make_shared<Take>();
  take->number = number;
  take->kind = std::move(kind);
  study.edits.clear();
  pin_keys(study);
  study.overridden = true; // what a restart changes may leave keys without use
  take->resolved = resolve(study);
  put(study.view, "view.pointer", false);
  put(study.view, "view.steady", true);
  if (take->resolved.view.time_axis <= 0) put(study.view, "view.time_axis", take->resolved.duration);
  // A ledger's file is for videos: no study that is opened here may name one.
  std::erase_if(study.output, [](const Assignment& a) { return a.path == "output.ledger"; });
  take->resolved = resolve(study);
  refuse_too_large(take->resolved);
  (void)drop_idle_keys(study, take->resolved);
  take->study = std::move(study);
  return take;
}

Study study_of(const Take& take, const CommandLog& log, std::uint64_t frame) {
  Study study = take.study;
  for (const Command& c : log)
    if (c.frame <= frame) study.edits.push_back({take.resolved.time_of(c.frame), c.variant + 1, c.action});
  std::erase_if(study.output, [](const Assignment& a) { return a.path == "output.duration"; });
  put(study.output, "output.frames", static_cast<double>(frame + 1));
  return study;
}

Study study_of_picture(const Take& take, const CommandLog& log, std::uint64_t frame) {
  const auto late = [&](const Command& c) {
    const auto* change = std::get_if<SetParameter>(&c.action);
    return c.frame == frame && change && is_view(change->path);
  };
  CommandLog earlier = log;
  std::erase_if(earlier, [&](const Command& c) { return c.frame >= frame; });
  for (const Command& c : log)
    if (late(c) && frame > 0) earlier.push_back({frame - 1, c.variant, c.action});
  Study study = study_of(take, earlier, frame);
  for (const Command& c : log)
    if (late(c) && frame == 0) begin_with(study, -1, std::get<SetParameter>(c.action));
  return study;
}

void begin_with(Study& study, int pane, const SetParameter& change) {
  if (is_view(change.path)) {
    if (change.path == "view.colour") std::erase_if(study.view, [](auto& a) { return a.path == "view.range"; });
    return put(study.view, change.path, change.value);
  }
  if (pane >= 0) return put(study.variants[static_cast<std::size_t>(pane)].parameters, change.path, change.value);
  for (Variant& v : study.variants) std::erase_if(v.parameters, [&](auto& a) { return a.path == change.path; });
  put(study.parameters, change.path, change.value);
}

Study restarted(const Take& take, const CommandLog& log) {
  Study study = take.study;
  for (const Command& c : log)
    if (const auto* change = std::get_if<SetParameter>(&c.action)) begin_with(study, c.variant, *change);
  return study;
}

} // namespace flipbook::app::live
