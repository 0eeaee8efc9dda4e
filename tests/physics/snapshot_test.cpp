// SPDX-License-Identifier: MIT
// What a run publishes.
#include "sim/fluid/channels.h"
#include "tests/physics/flow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using testing::Each;
using testing::FloatNear;

Flow<2> tank(int scheme = flip) {
  Settings s = box({16, 12, 16}, 0.125);
  s.transfer.scheme = scheme;
  return Flow<2>(s, seed<2>(
                        s, [](const auto& x) { return x[1] < 0.75; }, at_rest<2>));
}

const Channel& channel(const Snapshot& s, const std::string& name) {
  for (const Channel& c : s.channels)
    if (c.name == name) return c;
  throw std::out_of_range(name);
}

TEST(Snapshot, SaysWhatRanWhenAndWhere) {
  auto flow = tank();
  flow.solver.step(0.01);
  const auto s = flow.solver.snapshot(7, {});
  EXPECT_EQ(s->title, "FLIP 1");
  EXPECT_EQ(s->scheme, "flip");
  EXPECT_EQ(s->kernel, "linear");
  EXPECT_EQ(s->frame, 7U);
  EXPECT_EQ(s->steps, 1U);
  EXPECT_EQ(s->time, 0.01);
  EXPECT_EQ(s->dt, 0.01);
  EXPECT_GT(s->pressure_iterations, 0);
  EXPECT_LE(s->pressure_residual, 1e-10);
  EXPECT_EQ(s->hi[0], 2);
  EXPECT_EQ(s->hi[1], 1.5);
  EXPECT_EQ(s->cells[1], 12);
  EXPECT_EQ(s->particle_spacing, 0.0625);
  EXPECT_EQ(s->particles(), flow.particles().size());
  EXPECT_EQ(s->x.size(), 2 * s->particles());
  EXPECT_TRUE(s->channels.empty());
  EXPECT_TRUE(s->lattices.empty());
}

TEST(Snapshot, PublishesWhatIsAskedFor) {
  auto flow = tank();
  flow.solver.step(0.01);
  const auto s = flow.solver.snapshot(0, {{"speed", "initial_y"}, true, true, true});
  ASSERT_EQ(s->channels.size(), 2U);
  ASSERT_EQ(s->lattices.size(), 4U);
  EXPECT_EQ(s->lattices[0].name, "u");
  EXPECT_EQ(s->lattices[0].n, (std::array<int, 3>{17, 12, 1}));
  EXPECT_FLOAT_EQ(s->lattices[0].origin[1], 0.0625F);
  EXPECT_EQ(s->lattices[1].n, (std::array<int, 3>{16, 13, 1}));
  EXPECT_EQ(s->lattices[3].name, "p");
  for (const LatticeData& l : s->lattices) EXPECT_EQ(l.values.size(), static_cast<std::size_t>(l.n[0] * l.n[1]));
  for (std::size_t p = 0; p < s->particles(); ++p) // nothing has moved far
    EXPECT_NEAR(channel(*s, "initial_y").values[p], s->x[2 * p + 1], 1e-6);
  EXPECT_THROW((void)flow.solver.snapshot(0, {{"sped"}, false, false, false}), UserError);
}

TEST(Snapshot, PressureChannelIsHydrostatic) {
  auto flow = tank();
  flow.solver.step(0.01);
  const auto s = flow.solver.snapshot(0, {{"pressure"}, false, false, false});
  for (std::size_t p = 0; p < s->particles(); ++p) {
    const double depth = 0.75 - static_cast<double>(s->x[2 * p + 1]);
    if (depth > 0.125 && s->x[2 * p + 1] > 0.0625F) { // between cell centres
      EXPECT_NEAR(channel(*s, "pressure").values[p], 9810 * depth, 1);
    }
  }
}

/// Rigid rotation about z: vorticity 2 omega everywhere; PIC's particles know nothing that the grid does not.
template <int Dim> void expect_rotation() {
  Settings s = box({12, 12, 12}, 1.0 / 12, Dim);
  s.fluid.surface = Surface::full;
  s.fluid.gravity = {0, 0, 0};
  s.transfer.scheme = pic;
  Flow<Dim> flow(s, seed<Dim>(s, everywhere<Dim>, [](const auto& x) {
                   auto v = x;
                   v.setZero();
                   v[0] = -3 * (x[1] - 0.5);
                   v[1] = 3 * (x[0] - 0.5);
                   return v;
                 }));
  const auto snapshot = flow.solver.snapshot(0, {{"vorticity", "noise", "velocity_x"}, false, false, false});
  int inner = 0;
  for (std::size_t p = 0; p < snapshot->particles(); ++p) {
    double wall = 1;
    for (std::size_t d = 0; d < Dim; ++d)
      wall = std::min(
          {wall, static_cast<double>(snapshot->x[Dim * p + d]), 1 - static_cast<double>(snapshot->x[Dim * p + d])});
    if (wall < 0.15) continue;
    ++inner;
    EXPECT_NEAR(channel(*snapshot, "vorticity").values[p], 6, 1e-4);
    EXPECT_NEAR(channel(*snapshot, "noise").values[p], 0, 1e-4);
  }
  EXPECT_GT(inner, 50);
  EXPECT_EQ(channel(*snapshot, "velocity_x").lo, -channel(*snapshot, "velocity_x").hi);
}

TEST(Snapshot, VorticityAndNoiseOfARotation) {
  expect_rotation<2>();
  expect_rotation<3>();
}

TEST(Snapshot, ExtremesNeverShrink) {
  auto flow = tank();
  const FrameRequest request{{"speed"}, false, false, false};
  ASSERT_TRUE(flow.solver.set("fluid.gravity", std::vector<double>{5, -9.81}).message.empty() ||
              flow.solver.set("fluid.gravity", std::vector<double>{5, -9.81, 0}).message.empty());
  double before = 0;
  for (int i = 0; i < 10; ++i) {
    flow.run_to(flow.solver.time() + 0.1);
    const auto s = flow.solver.snapshot(static_cast<std::uint64_t>(i), request);
    const Channel c = channel(*s, "speed");
    EXPECT_GE(c.hi, before);
    const auto above = std::count_if(c.values.begin(), c.values.end(), [&](float x) { return x > c.hi; });
    EXPECT_LE(above, static_cast<std::ptrdiff_t>(c.values.size() / 200)) << "a few drops may be faster";
    before = c.hi;
  }
  EXPECT_GT(before, 0.5);
}

TEST(Snapshot, EveryChannelOfTheListHasAValuePerParticle) {
  auto flow = tank();
  for (const auto& source : channel_sources<2, double>()) {
    const auto s = flow.solver.snapshot(0, {{std::string(source.name)}, false, false, false});
    EXPECT_EQ(s->channels.front().values.size(), s->particles()) << source.name;
    EXPECT_EQ(s->channels.front().name, source.name);
  }
}

TEST(History, EnergiesAddUpAndRowsThinOut) {
  Settings s = box({4, 8, 4}, 0.25);
  s.transfer.scheme = pic;
  Flow<2> flow(s, seed<2>(
                      s, [](const auto& x) { return x[1] < 1.25 && x[0] < 0.5; }, at_rest<2>));
  std::shared_ptr<const Snapshot> last;
  const std::size_t frames = History::capacity + 10;
  for (std::size_t i = 0; i < frames; ++i) {
    flow.solver.step(1e-4);
    last = flow.solver.snapshot(i, {});
  }
  const History& h = *last->history;
  EXPECT_LT(h.t.size(), History::capacity);
  EXPECT_GT(h.t.size(), History::capacity / 2 - 2);
  EXPECT_FLOAT_EQ(h.t.back(), static_cast<float>(flow.solver.time()));
  EXPECT_LT(h.t.front(), 5e-4F);
  std::vector<std::string> names;
  for (const auto& c : h.columns) {
    names.push_back(c.name);
    EXPECT_EQ(c.y.size(), h.t.size());
  }
  EXPECT_THAT(names, testing::ElementsAre("kinetic", "potential", "total", "transfer_loss", "momentum_x", "momentum_y",
                                          "angular_momentum_z", "momentum_drift", "divergence", "settled_volume",
                                          "front", "height", "lost_p2g", "lost_free_faces", "lost_forces", "lost_walls",
                                          "lost_projection", "lost_extrapolation", "lost_g2p", "lost_advection"));
  const std::size_t i = h.t.size() - 1;
  EXPECT_FLOAT_EQ(h.columns[2].y[i], h.columns[0].y[i] + h.columns[1].y[i]);
  EXPECT_GT(h.columns[0].y[i], 0);
  EXPECT_GT(h.columns[3].y[i], 0); // PIC loses
}

/// FLIP 1 on a steady flow loses next to nothing in its transfers, PIC most of what it has.
TEST(History, TransferLossTellsSchemesApart) {
  const auto loss = [](int scheme) {
    Settings s = periodic_box(24, 1);
    s.transfer.scheme = scheme;
    Flow<2> flow(s, seed<2>(s, everywhere<2>, taylor_green));
    const double before = kinetic_energy(flow.state(), flow.pool);
    flow.run_to(0.2, 0.005);
    const double lost = before - kinetic_energy(flow.state(), flow.pool);
    EXPECT_GT(flow.solver.ledger()->transfer_loss(), 0) << scheme_names[scheme];
    EXPECT_LT(flow.solver.ledger()->transfer_loss(), 1.05 * lost + 0.01 * before) << scheme_names[scheme];
    return flow.solver.ledger()->transfer_loss() / before;
  };
  const double of_pic = loss(pic), of_apic = loss(apic);
  EXPECT_GT(of_pic, 0.3);
  EXPECT_LT(of_apic, 0.1 * of_pic);
}

} // namespace
} // namespace flipbook::test
