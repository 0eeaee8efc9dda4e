// SPDX-License-Identifier: MIT
// A drop is thrown at every wall, edge and corner, and then pulled away from it: nothing leaves the domain, nothing
// stays for ever where it hit, and no wall does work.
#include "tests/physics/flow.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace flipbook::test {
namespace {

/// All neighbours of a cell: the walls, edges and corners of the domain.
template <int Dim> std::vector<Vec<Dim, double>> directions() {
  std::vector<Vec<Dim, double>> all;
  for (int code = 0; code < (Dim == 2 ? 9 : 27); ++code) {
    Vec<Dim, double> d;
    int rest = code;
    for (int a = 0; a < Dim; ++a, rest /= 3) d[a] = rest % 3 - 1;
    if (d.norm() > 0) all.push_back(d);
  }
  return all;
}

constexpr double radius = 0.15, speed = 4, pull = 20, end = 3;

template <int Dim> class Throw {
public:
  Throw(int cells, const Vec<Dim, double>& to, int scheme, KernelName kernel, Wall wall, Splitting splitting)
      : n_(cells), to_(to), flow_(start(cells, to, scheme, kernel, wall, splitting)) {}

  /// Until what was thrown has come back several times.
  void run() {
    const std::size_t count = flow_.particles().size();
    since_.assign(count, -1);
    longest_.assign(count, 0);
    first_energy_ = most_energy_ = energy();
    while (flow_.solver.time() < end) {
      flow_.solver.step(flow_.solver.max_dt());
      most_energy_ = std::max(most_energy_, energy());
      for (std::size_t p = 0; p < count; ++p) watch(p);
    }
  }

  /// The longest stay of any particle within a cell of a wall that it was thrown at.
  [[nodiscard]] double longest_stay() const { return *std::max_element(longest_.begin(), longest_.end()); }
  [[nodiscard]] bool inside() const { return inside_; }
  /// Energy gained, in units of the kinetic energy of the throw.
  [[nodiscard]] double gain() const { return (most_energy_ - first_energy_) / thrown_; }

private:
  static Settings settings(int n, const Vec<Dim, double>& to, int scheme, KernelName kernel, Wall wall,
                           Splitting splitting) {
    Settings s = box({n, n, n}, 1.0 / n, Dim);
    s.seeding.pattern = Pattern::jittered;
    s.walls.axis.fill(wall);
    s.transfer.scheme = scheme;
    s.transfer.kernel = kernel;
    s.time.splitting = splitting;
    s.pressure.tolerance = 1e-6;
    for (int a = 0; a < Dim; ++a) s.fluid.gravity[static_cast<std::size_t>(a)] = -pull * to[a];
    return s;
  }
  static Flow<Dim> start(int n, const Vec<Dim, double>& to, int scheme, KernelName kernel, Wall wall,
                         Splitting splitting) {
    const Settings s = settings(n, to, scheme, kernel, wall, splitting);
    const Vec<Dim, double> centre = Vec<Dim, double>::Constant(0.5);
    return Flow<Dim>(s, seed<Dim>(
                            s, [&](const auto& x) { return (x - centre).norm() < radius; },
                            [&](const auto&) { return Vec<Dim, double>(speed * to); }));
  }

  double energy() {
    const auto& s = flow_.state();
    const Totals<Dim> totals = particle_totals(s.settings.transfer.kernel, Layout::mac, s.grid, s.particles,
                                               Vec<Dim, double>(Vec<Dim, double>::Zero()), flow_.pool);
    double potential = 0;
    for (std::size_t p = 0; p < s.particles.size(); ++p)
      potential += pull * s.particles.m[p] * to_.dot(s.particles.position(p));
    if (thrown_ == 0) thrown_ = totals.kinetic_energy;
    return totals.kinetic_energy + potential;
  }

  void watch(std::size_t p) {
    const Vec<Dim, double> x = flow_.particles().position(p);
    const std::size_t id = flow_.particles().id[p];
    bool near = false;
    for (int a = 0; a < Dim; ++a) {
      inside_ = inside_ && x[a] >= 0 && x[a] < 1;
      near = near || (to_[a] > 0 && x[a] > 1 - 1.0 / n_) || (to_[a] < 0 && x[a] < 1.0 / n_);
    }
    if (!near)
      since_[id] = -1;
    else if (since_[id] < 0)
      since_[id] = flow_.solver.time();
    else
      longest_[id] = std::max(longest_[id], flow_.solver.time() - since_[id]);
  }

  int n_;
  Vec<Dim, double> to_;
  Flow<Dim> flow_;
  std::vector<double> since_, longest_;
  double first_energy_ = 0, most_energy_ = 0, thrown_ = 0;
  bool inside_ = true;
};

/// A particle just beside a wall leaves it like exp(u t / dx), which takes a while; the bound is that it does leave.
template <int Dim>
void comes_back(int cells, int scheme, KernelName kernel, Wall wall, Splitting splitting = Splitting::lie) {
  for (const Vec<Dim, double>& to : directions<Dim>()) {
    Throw<Dim> drop(cells, to, scheme, kernel, wall, splitting);
    drop.run();
    EXPECT_TRUE(drop.inside()) << to.transpose();
    EXPECT_LT(drop.longest_stay(), 0.8 * end) << to.transpose();
    // Midpoint's correction and reflection are no projections: they may give a little.
    EXPECT_LT(drop.gain(), splitting == Splitting::lie ? 0.05 : 0.5) << to.transpose();
  }
}

class ThrownDrop : public testing::TestWithParam<std::tuple<KernelName, Wall>> {};

TEST_P(ThrownDrop, ComesBackFromEveryWallAndCorner) {
  const auto [kernel, wall] = GetParam();
  comes_back<2>(20, flip, kernel, wall);
  comes_back<2>(20, apic, kernel, wall);
  comes_back<2>(20, apic, kernel, wall, Splitting::midpoint);
}

TEST_P(ThrownDrop, ComesBackInSpace) {
  const auto [kernel, wall] = GetParam();
  comes_back<3>(8, apic, kernel, wall);
}

INSTANTIATE_TEST_SUITE_P(All, ThrownDrop,
                         testing::Combine(testing::Values(KernelName::linear, KernelName::quadratic, KernelName::cubic),
                                          testing::Values(Wall::free_slip, Wall::no_slip)),
                         [](const auto& run) {
                           return std::string(kernel_options()[static_cast<std::size_t>(std::get<0>(run.param))].name) +
                                  (std::get<1>(run.param) == Wall::no_slip ? "_no_slip" : "_free_slip");
                         });

} // namespace
} // namespace flipbook::test
