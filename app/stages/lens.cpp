// SPDX-License-Identifier: MIT
#include "app/stages/lens.h"

#include "app/commands/variants.h"
#include "render/views/ticks.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>

namespace flipbook::app {

namespace {

/// How much of a wall is seen beside the cells, in cells.
constexpr double wall_seen = 0.3;

bool within(const render::Window& w, double x, double y) {
  return x >= w.lo[0] && x <= w.hi[0] && y >= w.lo[1] && y <= w.hi[1];
}

/// The value that nineteen in twenty do not exceed, rounded up; 1 where all are zero.
double scale_of(std::vector<double> values, double share = 0.95) {
  std::erase_if(values, [](double x) { return !(x > 0); });
  if (values.empty()) return 1;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return render::round_up(*at);
}

/// Sums over cells, as a table of sums from the lower corner on.
class SummedCells {
public:
  explicit SummedCells(const Snapshot& domain)
      : nx_(domain.cells[0]), ny_(domain.cells[1]), dx_(domain.dx), row_(static_cast<std::size_t>(nx_ + 1)),
        sum_(row_ * static_cast<std::size_t>(ny_ + 1), 0.0) {}

  void add(double x, double y, double value) {
    const auto i = std::clamp(static_cast<int>(x / dx_), 0, nx_ - 1),
               j = std::clamp(static_cast<int>(y / dx_), 0, ny_ - 1);
    sum_[static_cast<std::size_t>(i + 1) + row_ * static_cast<std::size_t>(j + 1)] += value;
    all_ += value;
  }
  [[nodiscard]] bool empty() const { return !(all_ > 0); }
  /// Where a window of w x h cells holds most: its lower corner, in cells.
  [[nodiscard]] std::array<int, 2> fullest(int w, int h) {
    for (std::size_t j = 1; j <= static_cast<std::size_t>(ny_); ++j)
      for (std::size_t i = 1; i < row_; ++i) sum(i, j) += sum(i - 1, j) + sum(i, j - 1) - sum(i - 1, j - 1);
    std::array<int, 2> best{0, 0};
    double most = -1;
    for (int j = 0; j + h <= ny_; ++j)
      for (int i = 0; i + w <= nx_; ++i) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j),
                   c = static_cast<std::size_t>(i + w), d = static_cast<std::size_t>(j + h);
        const double here = sum(c, d) - sum(a, d) - sum(c, b) + sum(a, b);
        if (here > most * (1 + 1e-9)) most = here, best = {i, j};
      }
    return best;
  }

private:
  double& sum(std::size_t i, std::size_t j) { return sum_[i + row_ * j]; }
  int nx_, ny_;
  double dx_;
  std::size_t row_;
  std::vector<double> sum_;
  double all_ = 0;
};

void add_speeds(const RecordedStep& step, SummedCells& cells) {
  const StageStill& s = step.stills.front();
  for (std::size_t p = 0; p < s.id.size(); ++p)
    cells.add(s.x[2 * p], s.x[2 * p + 1], std::hypot(s.v[2 * p], s.v[2 * p + 1]));
}

/// What the stress gives to each node.
void add_impulses(const RecordedStep& step, SummedCells& cells) {
  for (std::size_t k = 1; k < step.stills.size(); ++k) {
    const StageStill &before = step.stills[k - 1], &after = step.stills[k];
    if (after.stage != "stress") continue;
    const StageSamples &u0 = *before.find("u"), &v0 = *before.find("v"), &u = *after.find("u"), &v = *after.find("v"),
                       &m = *after.find("mass_u");
    for (std::size_t at = 0; at < u.values.size(); ++at) {
      const auto i = static_cast<int>(at) % u.n[0], j = static_cast<int>(at) / u.n[0];
      cells.add(u.origin[0] + after.dx * i, u.origin[1] + after.dx * j,
                m.values[at] * std::hypot(u.values[at] - u0.values[at], v.values[at] - v0.values[at]));
    }
  }
}

/// body(position, x, y) for the samples in the window.
template <class Body> void each_seen(const StageSamples& s, double dx, const render::Window& window, Body&& body) {
  for (int j = 0; j < s.n[1]; ++j)
    for (int i = 0; i < s.n[0]; ++i) {
      const double x = s.origin[0] + dx * i, y = s.origin[1] + dx * j;
      if (within(window, x, y)) body(static_cast<std::size_t>(i + s.n[0] * j), i, j);
    }
}

/// The numbers that the scales have to hold.
struct Seen {
  std::vector<double> velocity, change, mass, divergence, pressure, kick;

  void particles(const StageStill& s, const render::Window& window) {
    for (std::size_t p = 0; p < s.id.size(); ++p)
      if (within(window, s.x[2 * p], s.x[2 * p + 1])) velocity.push_back(std::hypot(s.v[2 * p], s.v[2 * p + 1]));
  }
  void kicks(const StageStill& before, const StageStill& after, const render::Window& window) {
    for (std::size_t p = 0; p < std::min(before.id.size(), after.id.size()); ++p)
      if (within(window, before.x[2 * p], before.x[2 * p + 1]))
        kick.push_back(std::hypot(after.v[2 * p] - before.v[2 * p], after.v[2 * p + 1] - before.v[2 * p + 1]));
  }
  void grid(const StageStill& before, const StageStill& after, const render::Window& window) {
    for (int axis = 0; axis < 2; ++axis) {
      const std::string name = axis == 0 ? "u" : "v";
      const StageSamples *old = before.find(name), *now = after.find(name), *m = after.find("mass_" + name);
      if (!now || !m) continue;
      each_seen(*now, after.dx, window, [&](std::size_t at, int i, int j) {
        if (!(m->values[at] > 0) || !touches_liquid(after, axis, i, j)) return;
        mass.push_back(m->values[at]);
        if (old) change.push_back(std::abs(now->values[at] - old->values[at]));
      });
    }
  }
  void cells(const StageStill& s, const char* name, std::vector<double>& to, const render::Window& window) const {
    const StageSamples *values = s.find(name), *liquid = s.find("liquid");
    if (!values || !liquid) return;
    each_seen(*values, s.dx, window, [&](std::size_t at, int, int) {
      if (liquid->values[at] > 0) to.push_back(values->values[at]);
    });
  }
};

void look(const StoryStage& stage, const RecordedStep& step, const render::Window& window, Seen& seen) {
  const StageStill &before = step.stills[stage.before], &after = step.stills[stage.after];
  std::vector<double> divergence;
  switch (stage.kind) {
  case StageKind::start: seen.particles(after, window); break;
  case StageKind::painted:
  case StageKind::changed:
  case StageKind::projected: seen.grid(before, after, window); break;
  case StageKind::divergence:
    seen.cells(after, "divergence", divergence, window);
    for (const double x : divergence) seen.divergence.push_back(std::abs(x));
    break;
  case StageKind::pressure: seen.cells(after, "p", seen.pressure, window); break;
  case StageKind::gathered: seen.kicks(before, after, window); break;
  case StageKind::moved: break;
  }
}

} // namespace

bool on_nodes(const StageStill& still) {
  const StageSamples *u = still.find("u"), *v = still.find("v");
  return u && v && u->origin == v->origin;
}

bool touches_liquid(const StageStill& still, int axis, int i, int j) {
  const StageSamples* liquid = still.find("liquid");
  if (!liquid) return true;
  const auto is_liquid = [&](int a, int b) {
    return a >= 0 && b >= 0 && a < liquid->n[0] && b < liquid->n[1] &&
           liquid->values[static_cast<std::size_t>(a + liquid->n[0] * b)] > 0;
  };
  return is_liquid(i, j) || (axis == 0 ? is_liquid(i - 1, j) : is_liquid(i, j - 1));
}

render::Window parse_window(const std::string& text, const Settings& domain) {
  const auto& size = domain.grid.size;
  const double dx = domain.dx();
  const std::string option = "--window";
  std::vector<double> n;
  for (const std::string& part : split_list(text, option)) {
    const Value value = parse_value(part);
    const double* x = std::get_if<double>(&value);
    if (!x || !std::isfinite(*x)) throw UserError(option + " " + text + ": \"" + part + "\" is not a number");
    n.push_back(*x);
  }
  if (n.size() != 4) throw UserError(option + " " + text + ": it is x0,y0,x1,y1 in metres");
  if (!(n[0] < n[2] && n[1] < n[3])) throw UserError(option + " " + text + ": x0 < x1 and y0 < y1 are wanted");
  for (std::size_t a = 0; a < 2; ++a) {
    if (n[a] < 0 || n[a + 2] > size[a])
      throw UserError(option + " " + text + ": the domain is from 0,0 to " + to_toml(Value(size[0])) + "," +
                      to_toml(Value(size[1])) + " m");
    const double cells = (n[a + 2] - n[a]) / dx;
    if (cells > most_window_cells || cells < 1)
      throw UserError(option + " " + text + ": it shows " + render::number(cells, 3) + " cells along " + "xy"[a] +
                      "; 1 to " + std::to_string(most_window_cells) + " can be told apart (a cell is " +
                      render::number(dx, 4) + " m)");
  }
  return {{n[0], n[1]}, {n[2], n[3]}};
}

render::Window liveliest_window(const std::vector<RecordedStep>& steps, std::array<int, 2> wanted) {
  const Snapshot& s = *steps.front().before;
  const std::array<int, 2> n{s.cells[0], s.cells[1]}, size{std::min(wanted[0], n[0]), std::min(wanted[1], n[1])};
  SummedCells impulses(s), speeds(s);
  for (const RecordedStep& step : steps) {
    add_impulses(step, impulses);
    add_speeds(step, speeds);
  }
  const std::array<int, 2> best = (impulses.empty() ? speeds : impulses).fullest(size[0], size[1]);
  render::Window window{};
  for (std::size_t a = 0; a < 2; ++a) {
    window.lo[a] = s.dx * best[a] - (best[a] == 0 ? wall_seen * s.dx : 0);
    window.hi[a] = s.dx * (best[a] + size[a]) + (best[a] + size[a] == n[a] ? wall_seen * s.dx : 0);
  }
  return window;
}

StageScales scales_of(const std::vector<RecordedStep>& steps, const std::vector<StoryStage>& story,
                      const render::Window& window) {
  Seen seen;
  for (const RecordedStep& step : steps)
    for (const StoryStage& stage : story) look(stage, step, window, seen);
  StageScales scales;
  scales.velocity = scale_of(seen.velocity);
  scales.change = scale_of(seen.change);
  scales.mass = scale_of(seen.mass, 0.5);
  scales.divergence = scale_of(seen.divergence);
  scales.kick = scale_of(seen.kick);
  if (!seen.pressure.empty()) {
    const auto [lo, hi] = std::minmax_element(seen.pressure.begin(), seen.pressure.end());
    scales.p_lo = *lo < -0.02 * std::max(*hi, 0.0) ? -render::round_up(-*lo) : 0;
    scales.p_hi = *hi > 0 ? render::round_up(*hi) : scales.p_lo + 1;
  }
  return scales;
}

ShownParticle shown_particle(const RecordedStep& step, const render::Window& window) {
  if (step.stills.size() < 2) return {};
  const StageStill &start = step.stills[0], &painted = step.stills[1];
  const double mx = (window.lo[0] + window.hi[0]) / 2, my = (window.lo[1] + window.hi[1]) / 2;
  ShownParticle shown;
  double nearest = INFINITY;
  for (std::size_t p = 0; p < start.id.size(); ++p) {
    const double away = std::hypot(start.x[2 * p] - mx, start.x[2 * p + 1] - my);
    const bool flies = p < painted.ballistic.size() && painted.ballistic[p] != 0;
    if (flies || away >= nearest || !within(window, start.x[2 * p], start.x[2 * p + 1])) continue;
    nearest = away;
    shown.x = start.x[2 * p];
    shown.y = start.x[2 * p + 1];
  }
  if (!(nearest < INFINITY)) return {};
  // Its stencil on a small grid, moved by whole cells.
  const double dx = start.dx, i = std::floor(shown.x / dx), j = std::floor(shown.y / dx);
  constexpr double home = 2;
  Budget budget(1);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  const auto& transfer = step.settings.transfer;
  shown.samples = gather_and_paint(
      Corner{}, transfer.kernel, on_nodes(painted) ? Layout::nodes : Layout::mac, home + shown.x / dx - i,
      home + shown.y / dx - j, [](int, double, double) { return 0.0; }, pool);
  for (TouchedSample& s : shown.samples) {
    s.x = dx * (s.x - home + i);
    s.y = dx * (s.y - home + j);
  }
  return shown;
}

} // namespace flipbook::app
