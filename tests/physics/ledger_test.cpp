// SPDX-License-Identifier: MIT
// What the ledger says of flows whose account is known: what gravity gives, that nothing happens in a still pool, where
// PIC loses its energy, what a wall takes of a drop.
#include "tests/physics/flow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using Ledger = FluidLedger<2, double>;
constexpr std::size_t p_x = Ledger::momentum, p_y = Ledger::momentum + 1, L_z = Ledger::angular_momentum,
                      T = Ledger::kinetic;
constexpr std::array all_stages{Stage::p2g,        Stage::free_faces,    Stage::forces,      Stage::walls,
                                Stage::projection, Stage::extrapolation, Stage::second_half, Stage::g2p,
                                Stage::advection,  Stage::spacing};

class EverySplitting : public testing::TestWithParam<Splitting> {};
INSTANTIATE_TEST_SUITE_P(All, EverySplitting,
                         testing::Values(Splitting::lie, Splitting::midpoint, Splitting::reflection),
                         [](const auto& run) {
                           return std::string(splitting_names[static_cast<std::size_t>(run.param)]);
                         });

/// A curve's last value.
double last(const Snapshot& s, std::string_view name) {
  for (const auto& c : s.history->columns)
    if (c.name == name) return static_cast<double>(c.y.back());
  ADD_FAILURE() << "no curve " << name;
  return 0;
}
bool has(const Snapshot& s, std::string_view name) {
  return std::any_of(s.history->columns.begin(), s.history->columns.end(),
                     [&](const auto& c) { return c.name == name; });
}

/// A drop that turns and flies, with a particle of spray beside it, in free fall.
Flow<2> falling_drop(int scheme, Splitting splitting) {
  Settings s = box({20, 40, 20}, 0.05);
  s.transfer.scheme = scheme;
  s.time.splitting = splitting;
  auto particles = seed<2>(
      s, [](const auto& x) { return (x - Vec<2, double>(0.5, 1.5)).norm() < 0.2; },
      [](const auto& x) { return Vec<2, double>(0.3 - 2 * (x[1] - 1.5), 2 * (x[0] - 0.5)); });
  particles.add({0.1, 1.845}, {0.2, 1}, particles.m[0], static_cast<std::uint32_t>(particles.size()));
  return Flow<2>(s, std::move(particles));
}

TEST_P(EverySplitting, GravityGivesMomentumAtItsRate) {
  for (const int scheme : {pic, flip, apic, polypic, xpic}) {
    auto flow = falling_drop(scheme, GetParam());
    const double dt = 0.004, mass = flow.solver.ledger()->held(Ledger::mass);
    flow.solver.step(dt);
    const Ledger& ledger = *flow.solver.ledger();
    const auto& ballistic = flow.state().ballistic;
    EXPECT_EQ(std::count(ballistic.begin(), ballistic.end(), 1), 1);
    const double share = GetParam() == Splitting::lie ? 1 : 0.5; // the rest comes with the second half
    EXPECT_NEAR(ledger.in_step(Stage::forces, p_y), -9.81 * share * dt * mass, 1e-9 * mass) << scheme_names[scheme];
    for (int i = 0; i < 9; ++i) flow.solver.step(dt);
    // In the air nothing else acts: what pressure does to a drop that turns stays within it.
    EXPECT_NEAR(ledger.held(p_y) - ledger.start(p_y), -9.81 * 10 * dt * mass, 2e-3 * 9.81 * 10 * dt * mass);
    EXPECT_EQ(ledger.total(Stage::walls, p_y), 0);
    EXPECT_NEAR(ledger.total(Stage::p2g, p_y), 0, 1e-10 * mass);
    EXPECT_LT(ledger.momentum_drift(), 2e-3 * mass);
  }
}

TEST_P(EverySplitting, StillPoolHasEmptyLines) {
  Settings s = box({16, 16, 16}, 1.0 / 16);
  s.time.splitting = GetParam();
  for (const int scheme : {pic, flip, rpic, apic, aflip, polypic, xpic}) {
    SCOPED_TRACE(scheme_names[scheme]);
    s.transfer.scheme = scheme;
    Flow<2> flow(s, seed<2>(
                        s, [](const auto& x) { return x[1] < 0.5; }, at_rest<2>));
    const double mass = flow.solver.ledger()->held(Ledger::mass), dt = 0.005;
    for (int i = 0; i < 20; ++i) flow.solver.step(dt);
    const Ledger& ledger = *flow.solver.ledger();
    for (const Stage stage : {Stage::p2g, Stage::free_faces, Stage::g2p, Stage::advection, Stage::spacing}) {
      EXPECT_NEAR(ledger.total(stage, p_y), 0, 1e-6 * mass);
      EXPECT_NEAR(ledger.total(stage, p_x), 0, 1e-6 * mass);
      EXPECT_NEAR(ledger.total(stage, T), 0, 1e-9 * mass);
    }
    // Walls and pressure take what gravity gives, step by step.
    double given = 0;
    for (const Stage stage : all_stages) given += ledger.in_step(stage, p_y);
    EXPECT_NEAR(given, 0, 1e-6 * mass);
    EXPECT_LT(ledger.in_step(Stage::forces, p_y), -0.4 * 9.81 * dt * mass);
    EXPECT_GT(ledger.in_step(Stage::projection, p_y), 0.3 * 9.81 * dt * mass);
    const auto snapshot = flow.solver.snapshot(1, with_noise());
    EXPECT_NEAR(last(*snapshot, "settled_volume"), 1, 1e-6);
    EXPECT_LT(last(*snapshot, "divergence"), 1e-8);
    EXPECT_LT(last(*snapshot, "noise"), 1e-6);
    EXPECT_FALSE(has(*snapshot, "angular_momentum_ratio"));
  }
}

/// In a periodic box without gravity a scheme loses energy in its transfers, and the first-order splitting in the
/// projection; nothing else takes any.
TEST(Ledger, PicLosesItsEnergyInTheTransfers) {
  Settings s = periodic_box(32, 1);
  s.transfer.scheme = pic;
  Flow<2> flow(s, seed<2>(s, everywhere<2>, taylor_green));
  const double before = flow.solver.ledger()->held(T);
  flow.run_to(0.1, 1.0 / 32 / 8);
  const Ledger& ledger = *flow.solver.ledger();
  const double lost = before - ledger.held(T), transfers = -ledger.total(Stage::p2g, T) - ledger.total(Stage::g2p, T);
  EXPECT_GT(lost, 0.3 * before);
  EXPECT_GT(transfers, 0.95 * lost);
  EXPECT_NEAR(ledger.transfer_loss(), transfers, 1e-12 * before);
  EXPECT_NEAR(transfers - ledger.total(Stage::projection, T), lost, 1e-9 * before);
  EXPECT_EQ(ledger.total(Stage::advection, T), 0);
  const LedgerTable t = *flow.solver.snapshot(0, {})->ledger;
  EXPECT_FALSE(t.quantities[L_z].defined);
  EXPECT_EQ(t.claims[t.at(0, L_z)], LedgerTable::Claim::none);
  EXPECT_EQ(t.energy_in, before);
}

TEST(Ledger, WhatAWallTakesOfSprayIsAdvections) {
  Settings s = box({8, 8, 8}, 1);
  s.fluid.gravity = {0, 0, 0};
  Particles<2, double> one;
  one.add({0.05, 4.05}, {-3, 2}, 1, 0);
  Flow<2> flow(s, one);
  flow.solver.step(0.1);
  const Ledger& ledger = *flow.solver.ledger();
  EXPECT_EQ(ledger.total(Stage::advection, p_x), 3);
  EXPECT_EQ(ledger.total(Stage::advection, T), -4.5);
  for (const Stage stage : all_stages) EXPECT_EQ(ledger.total(stage, p_y), 0);
  EXPECT_EQ(ledger.total(Stage::p2g, T), 0); // it takes no part
}

/// FLIP's G2P gives back what the extrapolation over free faces changed; PIC's does not.
TEST(Ledger, FlipGivesBackWhatFreeFacesTook) {
  const auto run = [](int scheme) {
    auto flow = falling_drop(scheme, Splitting::lie);
    for (int i = 0; i < 10; ++i) flow.solver.step(0.004);
    const Ledger& l = *flow.solver.ledger();
    EXPECT_GT(std::abs(l.total(Stage::free_faces, p_x)), 1e-6);
    return std::pair(l.total(Stage::g2p, p_x) + l.total(Stage::free_faces, p_x), l.total(Stage::g2p, p_x));
  };
  EXPECT_NEAR(run(flip).first, 0, 1e-10);
  EXPECT_NEAR(run(pic).second, 0, 1e-10);
}

TEST(Ledger, ACurveShowsWhatIsLeftOfTheTurn) {
  const auto left = [](int scheme) {
    Settings s = box({24, 24, 24}, 1.0 / 24);
    s.fluid.gravity = {0, 0, 0};
    s.transfer.scheme = scheme;
    Flow<2> flow(s, seed<2>(
                        s, [](const auto& x) { return (x - Vec<2, double>(0.5, 0.5)).norm() < 0.25; },
                        [](const auto& x) { return Vec<2, double>(-2 * (x[1] - 0.5), 2 * (x[0] - 0.5)); }));
    EXPECT_FLOAT_EQ(static_cast<float>(last(*flow.solver.snapshot(0, {}), "angular_momentum_ratio")), 1);
    for (int i = 0; i < 20; ++i) flow.solver.step(0.004);
    return last(*flow.solver.snapshot(1, {}), "angular_momentum_ratio");
  };
  EXPECT_GT(left(apic), 0.95);
  EXPECT_LT(left(pic), left(apic) - 0.1);
}

TEST(Ledger, ACurveThatIsAskedForLateBeginsWithAGap) {
  auto flow = falling_drop(flip, Splitting::lie);
  EXPECT_FALSE(has(*flow.solver.snapshot(0, {}), "noise"));
  flow.solver.step(0.004);
  const auto snapshot = flow.solver.snapshot(1, with_noise());
  ASSERT_TRUE(has(*snapshot, "noise"));
  for (const auto& c : snapshot->history->columns) {
    ASSERT_EQ(c.y.size(), 2U) << c.name;
    EXPECT_EQ(std::isnan(c.y[0]), c.name == "noise") << c.name;
    EXPECT_TRUE(std::isfinite(c.y[1])) << c.name;
  }
  flow.solver.step(0.004);
  EXPECT_TRUE(std::isnan(last(*flow.solver.snapshot(2, {}), "noise")));
}

TEST(Ledger, NotesSayWhereThePropositionsDoNotApply) {
  const auto notes_of = [](Settings s, int scheme) {
    s.transfer.scheme = scheme;
    Flow<2> flow(s, seed<2>(s, everywhere<2>, at_rest<2>));
    const auto snapshot = flow.solver.snapshot(0, {});
    std::string all;
    for (const std::string& note : snapshot->notes) all += note + "\n";
    return all;
  };
  using testing::HasSubstr;
  Settings s = box({8, 8, 8}, 0.125);
  EXPECT_THAT(notes_of(s, flip), HasSubstr("velocity that the grid does not have"));
  EXPECT_THAT(notes_of(s, pic), HasSubstr("Particles do not keep all of the grid's rotation"));
  EXPECT_THAT(notes_of(s, apic), HasSubstr("rk3"));
  s.time.advection = Advection::rk1;
  EXPECT_THAT(notes_of(s, apic), HasSubstr("With the linear kernel"));
  s.transfer.kernel = KernelName::quadratic;
  EXPECT_EQ(notes_of(s, apic), "Walls take momentum; only the transfers are claimed to keep it.\n");
  s.time.splitting = Splitting::midpoint;
  EXPECT_THAT(notes_of(s, apic), HasSubstr("two projections"));
  EXPECT_EQ(notes_of(periodic_box(8, 1), flip), "With a periodic axis the angular momentum is not defined.\n");
}

TEST(Ledger, OffMeansNone) {
  Settings s = box({8, 8, 8}, 1);
  s.ledger.on = false;
  Flow<2> flow(s, seed<2>(
                      s, [](const auto& x) { return x[1] < 4; }, at_rest<2>));
  flow.solver.step(0.01);
  const auto snapshot = flow.solver.snapshot(0, with_noise());
  EXPECT_FALSE(snapshot->ledger);
  EXPECT_FALSE(snapshot->history);
  EXPECT_FALSE(flow.solver.ledger());
}

TEST(Ledger, AccountsAreOfFramesOrOfSteps) {
  for (const LedgerRows rows : {LedgerRows::frame, LedgerRows::step}) {
    Settings s = box({8, 8, 8}, 0.125);
    s.ledger.rows = rows;
    Flow<2> flow(s, seed<2>(
                        s, [](const auto& x) { return x[1] < 0.5 && x[0] < 0.5; }, at_rest<2>));
    const bool frames = rows == LedgerRows::frame;
    EXPECT_EQ(flow.solver.snapshot(0, {})->ledger->accounts.size(), 1U); // the start
    for (int i = 0; i < 3; ++i) flow.solver.step(0.01);
    const auto t = flow.solver.snapshot(1, {})->ledger;
    ASSERT_EQ(t->accounts.size(), frames ? 1U : 3U);
    EXPECT_EQ(t->accounts[0].step, frames ? 3U : 1U);
    EXPECT_DOUBLE_EQ(t->accounts[0].time, frames ? 0.03 : 0.01);
    EXPECT_EQ(t->accounts.back().held[T], t->quantities[T].now);
    double booked = 0;
    for (const auto& a : t->accounts) booked += a.changes[t->at(0, T)];
    EXPECT_NEAR(booked, t->total[t->at(0, T)], 1e-12 * std::abs(booked));
    EXPECT_TRUE(flow.solver.snapshot(1, {})->ledger->accounts.empty());
    EXPECT_EQ(t->stages.size(), 8U); // neither the second half of a reflection nor spacing
    ASSERT_EQ(flow.solver.set("fluid.spacing", 0.5).message, "");
    flow.solver.step(0.01);
    EXPECT_EQ(flow.solver.snapshot(2, {})->ledger->stages.back().name, "spacing");
  }
}

/// What a change of parameters does between two steps is booked, too.
TEST(Ledger, StaysClosedWhenTheSchemeChanges) {
  auto flow = falling_drop(pic, Splitting::lie);
  flow.solver.step(0.004);
  ASSERT_EQ(flow.solver.set("transfer.scheme", std::string("apic")).message, "");
  ASSERT_EQ(flow.solver.set("fluid.gravity", std::vector<double>{0, -1, 0}).message, "");
  flow.solver.step(0.004);
  const Ledger& ledger = *flow.solver.ledger();
  for (std::size_t q = 0; q < Ledger::quantities; ++q) {
    double sum = ledger.start(q);
    for (const Stage stage : all_stages) sum += ledger.total(stage, q);
    EXPECT_NEAR(sum, ledger.held(q), 1e-12 * (std::abs(ledger.start(q)) + std::abs(ledger.held(q)) + 1));
  }
  EXPECT_GT(std::abs(ledger.total(Stage::forces, Ledger::potential)), 1);
}

} // namespace
} // namespace flipbook::test
