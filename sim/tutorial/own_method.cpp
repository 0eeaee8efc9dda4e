// SPDX-License-Identifier: MIT
#include "sim/tutorial/own_method.h"

#include "sim/scene/preset.h"
#include "sim/tutorial/notes_grid.h"

namespace flipbook {
namespace {

/// From metres above the corner of what runs to world coordinates.
void shift(std::vector<float>& x, std::size_t axis, double by) {
  for (std::size_t i = axis; i < x.size(); i += 3) x[i] = static_cast<float>(static_cast<double>(x[i]) + by);
}

void shift(Channel& c, double by) {
  for (float& value : c.values) value = static_cast<float>(static_cast<double>(value) + by);
  c.lo += by;
  c.hi += by;
}

} // namespace

Scene without_solid_layer(const Scene& scene) {
  const NotesGrid notes(scene.settings.grid);
  Scene inner = scene;
  inner.settings.preset = Preset::none;
  for (std::size_t a = 0; a < 3; ++a) {
    inner.settings.grid.cells[a] = notes.res[a] - 2;
    inner.settings.grid.size[a] = (notes.res[a] - 2) * notes.h;
    inner.settings.grid.origin[a] = notes.lc[a] + notes.h;
  }
  return inner;
}

OwnMethod::OwnMethod(const Settings& shown, std::unique_ptr<Simulation> runs) : shown_(shown), runs_(std::move(runs)) {}

std::vector<Parameter> OwnMethod::parameters() const {
  Settings settings = shown_;
  return parameters_of(settings);
}

Refusal OwnMethod::set(std::string_view path, const Value& value) {
  for (const Parameter& p : parameters())
    if (p.path == path && p.effect == Effect::restart) return {p.path + " cannot change during a run", ""};
  if (Refusal r = runs_->set(path, value); !r.message.empty()) return r;
  return set_parameter(shown_, path, value);
}

std::string OwnMethod::title() const {
  return title_of(shown_);
}

std::shared_ptr<const Snapshot> OwnMethod::snapshot(std::uint64_t frame, const FrameRequest& request) {
  auto s = std::make_shared<Snapshot>(*runs_->snapshot(frame, request));
  const NotesGrid notes(shown_.grid);
  s->title = title();
  s->parameters = parameters();
  s->notes.insert(s->notes.begin(), "The fluid notes have no " + shown_.transfer.title() +
                                        ": Flipbook's method runs there, on the same particles.");
  s->lo = notes.lc;
  s->hi = notes.uc;
  s->cells = notes.res;
  constexpr std::string_view axes = "xyz";
  for (std::size_t a = 0; a < 3; ++a) {
    const double by = notes.lc[a] + notes.h;
    shift(s->x, a, by);
    for (Channel& c : s->channels)
      if (c.name == std::string("initial_") + axes[a]) shift(c, by);
    for (LatticeData& l : s->lattices) l.origin[a] = static_cast<float>(static_cast<double>(l.origin[a]) + by);
  }
  return s;
}

} // namespace flipbook
