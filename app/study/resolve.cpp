// SPDX-License-Identifier: MIT
#include "app/study/resolve.h"

#include "app/study/arrangement_check.h"
#include "app/study/paths.h"
#include "app/study/titles.h"
#include "sim/scene/preset.h"
#include "sim/scene/read_reference.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipbook::app {
namespace {

template <Described T> void apply_to(T& component, std::span<const Assignment> assignments, Mistakes& mistakes) {
  for (const Assignment& a : assignments)
    if (const Refusal r = set_parameter(component, a.path, a.value); !r.message.empty())
      mistakes.add(r.message, a.where, r.nearest);
}

const std::vector<std::string> keys_of_a_study{"title", "scene", "variant", "key", "edit", "reference"},
    keys_of_a_variant{"label"};

using CheckPath = Refusal (*)(const std::string&, std::span<const std::string>);

/// Those whose path may stand here; the others are mistakes.
std::vector<Assignment> checked(std::span<const Assignment> all, CheckPath check, const std::vector<std::string>& own,
                                Mistakes& mistakes) {
  std::vector<Assignment> good;
  for (const Assignment& a : all) {
    const bool in_file = a.where.line > 0; // the command line has no other keys
    const Refusal r = check(a.path, in_file ? std::span(own) : std::span<const std::string>{});
    if (r.message.empty())
      good.push_back(a);
    else
      mistakes.add(r.message, a.where, r.nearest);
  }
  return good;
}

void resolve_variants(const Study& study, Resolved& resolved, Mistakes& mistakes) {
  for (const Variant& v : study.variants) {
    std::vector<Assignment> changes = checked(study.parameters, check_path, keys_of_a_study, mistakes);
    const auto own = checked(v.parameters, check_pane_path, keys_of_a_variant, mistakes);
    changes.insert(changes.end(), own.begin(), own.end());
    resolved.variants.push_back({v.label, make_scene(study.scene, changes, mistakes), nullptr, v.mistake});
  }
  for (const ResolvedVariant& v : resolved.variants)
    if (v.scene.settings.time.scale != resolved.variants.front().scene.settings.time.scale)
      mistakes.add("time.scale must be the same for all variants: they share their frames",
                   study.variants[static_cast<std::size_t>(&v - resolved.variants.data())].where);
}

std::vector<KeyTarget> key_targets(const Resolved& resolved) {
  std::vector<TitledPane> panes;
  for (const ResolvedVariant& v : resolved.variants) {
    Settings settings = v.scene.settings;
    panes.push_back({"", title_of(settings), parameters_of(settings)});
  }
  const std::vector<std::string> titles = pane_titles(panes);
  std::vector<KeyTarget> targets;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const ResolvedVariant& v = resolved.variants[i];
    KeyTarget target{v.scene.settings, {titles[i], panes[i].solver, v.scene.settings.transfer.name()}};
    if (!v.label.empty()) target.names.insert(target.names.begin(), v.label);
    targets.push_back(std::move(target));
  }
  return targets;
}

/// Where the last of these was given, if any was.
Location last_of(const std::vector<Assignment>& all, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const auto at = std::find_if(all.rbegin(), all.rend(), [&](auto& a) { return a.path == path; });
    if (at != all.rend()) return at->where;
  }
  return {};
}

/// The view of the scene, and over it that of the study.
void resolve_view(const Study& study, Resolved& resolved, Mistakes& mistakes) {
  std::vector<Assignment> all = checked(resolved.variants.front().scene.view, check_path, {}, mistakes);
  apply_to(resolved.view, all, mistakes);
  const std::vector<Assignment> own = checked(study.view, check_path, {}, mistakes);
  change_view(resolved.view, own, mistakes);
  all.insert(all.end(), own.begin(), own.end());
  if (const ViewMistake m = check_view(resolved.view); !m.path.empty())
    mistakes.add(m.refusal.message, last_of(all, {m.path}), m.refusal.nearest);
  if (const ArrangementMistake m = check_arrangement(resolved.view, resolved.domains()); !m.refusal.message.empty())
    mistakes.add(m.refusal.message, last_of(all, m.paths));
}

void resolve_output(const Study& study, Resolved& resolved, Mistakes& mistakes) {
  const std::vector<Assignment> all = checked(study.output, check_path, {}, mistakes);
  apply_to(resolved.output, all, mistakes);
  const Refusal r = check_output(resolved.output);
  if (r.message.empty()) return;
  mistakes.add(r.message, last_of(all, {"output.ledger"}));
}

/// Those of the scene and of the study; each must belong to a curve that there is.
void resolve_references(const Study& study, Resolved& resolved, Mistakes& mistakes) {
  std::vector<ReferenceCurve> all = resolved.variants.front().scene.references;
  if (study.references)
    for (ReferenceCurve& r : read_references(*study.references, *study.scene.files, mistakes))
      all.push_back(std::move(r));
  for (const ReferenceCurve& r : all)
    if (const Refusal wrong = check_plot(r.plot); !wrong.message.empty() && !r.plot.empty())
      mistakes.add(wrong.message, r.where, wrong.nearest);
  if (!all.empty()) resolved.references = std::make_shared<const std::vector<ReferenceCurve>>(std::move(all));
}

/// Simulated seconds from one frame to the next where the fluid notes' rule decides; 0 where it does not.
double notes_interval(const Study& study, const Resolved& resolved, Mistakes& mistakes) {
  double interval = 0;
  for (std::size_t i = 0; i < resolved.variants.size(); ++i) {
    const Settings& s = resolved.variants[i].scene.settings;
    if (s.preset != Preset::tutorial) continue;
    const double own = notes_steps_per_frame(s.time.scale / resolved.output.fps, s.time.dt) * s.time.dt;
    if (interval > 0 && own != interval)
      mistakes.add("with preset = \"tutorial\" the length of a step decides when a frame is shown: time.dt must be the "
                   "same for all variants",
                   study.variants[i].where);
    interval = own;
  }
  return interval;
}

void resolve_length(const Scene& scene, double notes, Resolved& r) {
  r.scale = notes > 0 ? notes * r.output.fps : scene.settings.time.scale;
  const double duration = r.output.duration > 0 ? r.output.duration : scene.duration;
  const double intervals = duration / r.scale * r.output.fps;
  constexpr double rounding = 1e-9; // the notes' program writes a frame at every interval that begins
  const double frames = notes > 0 ? std::ceil(intervals * (1 - rounding)) : std::round(intervals);
  constexpr double most_frames = 1e6;
  if (r.output.frames == 0 && frames > most_frames)
    throw UserError("the run would have " + std::to_string(std::llround(frames)) +
                    " frames; at most 1000000 are supported");
  r.frames = r.output.frames > 0 ? static_cast<std::uint64_t>(r.output.frames)
                                 : static_cast<std::uint64_t>(std::max(frames, 1.0));
  r.duration = r.time_of(r.frames);
}

/// The variants and the view as the edits before the present one left them.
struct Edited {
  std::vector<Settings> settings;
  render::ViewSettings view;
  std::vector<Domain> domains;

  /// Makes the change; the mistake in it, or an empty message.
  Refusal set(const Edit& edit, const SetParameter& change) {
    if (is_output(change.path)) return {change.path + " holds for the whole run: an edit cannot change it", ""};
    if (is_view(change.path)) {
      if (edit.pane > 0) return {"the panes share the view: an edit of " + change.path + " cannot name a pane", ""};
      if (Refusal r = set_parameter(view, change.path, change.value); !r.message.empty()) return r;
      if (ArrangementMistake m = check_arrangement(view, domains); m.is_of(change.path)) return m.refusal;
      ViewMistake m = check_view(view);
      return m.path == change.path ? m.refusal : Refusal{};
    }
    for (std::size_t i = 0; i < settings.size(); ++i) {
      if (edit.pane > 0 && static_cast<std::size_t>(edit.pane) != i + 1) continue;
      if (Refusal r = set_live(settings[i], change); !r.message.empty()) return r;
    }
    return {};
  }

private:
  static Refusal set_live(Settings& settings, const SetParameter& change) {
    for (const Parameter& p : parameters_of(settings))
      if (p.path == change.path && p.effect == Effect::restart) return {p.path + " cannot change during a run", ""};
    return set_parameter(settings, change.path, change.value);
  }
};

void resolve_edits(const Study& study, Resolved& resolved, Mistakes& mistakes) {
  static const std::vector<std::string> own{"t", "pane", "push", "add", "remove", "move"};
  Edited now{{}, resolved.view, resolved.domains()};
  for (const ResolvedVariant& v : resolved.variants) now.settings.push_back(v.scene.settings);
  for (const Edit& edit : study.edits) {
    Refusal refusal;
    if (const auto* change = std::get_if<SetParameter>(&edit.action)) {
      refusal = check_path(change->path, own);
      if (refusal.message.empty()) refusal = now.set(edit, *change);
    }
    if (static_cast<std::size_t>(edit.pane) > resolved.variants.size())
      refusal = {"there is no pane " + std::to_string(edit.pane) + ": the study has " +
                     std::to_string(resolved.variants.size()),
                 ""};
    if (!refusal.message.empty()) mistakes.add(refusal.message, edit.where, refusal.nearest);
    resolved.edits.push_back({frame_at(resolved, edit.t), edit.pane - 1, edit.action});
  }
}

void refuse_too_many(const Resolved& resolved) {
  const std::size_t n = resolved.variants.size();
  if (n > render::most_panes && !resolved.view.is_sheet()) throw UserError(too_many_variants(n, render::most_panes));
}

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

} // namespace

void change_view(render::ViewSettings& view, std::span<const Assignment> changes, Mistakes& mistakes) {
  const int colour_before = view.colour;
  const auto range_before = std::exchange(view.range, {0, 0});
  apply_to(view, changes, mistakes);
  const bool ranged = std::any_of(changes.begin(), changes.end(), [](auto& a) { return a.path == "view.range"; });
  if (!ranged && view.colour == colour_before) view.range = range_before;
}

std::vector<Domain> Resolved::domains() const {
  std::vector<Domain> all;
  for (const ResolvedVariant& v : variants) all.push_back(domain_of(v.scene.settings));
  return all;
}

std::uint64_t frame_at(const Resolved& resolved, double time) {
  auto k = static_cast<std::uint64_t>(std::max(0.0, std::floor(time / resolved.scale * resolved.output.fps)));
  while (k > 0 && resolved.time_of(k - 1) >= time) --k; // but for rounding
  while (resolved.time_of(k) < time) ++k;
  return k;
}

Resolved resolve(const Study& study) {
  Mistakes mistakes;
  Resolved resolved;
  resolved.name = study.name;
  if (study.variants.empty() || study.variants.size() > most_variants)
    throw UserError(too_many_variants(study.variants.size(), most_variants));
  resolve_variants(study, resolved, mistakes);
  const Scene& scene = resolved.variants.front().scene;
  resolved.title = study.title.empty() ? scene.summary : study.title;
  resolve_view(study, resolved, mistakes);
  resolve_output(study, resolved, mistakes);
  resolve_references(study, resolved, mistakes);
  mistakes.raise();
  refuse_too_many(resolved);
  const double notes = notes_interval(study, resolved, mistakes);

  resolved.timeline = Timeline(study.keys, key_targets(resolved), resolved.view, study.overridden, mistakes);
  mistakes.raise();

  resolve_length(scene, notes, resolved);
  resolve_edits(study, resolved, mistakes);
  mistakes.raise();
  return resolved;
}

Resolved resolve_unarranged(Study study) {
  const auto arranges = [](const std::string& path, const Value& value) {
    if (path == "view.layout") return value != Value(std::string("sheet")); // that one has more panes
    return path == "view.large" || path == "view.pair" || path == "view.difference";
  };
  std::erase_if(study.view, [&](const Assignment& a) { return arranges(a.path, a.value); });
  std::erase_if(study.keys, [&](const Key& k) { return arranges(k.path, k.value); });
  std::erase_if(study.edits, [&](const Edit& e) {
    const auto* change = std::get_if<SetParameter>(&e.action);
    return change && arranges(change->path, change->value);
  });
  return resolve(study);
}

void pin_keys(Study& study) {
  if (std::none_of(study.keys.begin(), study.keys.end(), [](const Key& k) { return !k.variant.empty(); })) return;
  const std::vector<KeyTarget> targets = key_targets(resolve_unarranged(study));
  for (Key& key : study.keys) {
    for (std::size_t i = 0; i < targets.size() && !key.variant.empty(); ++i)
      if (targets[i].is_called(key.variant)) key.panes.push_back(static_cast<int>(i) + 1);
    key.variant.clear();
  }
}

std::vector<std::string> drop_idle_keys(Study& study, const Resolved& resolved) {
  const std::vector<std::size_t>& idle = resolved.timeline.idle();
  if (idle.empty()) return {};
  const Key first = study.keys[idle.front()];
  for (std::size_t i = idle.size(); i-- > 0;)
    study.keys.erase(study.keys.begin() + static_cast<std::ptrdiff_t>(idle[i]));
  return {counted(idle.size(), "key does", "keys do") + " nothing in these panes, the first on " + first.path +
          " at t = " + to_toml(Value(first.t)) + " s"};
}

std::vector<std::string> late_keys(const Study& study, const Resolved& resolved) {
  const double last = resolved.time_of(resolved.frames - 1);
  const auto late = std::find_if(study.keys.begin(), study.keys.end(), [&](const Key& k) { return k.t > last; });
  if (late == study.keys.end()) return {};
  return {counted(static_cast<std::size_t>(study.keys.end() - late), "key comes", "keys come") +
          " after the end of the run at " + to_toml(Value(resolved.duration)) + " s, the first on " +
          (late->path.empty() ? "\"" + late->label + "\"" : late->path) + " at t = " + to_toml(Value(late->t)) + " s"};
}

} // namespace flipbook::app
