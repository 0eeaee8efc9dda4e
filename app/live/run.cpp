// SPDX-License-Identifier: MIT
#include "app/live/run.h"

#include "app/session/apply_command.h"
#include "app/session/make_variants.h"
#include "app/study/paths.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app::live {
namespace {

constexpr double fastest_hand = 4;     // of the domain's shortest side, a second
constexpr double fastest_solid = 0.04; // of it, a frame: what is dragged follows a quick hand as it can

/// The vector, no longer than `most`.
Triple limited(Triple v, double most) {
  const double length = std::hypot(v[0], v[1], v[2]);
  if (length > most)
    for (double& x : v) x *= most / length;
  return v;
}

/// Frames in which keys may do something.
std::uint64_t frames_with_keys(const Take& take) {
  double last = 0;
  for (const Key& k : take.study.keys) last = std::max(last, k.t + k.over);
  return take.study.keys.empty() ? 0 : frame_at(take.resolved, last) + 2;
}

} // namespace

Simulator::Run::Run(std::shared_ptr<const Take> t, Pool& pool)
    : take(std::move(t)), view_(take->resolved), differences_(take->resolved.timeline.views(take->resolved.view)),
      timeline_(
          take->resolved.timeline.commands(take->resolved.output.fps, take->resolved.scale, frames_with_keys(*take))) {
  variants = make_variants(take->resolved, pool);
  apply_timeline();
}

// === Time

bool Simulator::Run::advance(const std::function<bool()>& stop) {
  if (!variants->advance_to(take->resolved.time_of(frame + 1), stop)) return false;
  ++frame;
  apply_timeline();
  return true;
}

void Simulator::Run::apply_timeline() {
  for (; next_ < timeline_.size() && timeline_[next_].frame <= frame; ++next_)
    must_apply(timeline_[next_], *variants, "timeline: ");
}

// === A hand

bool Simulator::Run::needs_restart(const std::string& path) const {
  const std::vector<Parameter> all = (*variants)[0].parameters();
  return std::any_of(all.begin(), all.end(),
                     [&](const Parameter& p) { return p.path == path && p.effect == Effect::restart; });
}

/// Where one of several panes refuses, the log says which have it.
Refusal Simulator::Run::apply(int variant, const CommandAction& action) {
  const Command command{frame, variant, action};
  const std::vector<int> panes = panes_of(command, *variants);
  CommandLog done;
  Refusal refusal;
  for (const int pane : panes) {
    Command one{frame, pane, action};
    if (Refusal r = apply_command(one, *variants); r.message.empty())
      done.push_back(std::move(one));
    else
      refusal = std::move(r);
  }
  if (panes.empty()) return apply_command(command, *variants);
  if (done.size() == panes.size()) done = {command};
  log.insert(log.end(), done.begin(), done.end());
  return refusal;
}

Refusal Simulator::Run::set_view(const SetParameter& change) {
  render::ViewSettings view = view_.at(time());
  if (Refusal r = set_parameter(view, change.path, change.value); !r.message.empty()) return r;
  if (const ViewMistake m = check_view(view); m.path == change.path) return m.refusal;
  if (ArrangementMistake m = check_arrangement(view, take->resolved.domains()); m.is_of(change.path)) return m.refusal;
  EditedView next = view_;
  next.set(change, time());
  if (next.request().channels != view_.request().channels) { // a quantity that not every solver has
    for (std::size_t i = 0; i < variants->size(); ++i) {
      try {
        if (!(*variants)[i].peek(frame, next.request()))
          return {"the panes of this solver keep the colours that they began with", ""};
      } catch (const UserError& e) {
        return {e.what(), ""};
      }
    }
  }
  view_ = std::move(next);
  const auto same = [&](const Command& c) {
    const auto* s = std::get_if<SetParameter>(&c.action);
    return s && c.frame == frame && s->path == change.path;
  };
  if (!log.empty() && same(log.back())) log.pop_back(); // a camera turns many times in a frame
  if (log.size() > 1 && log.back().frame == frame && same(log[log.size() - 2])) log.erase(log.end() - 2);
  log.push_back({frame, -1, change});
  return {};
}

std::optional<Interaction> Simulator::Run::action_of(const Hold& hand, const Triple& was, bool moving) const {
  const double over = take->resolved.time_of(1);
  Triple by{};
  for (std::size_t d = 0; d < 3; ++d) by[d] = hand.at[d] - was[d];
  switch (hand.what) {
  case Hold::What::add: return AddParticles{hand.at, hand.radius, {0, 0, 0}};
  case Hold::What::remove: return RemoveParticles{hand.at, hand.radius};
  case Hold::What::push:
    if (!moving) return std::nullopt;
    return Push{hand.at, hand.radius, limited({by[0] / over, by[1] / over, by[2] / over}, fastest_hand * hand.reach)};
  case Hold::What::solid:
    if (!moving || by == Triple{0, 0, 0}) return std::nullopt;
    return MoveSolid{hand.solid, limited(by, fastest_solid * hand.reach), over};
  }
  return std::nullopt;
}

// === Looking

LiveFrame Simulator::Run::look(Pool& pool) {
  LiveFrame f{take, {{frame, time(), true, true}, {}, view_.at(time())}, {}, ""};
  auto& snapshots = f.bundle.snapshots;
  snapshots.resize(variants->size());
  pool.each(static_cast<int>(variants->size()), [&](int i) {
    const auto v = static_cast<std::size_t>(i);
    snapshots[v] = (*variants)[v].snapshot(frame, view_.request());
  });
  differences_.add(f.bundle.view, time(), snapshots);
  f.bundle.difference = differences_.of(f.bundle.view);
  warnings_ = f.warnings = identical_.warnings(snapshots);
  return f;
}

LiveFrame Simulator::Run::picture(const LiveFrame& shown) {
  const auto has = [&](const std::string& channel) {
    return std::all_of(shown.bundle.snapshots.begin(), shown.bundle.snapshots.end(), [&](const auto& s) {
      return std::any_of(s->channels.begin(), s->channels.end(), [&](const Channel& c) { return c.name == channel; });
    });
  };
  const FrameRequest& wanted = view_.request();
  const bool enough = std::all_of(wanted.channels.begin(), wanted.channels.end(), has);
  LiveFrame f = enough ? shown : *peek(shown, false);
  f.bundle.view = view_.at(time());
  f.bundle.difference = differences_.glimpse(f.bundle.view, shown.bundle.stop.time, shown.bundle.snapshots);
  return f;
}

std::shared_ptr<const LiveFrame> Simulator::Run::peek(const LiveFrame& shown, bool on_the_way) {
  auto f = std::make_shared<LiveFrame>(shown);
  if (on_the_way) f->bundle.stop.time = (*variants)[0].time();
  f->bundle.view = view_.at(time());
  f->bundle.difference = differences_.glimpse(f->bundle.view, shown.bundle.stop.time, shown.bundle.snapshots);
  for (std::size_t i = 0; i < variants->size(); ++i) {
    const auto now = (*variants)[i].peek(frame, view_.request());
    if (!now) continue;
    auto s = std::make_shared<Snapshot>(*now);
    s->history = shown.bundle.snapshots[i]->history;
    s->ledger = shown.bundle.snapshots[i]->ledger;
    f->bundle.snapshots[i] = std::move(s);
  }
  return f;
}

LiveStatus Simulator::Run::status() {
  LiveStatus s;
  s.take = take;
  s.frame = frame;
  s.time = time();
  s.edits = log.size();
  s.solids = take->resolved.variants.front().scene.obstacles.size();
  auto all = std::make_shared<std::vector<std::vector<Parameter>>>();
  for (std::size_t i = 0; i < variants->size(); ++i) {
    s.particles += (*variants)[i].particles();
    all->push_back((*variants)[i].parameters());
  }
  s.parameters = std::move(all);
  return s;
}

} // namespace flipbook::app::live
