// SPDX-License-Identifier: MIT
#include "app/study/timeline.h"

#include "app/study/arrangement_check.h"
#include "app/study/paths.h"
#include "sim/frame/text.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {
namespace {

constexpr double travel = 0.6; // seconds of video that the pointer takes to a widget
constexpr int whole_view = -1; // stands for the view where a variant is meant otherwise
constexpr double press = 0.1;  // it holds the widget a little longer than the widget moves

double smooth(double s) {
  return s * s * (3 - 2 * s);
}

double progress(Ease ease, double t, double over, double time) {
  if (time < t) return 0;
  if (over <= 0 || ease == Ease::step || time >= t + over) return 1;
  const double s = (time - t) / over;
  return ease == Ease::linear ? s : smooth(s);
}

/// As people read it: without the quotes of TOML.
std::string plain(const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text ? *text : to_toml(value);
}

Value rounded(Value value, Kind kind) {
  if (kind == Kind::integer) value = std::round(std::get<double>(value));
  if (kind == Kind::integers)
    for (double& x : std::get<std::vector<double>>(value)) x = std::round(x);
  return value;
}

} // namespace

bool KeyTarget::is_called(const std::string& name) const {
  return std::any_of(names.begin(), names.end(), [&](const std::string& n) { return same_word(n, name); });
}

struct Timeline::Run {
  std::span<const KeyTarget> variants;
  std::vector<Settings> state;
  render::ViewSettings view_at_start, view;
  bool lenient;
  std::size_t index = 0; ///< of the present key

  [[nodiscard]] std::vector<Domain> domains() const {
    std::vector<Domain> all;
    for (const KeyTarget& v : variants) all.push_back(domain_of(v.settings));
    return all;
  }
  /// The variants that a key names, or all of them.
  [[nodiscard]] std::vector<std::size_t> named(const Key& key, Mistakes& mistakes) const {
    std::vector<std::size_t> chosen;
    std::vector<std::string> known;
    for (const int pane : key.panes) {
      if (pane >= 1 && static_cast<std::size_t>(pane) <= variants.size())
        chosen.push_back(static_cast<std::size_t>(pane) - 1);
      else if (!lenient)
        mistakes.add("there is no variant " + std::to_string(pane) + ": the study has " +
                         std::to_string(variants.size()),
                     key.where);
    }
    if (!key.panes.empty()) return chosen;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const auto& names = variants[i].names;
      known.insert(known.end(), names.begin(), names.end());
      if (key.variant.empty() || variants[i].is_called(key.variant)) chosen.push_back(i);
    }
    if (chosen.empty() && !lenient)
      mistakes.add("no variant is called \"" + key.variant + "\"", key.where, nearest_name(key.variant, known));
    return chosen;
  }
};

Timeline::Timeline(std::span<const Key> keys, std::span<const KeyTarget> variants, const render::ViewSettings& view,
                   bool lenient, Mistakes& mistakes) {
  Run run{variants, {}, view, view, lenient};
  for (const KeyTarget& v : variants) run.state.push_back(v.settings);
  static const std::vector<std::string> own{"t", "over", "ease", "variant", "label"};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Key& key = keys[i];
    run.index = i;
    if (key.path.empty())
      say(key.t, key.label, true);
    else if (const Refusal r = check_path(key.path, own); !r.message.empty())
      mistakes.add(r.message, key.where, r.nearest);
    else if (is_output(key.path))
      mistakes.add(key.path + " holds for the whole run: a key cannot change it", key.where);
    else if (is_view(key.path))
      add_to_view(key, run, mistakes);
    else
      add(key, run, mistakes);
  }
}

void Timeline::extend(Track& track, const Key& key, const Value& from, const Value& to) {
  auto& all = track.segments;
  const bool moving = !all.empty() && key.t < all.back().t + all.back().over;
  all.push_back({key.t, key.over, key.ease, moving ? at(track, key.t) : from, to});
}

void Timeline::add_to_view(const Key& key, Run& run, Mistakes& mistakes) {
  if (!key.variant.empty() || !key.panes.empty())
    return mistakes.add("the panes share the view: a key on " + key.path + " cannot name a variant", key.where);
  const auto now = [&] {
    const std::vector<Parameter> all = parameters_of(run.view);
    return *std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.path == key.path; });
  };
  const Parameter before = now();
  if (const Refusal r = set_parameter(run.view, key.path, key.value); !r.message.empty())
    return mistakes.add(r.message, key.where, r.nearest);
  if (const ViewMistake m = check_view(run.view); m.path == key.path)
    return mistakes.add(m.refusal.message, key.where, m.refusal.nearest);
  if (const ArrangementMistake m = check_arrangement(run.view, run.domains()); m.is_of(key.path))
    return mistakes.add(m.refusal.message, key.where);
  Track& t = track(whole_view, before);
  extend(t, key, before.value, now().value);
  tell(key, run, {{t.segments.back(), whole_view}});
  if (before.level == Level::teach) grips_.push_back({key.t, key.over, key.path, whole_view}); // its row is shown
  if (key.path == "view.colour") free_range(key, run);
}

/// A range belongs to the quantity that it was written for: another one gets its own from the data, unless the same key
/// says it.
void Timeline::free_range(const Key& key, Run& run) {
  const auto range = [](render::ViewSettings view) {
    const std::vector<Parameter> all = parameters_of(view);
    return *std::find_if(all.begin(), all.end(), [](const Parameter& p) { return p.path == "view.range"; });
  };
  Track& t = track(whole_view, range(run.view_at_start));
  if (!t.segments.empty() && t.segments.back().t == key.t) return;
  const Value before = range(run.view).value;
  run.view.range = run.view.colour == run.view_at_start.colour ? run.view_at_start.range : std::array<double, 2>{0, 0};
  Key change = key; // when the colour changes, which is no number and does so at the end of its move
  change.t = key.ease == Ease::step ? key.t : key.t + key.over;
  change.over = 0;
  extend(t, change, before, range(run.view).value);
}

void Timeline::add(const Key& key, Run& run, Mistakes& mistakes) {
  const std::vector<std::size_t> chosen = run.named(key, mistakes);
  std::vector<std::size_t> moved;
  std::vector<Move> moves;
  for (const std::size_t i : chosen) {
    const std::vector<Parameter> all = parameters_of(run.state[i]);
    const auto p = std::find_if(all.begin(), all.end(), [&](const Parameter& q) { return q.path == key.path; });
    if (p != all.end() && p->effect == Effect::restart)
      return mistakes.add(key.path + " cannot change during a run", key.where);
    if (p != all.end() && !p->applies) continue;
    if (const Refusal r = set_parameter(run.state[i], key.path, key.value); !r.message.empty())
      return mistakes.add(r.message, key.where, r.nearest);
    if (const auto c = run.state[i].conflict(); !c.message.empty()) return mistakes.add(c.message, key.where);
    Track& t = track(static_cast<int>(i), *p);
    // The value as it is stored: a list of two becomes a list of three, a name gets its own case.
    const std::vector<Parameter> now = parameters_of(run.state[i]);
    const auto stored = std::find_if(now.begin(), now.end(), [&](const Parameter& q) { return q.path == key.path; });
    extend(t, key, p->value, stored->value);
    moved.push_back(i);
    moves.push_back({t.segments.back(), static_cast<int>(i)});
  }
  if (moved.empty() && run.lenient) idle_.push_back(run.index);
  if (moved.empty() && !chosen.empty() && !run.lenient)
    mistakes.add("no variant uses " + key.path + " at t = " + to_toml(Value(key.t)), key.where);
  tell(key, run, moves);
  const bool shared = moved.size() == run.state.size();
  if (shared)
    grips_.push_back({key.t, key.over, key.path, -1});
  else
    for (const std::size_t i : moved) grips_.push_back({key.t, key.over, key.path, static_cast<int>(i)});
}

/// "FLIP 0.97: flip_ratio 0.97 → 0", a line for each value that it comes from; without names where all move alike.
void Timeline::tell(const Key& key, const Run& run, const std::vector<Move>& moves) {
  if (moves.empty()) return;
  if (!key.label.empty()) return say(key.t, key.label, true);
  const std::string name = key.path.substr(key.path.rfind('.') + 1);
  std::vector<std::pair<std::string, std::string>> said; // the values, and who makes this move
  for (const Move& m : moves) {
    const std::string values = plain(m.segment.from) + " \u2192 " + plain(m.segment.to);
    const std::string who =
        m.variant == whole_view ? "" : run.variants[static_cast<std::size_t>(m.variant)].names.front();
    const auto same = std::find_if(said.begin(), said.end(), [&](auto& s) { return s.first == values; });
    if (same == said.end())
      said.emplace_back(values, who);
    else
      same->second += ", " + who;
  }
  const bool alike = said.size() == 1 && (moves.size() == run.variants.size() || moves.front().variant == whole_view);
  for (const auto& [values, who] : said) say(key.t, (alike ? "" : who + ": ") + name + " " + values, false);
}

/// Once, where several parameters of a key move.
void Timeline::say(double t, const std::string& line, bool label) {
  if (told_.empty() || told_.back().t != t) told_.push_back({t, {}, {}});
  Told& now = told_.back();
  if (std::find(now.lines.begin(), now.lines.end(), line) != now.lines.end()) return;
  now.lines.push_back(line);
  if (label) now.label = line;
}

std::string Timeline::label(double time) const {
  std::string label;
  for (const Told& told : told_)
    if (told.t <= time && !told.label.empty()) label = told.label;
  return label;
}

bool Timeline::has_labels() const {
  return std::any_of(told_.begin(), told_.end(), [](const Told& t) { return !t.label.empty(); });
}

Timeline::Track& Timeline::track(int variant, const Parameter& parameter) {
  for (Track& t : tracks_)
    if (t.variant == variant && t.path == parameter.path) return t;
  return tracks_.emplace_back(Track{variant, parameter.path, parameter.kind, parameter.value, {}});
}

Value Timeline::at(const Track& track, double time) {
  const Segment* now = nullptr;
  for (const Segment& s : track.segments)
    if (s.t <= time) now = &s;
  if (!now) return track.initial;
  return rounded(blend(now->from, now->to, progress(now->ease, now->t, now->over, time)), track.kind);
}

Value Timeline::value(int variant, const std::string& path, double time, const Value& initial) const {
  for (const Track& t : tracks_)
    if (t.variant == variant && t.path == path) return at(t, time);
  return initial;
}

render::ViewSettings Timeline::view(double time, const render::ViewSettings& initial) const {
  render::ViewSettings view = initial;
  for (const Track& t : tracks_)
    if (t.variant == whole_view) (void)set_parameter(view, t.path, at(t, time)); // checked when it was added
  return view;
}

bool Timeline::moves(const std::string& path) const {
  return std::any_of(tracks_.begin(), tracks_.end(), [&](const Track& t) { return t.path == path; });
}

/// Those of `other` that are not in the list yet.
static void merge(std::vector<std::string>& list, const std::vector<std::string>& other) {
  for (const std::string& name : other)
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
}

void merge(FrameRequest& request, const FrameRequest& other) {
  merge(request.channels, other.channels);
  merge(request.fields, other.fields);
  request.surface = request.surface || other.surface;
  request.cells = request.cells || other.cells;
  request.trails = std::max(request.trails, other.trails);
  request.faces = request.faces || other.faces;
  request.phi = request.phi || other.phi;
  request.pressure = request.pressure || other.pressure;
  request.noise = request.noise || other.noise;
}

FrameRequest Timeline::request(const render::ViewSettings& initial) const {
  FrameRequest all;
  // What is published depends on choices and flags, and those only change where a move begins or ends.
  for (const render::ViewSettings& v : views(initial)) merge(all, v.request());
  return all;
}

std::vector<render::ViewSettings> Timeline::views(const render::ViewSettings& initial) const {
  std::vector<render::ViewSettings> all{initial};
  for (const Track& t : tracks_)
    for (const Segment& s : t.segments)
      if (t.variant == whole_view)
        for (const double time : {s.t, s.t + s.over}) all.push_back(view(time, initial));
  return all;
}

CommandLog Timeline::commands(double fps, double scale, std::uint64_t frames) const {
  CommandLog log;
  std::vector<Value> last;
  for (const Track& t : tracks_) last.push_back(t.initial);
  for (std::uint64_t k = 0; k < frames && !tracks_.empty(); ++k) {
    const double time = static_cast<double>(k) * scale / fps;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      Value now = at(tracks_[i], time);
      if (now == last[i] || tracks_[i].variant == whole_view) continue;
      last[i] = now;
      log.push_back({k, tracks_[i].variant, SetParameter{tracks_[i].path, std::move(now)}});
    }
  }
  return log;
}

std::vector<render::PointerTarget> Timeline::pointer_targets(double time, double scale) const {
  std::vector<render::PointerTarget> targets;
  for (const Grip& g : grips_) {
    // Seconds of video since the grip began and until it ends; both positive while it lasts.
    const double before = (time - g.t) / scale + press, after = (g.t + g.over - time) / scale + press;
    const double away = std::max({-before, -after, 0.0});
    const double grip = smooth(std::max(0.0, 1 - away / travel));
    const auto same = std::find_if(targets.begin(), targets.end(),
                                   [&](auto& t) { return t.path == g.path && t.variant == g.variant; });
    if (same == targets.end())
      targets.push_back({g.path, g.variant, grip, away == 0});
    else
      same->grip = std::max(same->grip, grip), same->pressed = same->pressed || away == 0;
  }
  std::stable_sort(targets.begin(), targets.end(), [](auto& a, auto& b) { return a.grip > b.grip; });
  return targets;
}

} // namespace flipbook::app
