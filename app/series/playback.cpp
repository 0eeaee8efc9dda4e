// SPDX-License-Identifier: MIT
#include "app/series/playback.h"

#include "app/series/drawable_rows.h"
#include "app/series/solid_places.h"
#include "sim/core/vec.h"
#include "sim/files/surface_ply.h"
#include "sim/frame/curves.h"
#include "sim/frame/errors.h"
#include "sim/frame/particle_order.h"
#include "sim/frame/trails.h"
#include "sim/scene/read_scene.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace flipbook::app {

namespace {

using Point3 = std::array<float, 3>;

/// Where each particle was when it was first seen, by id. Ids are the file's: they may be any numbers.
class FirstPlaces {
public:
  /// Takes those in that are new; `x(i)` is the place of particle i.
  template <class Place> void add(const std::vector<std::uint32_t>& ids, Place&& x) {
    const std::size_t known = places_.size();
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (!find(ids[i], known)) places_.emplace_back(ids[i], x(i));
    if (places_.size() == known) return;
    const auto by_id = [](const Entry& a, const Entry& b) { return a.first < b.first; };
    std::stable_sort(places_.begin(), places_.end(), by_id);
  }
  [[nodiscard]] Point3 of(std::uint32_t id) const { return find(id, places_.size())->second; }

private:
  using Entry = std::pair<std::uint32_t, Point3>;
  [[nodiscard]] const Entry* find(std::uint32_t id, std::size_t among) const {
    if (id < among && places_[id].first == id) return &places_[id]; // 0, 1, 2, ...
    const auto end = places_.begin() + static_cast<std::ptrdiff_t>(among);
    const auto at = std::lower_bound(places_.begin(), end, id, [](const Entry& e, auto i) { return e.first < i; });
    return at != end && at->first == id ? &*at : nullptr;
  }

  std::vector<Entry> places_;
};

/// The magnitude as the solver would have computed it, with the numbers that it computed with.
template <int Dim, class Real> float speed(const std::array<double, 3>& v) {
  Vec<Dim, Real> u;
  for (int d = 0; d < Dim; ++d) u[d] = static_cast<Real>(v[static_cast<std::size_t>(d)]);
  return static_cast<float>(u.norm());
}

float speed(const std::array<double, 3>& v, const SeriesVariant& variant) {
  if (variant.dim == 2) return variant.single ? speed<2, float>(v) : speed<2, double>(v);
  return variant.single ? speed<3, float>(v) : speed<3, double>(v);
}

class Playback final : public Simulation {
public:
  explicit Playback(std::shared_ptr<const Recording> recording) : recording_(std::move(recording)) {
    set_parameters(recording_->variant.parameters);
    for (const SolidPlaces& p : recording_->variant.places)
      for (const StandingSolid& s : p.solids)
        if (auto& surface = surfaces_[s.id]; !surface)
          surface = std::make_shared<TriangleMesh>(
              read_surface((recording_->folder / solid_file(s.id)).string(), recording_->variant.origin));
  }

  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] std::uint64_t steps() const override { return 0; }
  [[nodiscard]] double max_dt() const override { return std::numeric_limits<double>::infinity(); }
  void step(double dt) override { time_ += dt; }

  [[nodiscard]] std::vector<Parameter> parameters() const override { return {}; }
  [[nodiscard]] Refusal set(std::string_view path, const Value&) override {
    return {std::string(path) + " cannot change: the particles are read from files", ""};
  }

  [[nodiscard]] std::string title() const override { return title_; }
  [[nodiscard]] std::size_t particles() const override { return 0; } // none of them takes a step
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t frame, const FrameRequest& request) override;
  [[nodiscard]] ParticleTable particle_table() const override {
    throw UserError("the particles of a series are in files already");
  }

private:
  void set_parameters(const std::vector<Assignment>& changes) {
    if (changes.empty()) return;
    has_parameters_ = true;
    Mistakes mistakes;
    apply(settings_, changes, mistakes);
    mistakes.raise();
  }
  void describe(std::uint64_t frame, Snapshot& s);
  void place(const ParticleRows& rows, Snapshot& s) const;
  [[nodiscard]] Channel channel(const std::string& name, const ParticleRows& rows, const Snapshot& s);

  std::shared_ptr<const Recording> recording_;
  std::string title_ = recording_->variant.title;
  Settings settings_;
  bool has_parameters_ = false;
  std::size_t next_change_ = 0;
  double time_ = 0;
  std::map<std::uint32_t, std::shared_ptr<const TriangleMesh>> surfaces_; ///< by id
  FirstPlaces first_places_;
  ChannelRanges ranges_;
  Trails trails_;
};

void Playback::describe(std::uint64_t frame, Snapshot& s) {
  const SeriesVariant& v = recording_->variant;
  for (; next_change_ < v.changes.size() && v.changes[next_change_].frame <= frame; ++next_change_) {
    set_parameters(v.changes[next_change_].parameters);
    title_ = v.changes[next_change_].title;
  }
  s.title = title_;
  s.scheme = v.scheme;
  s.kernel = v.kernel;
  s.solver = v.solver;
  s.notes = v.notes;
  s.watermark = v.watermark;
  s.time_unit = v.time_unit;
  if (has_parameters_) s.parameters = parameters_of(settings_);
  s.frame = frame;
  s.time = recording_->times[frame];
  s.steps = v.steps.empty() ? 0 : v.steps[frame];
  s.dt = v.dt.empty() ? 0 : v.dt[frame];
  s.dim = v.dim;
  s.lo = v.lo;
  for (std::size_t a = 0; a < 3; ++a) s.hi[a] = v.lo[a] + v.size[a];
  s.cells = v.cells;
  s.dx = v.dx;
  s.periodic = v.periodic;
  s.up = v.up;
  s.particle_spacing = v.particle_spacing;
  for (const StandingSolid& solid : solids_at(v.places, frame))
    s.solids.push_back({surfaces_.at(solid.id), solid.pose, solid.id});
}

void Playback::place(const ParticleRows& rows, Snapshot& s) const {
  const auto dim = static_cast<std::size_t>(s.dim);
  s.x.resize(dim * rows.size());
  s.v.resize(dim * rows.size());
  std::array<double, 3> shift = recording_->variant.origin;
  for (std::size_t a = 0; a < 3; ++a) shift[a] -= recording_->variant.lo[a];
  for (std::size_t p = 0; p < rows.size(); ++p)
    for (std::size_t d = 0; d < dim; ++d) {
      s.x[dim * p + d] = static_cast<float>(rows.x[p][d] - shift[d]);
      s.v[dim * p + d] = static_cast<float>(rows.v[p][d]);
    }
  s.id = rows.id;
  if (!s.id.empty()) return;
  s.id.resize(rows.size()); // a file without ids: its rows are always the same particles
  std::iota(s.id.begin(), s.id.end(), 0U);
}

Channel Playback::channel(const std::string& name, const ParticleRows& rows, const Snapshot& s) {
  const auto dim = static_cast<std::size_t>(s.dim), axis = static_cast<std::size_t>(name.back() - 'x');
  Channel c{name, name.starts_with("initial_") ? "m" : "m/s", 0, 0, name.starts_with("velocity_"), {}};
  c.values.resize(s.particles());
  for (std::size_t p = 0; p < c.values.size(); ++p) {
    if (name == "speed")
      c.values[p] = speed(rows.v[p], recording_->variant);
    else if (name == "id")
      c.values[p] = static_cast<float>(s.id[p]);
    else if (name.starts_with("initial_"))
      c.values[p] = first_places_.of(s.id[p])[axis];
    else
      c.values[p] = s.v[dim * p + axis];
  }
  if (name == "id") c.unit = "";
  ranges_.widen(c);
  return c;
}

std::shared_ptr<const Snapshot> Playback::snapshot(std::uint64_t frame, const FrameRequest& request) {
  auto s = std::make_shared<Snapshot>();
  describe(frame, *s);
  const ParticleRows rows = read_drawable(recording_->files[frame], true);
  place(rows, *s);
  const std::vector<std::string> known = recorded_channels(s->dim);
  for (const std::string& name : request.channels) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UserError("unknown particle quantity \"" + name + "\"", {}, nearest_name(name, known));
    if (name.starts_with("initial_"))
      first_places_.add(s->id, [&](std::size_t p) {
        Point3 x{0, 0, 0};
        std::copy_n(s->x.begin() + static_cast<std::ptrdiff_t>(p) * s->dim, s->dim, x.begin());
        return x;
      });
    s->channels.push_back(channel(name, rows, *s));
  }
  sort_particles(*s);
  trails_.follow(*s, request.trails);
  return s;
}

} // namespace

std::unique_ptr<Simulation> play(std::shared_ptr<const Recording> recording) {
  return std::make_unique<Playback>(std::move(recording));
}

std::vector<std::string> recorded_channels(int dim) {
  std::vector<std::string> all{"speed"};
  for (const std::string before : {"velocity_", "initial_"})
    for (int a = 0; a < dim; ++a) all.push_back(before + "xyz"[a]);
  all.emplace_back("id");
  return all;
}

} // namespace flipbook::app
