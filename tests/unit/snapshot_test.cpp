// SPDX-License-Identifier: MIT
#include "sim/frame/snapshot.h"

#include "tests/unit/temporary_file.h"

#include <gtest/gtest.h>

#include <limits>

namespace flipbook {
namespace {

/// Two quantities, one stage.
LedgerTable example_ledger() {
  using enum LedgerTable::Claim;
  LedgerTable l;
  l.quantities = {{"kinetic", "kinetic", "J/m", 0.1, 0.2, true},
                  {"angular_momentum_z", "L_z", "kg m^2/s", 1, 2, false}};
  l.stages = {{"p2g", "P2G"}};
  l.step = {0.1, -1e-300};
  l.total = {1.0 / 3, -2};
  l.claims = {holds, fails};
  l.energy_in = 0.7;
  l.step_in = 0.3;
  l.accounts = {{7, 0.25, {1, 2}, {3, 4}}, {9, 0.5, {5, 6}, {7, 8}}};
  return l;
}

/// Every field differs from its default.
Snapshot example() {
  Snapshot s;
  s.title = "FLIP 0.97, \"quoted\"";
  s.scheme = "flip";
  s.kernel = "linear";
  s.solver = "fluid";
  s.parameters = {
      {"transfer.flip_ratio", Kind::real, 0.97, "h", "", 0, 1, {}, {}, Level::teach, Effect::live, true, "PIC", "FLIP"},
      {"view.none",
       Kind::reals,
       std::vector<double>{},
       "h",
       "m",
       0,
       1,
       {},
       {},
       Level::expert,
       Effect::live,
       false,
       "PIC",
       "FLIP"},
      {"transfer.kernel",
       Kind::choice,
       std::string("linear"),
       "h",
       "",
       -std::numeric_limits<double>::infinity(),
       1,
       {"linear", "cubic"},
       {"one", "two words"},
       Level::expert,
       Effect::restart,
       true,
       "PIC",
       "FLIP"}};
  s.notes = {"L is not expected to hold", "second\nline"};
  s.warnings = {"multigrid stalled"};
  s.watermark = "WITH A MISTAKE: \"late\" walls";
  s.frame = 12;
  s.time = 0.1 + 0.2;
  s.steps = 345;
  s.dt = 1e-3 / 3;
  s.pressure_iterations = 17;
  s.pressure_residual = 3e-7;
  s.dim = 2;
  s.lo = {0, 0, 0};
  s.hi = {2, 1, 0.5};
  s.cells = {4, 2, 1};
  s.dx = 0.5;
  s.periodic = {true, false, true};
  s.up = {0, 0, -1};
  s.particle_spacing = 0.25;
  for (int i = 0; i < 34; ++i)
    s.x.push_back(1.0F / static_cast<float>(i + 3)), s.v.push_back(-0.1F * static_cast<float>(i));
  for (std::uint32_t i = 0; i < 17; ++i) s.id.push_back(4294967295U - i);
  s.channels = {{"speed", "m/s", 0, 1.5, false, std::vector<float>(17, 0.1F)},
                {"vorticity", "1/s", -2, 2, true, std::vector<float>(17, -0.0F)}};
  s.lattices = {{"u", {5, 2, 1}, {0, 0.25F, 0}, 0.5F, std::vector<float>(10, 1e-38F)}};
  s.solids.resize(2);
  s.solids[0].surface = std::make_shared<TriangleMesh>(TriangleMesh{{0, 0, 0, 1, 0, 0, 0, 1.5F, 0}, {0, 1, 2}, {0, 1}});
  s.solids[1] = {s.solids[0].surface, {{0, 1, 0, -1, 0, 0, 0, 0, 1}, {0.1, 0.2, 0.3}}};
  s.history = std::make_shared<History>(History{{0, 0.5F}, {{"kinetic", "J", {1, 2}}, {"total", "J", {3, 4}}}});
  s.ledger = std::make_shared<LedgerTable>(example_ledger());
  s.trails = {std::make_shared<TrailPoints>(TrailPoints{0.1, {3}, {0.5F, 0.25F}}),
              std::make_shared<TrailPoints>(TrailPoints{0.3, {3, 8}, {1, 2, 3, 1e-7F}})};
  return s;
}

void expect_equal(const Parameter& a, const Parameter& b) {
  EXPECT_EQ(a.path, b.path);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.value, b.value);
  EXPECT_EQ(a.help, b.help);
  EXPECT_EQ(a.unit, b.unit);
  EXPECT_EQ(a.at_min, b.at_min);
  EXPECT_EQ(a.at_max, b.at_max);
  EXPECT_EQ(a.min, b.min);
  EXPECT_EQ(a.max, b.max);
  EXPECT_EQ(a.options, b.options);
  EXPECT_EQ(a.option_help, b.option_help);
  EXPECT_EQ(a.level, b.level);
  EXPECT_EQ(a.effect, b.effect);
  EXPECT_EQ(a.applies, b.applies);
}

TEST(SnapshotFile, HoldsEveryFieldExactly) {
  const Snapshot a = example();
  const TemporaryFile file("snapshot.txt");
  save_snapshot(a, file.path());
  const Snapshot b = load_snapshot(file.path());

  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.scheme, b.scheme);
  EXPECT_EQ(a.kernel, b.kernel);
  EXPECT_EQ(a.solver, b.solver);
  ASSERT_EQ(a.parameters.size(), b.parameters.size());
  for (std::size_t i = 0; i < a.parameters.size(); ++i) expect_equal(a.parameters[i], b.parameters[i]);
  EXPECT_EQ(a.notes, b.notes);
  EXPECT_EQ(a.warnings, b.warnings);
  EXPECT_EQ(a.watermark, b.watermark);
  EXPECT_EQ(a.frame, b.frame);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.dt, b.dt);
  EXPECT_EQ(a.pressure_iterations, b.pressure_iterations);
  EXPECT_EQ(a.pressure_residual, b.pressure_residual);
  EXPECT_EQ(a.dim, b.dim);
  EXPECT_EQ(a.lo, b.lo);
  EXPECT_EQ(a.hi, b.hi);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.dx, b.dx);
  EXPECT_EQ(a.periodic, b.periodic);
  EXPECT_EQ(a.up, b.up);
  ASSERT_EQ(b.solids.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(b.solids[i].pose.rotation, a.solids[i].pose.rotation);
    EXPECT_EQ(b.solids[i].pose.shift, a.solids[i].pose.shift);
    EXPECT_EQ(b.solids[i].surface->vertices, a.solids[i].surface->vertices);
    EXPECT_EQ(b.solids[i].surface->triangles, a.solids[i].surface->triangles);
    EXPECT_EQ(b.solids[i].surface->outline, a.solids[i].surface->outline);
  }
  EXPECT_EQ(a.particle_spacing, b.particle_spacing);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.id, b.id);
  ASSERT_EQ(b.channels.size(), 2U);
  EXPECT_EQ(b.channels[1].name, "vorticity");
  EXPECT_EQ(b.channels[0].unit, "m/s");
  EXPECT_EQ(b.channels[0].hi, 1.5);
  EXPECT_EQ(b.channels[1].lo, -2);
  EXPECT_TRUE(b.channels[1].diverging);
  EXPECT_EQ(b.channels[0].values, a.channels[0].values);
  ASSERT_EQ(b.lattices.size(), 1U);
  EXPECT_EQ(b.lattices[0].name, "u");
  EXPECT_EQ(b.lattices[0].n, a.lattices[0].n);
  EXPECT_EQ(b.lattices[0].origin, a.lattices[0].origin);
  EXPECT_EQ(b.lattices[0].dx, 0.5F);
  EXPECT_EQ(b.lattices[0].values, a.lattices[0].values);
  ASSERT_TRUE(b.history);
  EXPECT_EQ(b.history->t, a.history->t);
  EXPECT_EQ(b.history->columns[1].y, a.history->columns[1].y);
  EXPECT_EQ(b.history->columns[0].name, "kinetic");
  EXPECT_EQ(b.history->columns[0].unit, "J");
}

TEST(SnapshotFile, HoldsTrailsAndRefusesImpossibleOnes) {
  const TemporaryFile file("snapshot.txt");
  Snapshot a = example();
  save_snapshot(a, file.path());
  const Snapshot b = load_snapshot(file.path());
  ASSERT_EQ(b.trails.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(b.trails[i]->time, a.trails[i]->time);
    EXPECT_EQ(b.trails[i]->id, a.trails[i]->id);
    EXPECT_EQ(b.trails[i]->x, a.trails[i]->x);
  }
  for (const TrailPoints& wrong : {TrailPoints{0, {3}, {0.5F}}, TrailPoints{0, {8, 3}, {0, 0, 0, 0}}}) {
    a.trails = {std::make_shared<TrailPoints>(wrong)};
    save_snapshot(a, file.path());
    EXPECT_THROW((void)load_snapshot(file.path()), UserError);
  }
}

TEST(SnapshotFile, RefusesALatticeWithoutASpacing) {
  const TemporaryFile file("snapshot.txt");
  Snapshot s = example();
  s.lattices[0].dx = 0;
  save_snapshot(s, file.path());
  EXPECT_THROW((void)load_snapshot(file.path()), UserError);
}

TEST(SnapshotFile, HoldsTheLedgerExactly) {
  const TemporaryFile file("snapshot.txt");
  save_snapshot(example(), file.path());
  const Snapshot s = load_snapshot(file.path());
  ASSERT_TRUE(s.ledger);
  const LedgerTable a = example_ledger(), &b = *s.ledger;
  ASSERT_EQ(b.quantities.size(), 2U);
  for (std::size_t q = 0; q < 2; ++q) {
    EXPECT_EQ(b.quantities[q].name, a.quantities[q].name);
    EXPECT_EQ(b.quantities[q].label, a.quantities[q].label);
    EXPECT_EQ(b.quantities[q].unit, a.quantities[q].unit);
    EXPECT_EQ(b.quantities[q].start, a.quantities[q].start);
    EXPECT_EQ(b.quantities[q].now, a.quantities[q].now);
    EXPECT_EQ(b.quantities[q].defined, a.quantities[q].defined);
  }
  ASSERT_EQ(b.stages.size(), 1U);
  EXPECT_EQ(b.stages[0].name, "p2g");
  EXPECT_EQ(b.stages[0].label, "P2G");
  EXPECT_EQ(b.step, a.step);
  EXPECT_EQ(b.total, a.total);
  EXPECT_EQ(b.claims, a.claims);
  EXPECT_EQ(b.energy_in, a.energy_in);
  EXPECT_EQ(b.step_in, a.step_in);
  ASSERT_EQ(b.accounts.size(), 2U);
  EXPECT_EQ(b.accounts[1].step, 9U);
  EXPECT_EQ(b.accounts[1].time, 0.5);
  EXPECT_EQ(b.accounts[1].held, a.accounts[1].held);
  EXPECT_EQ(b.accounts[1].changes, a.accounts[1].changes);
}

TEST(SnapshotFile, RefusesALedgerThatDoesNotAddUp) {
  const auto refused = [](auto&& spoil) {
    LedgerTable l = example_ledger();
    spoil(l);
    Snapshot s = example();
    s.ledger = std::make_shared<LedgerTable>(l);
    const TemporaryFile file("snapshot.txt");
    save_snapshot(s, file.path());
    EXPECT_THROW((void)load_snapshot(file.path()), UserError);
  };
  refused([](LedgerTable& l) { l.step.pop_back(); });
  refused([](LedgerTable& l) { l.total.push_back(0); });
  refused([](LedgerTable& l) { l.claims.pop_back(); });
  refused([](LedgerTable& l) { l.claims[0] = static_cast<LedgerTable::Claim>(3); });
  refused([](LedgerTable& l) { l.stages.clear(); });
  refused([](LedgerTable& l) { l.accounts[0].held.clear(); });
  refused([](LedgerTable& l) { l.accounts[1].changes.pop_back(); });
}

TEST(SnapshotFile, IsTheSameTextWhenSavedAgain) {
  const TemporaryFile first("first.txt"), second("second.txt");
  save_snapshot(example(), first.path());
  save_snapshot(load_snapshot(first.path()), second.path());
  EXPECT_EQ(first.content(), second.content());
}

TEST(SnapshotFile, CanBeEmpty) {
  const TemporaryFile file("empty.txt");
  save_snapshot(Snapshot(), file.path());
  const Snapshot s = load_snapshot(file.path());
  EXPECT_EQ(s.particles(), 0U);
  EXPECT_FALSE(s.history);
  EXPECT_FALSE(s.ledger);
  EXPECT_EQ(file.content().find("ledger"), std::string::npos) << "files from before the ledger stay as they are";
}

TEST(SnapshotFile, ThatCannotBeWrittenIsTheMachinesFault) {
  EXPECT_THROW(save_snapshot(Snapshot(), "/nonexistent/folder/s.txt"), MachineError);
}

TEST(Snapshot, CountsTheBytesItHolds) {
  Snapshot s;
  const std::size_t empty = s.bytes();
  s.x.assign(1000, 0);
  s.channels.push_back({"speed", "m/s", 0, 1, false, std::vector<float>(500)});
  s.lattices.push_back({"u", {10, 10, 1}, {0, 0, 0}, 1, std::vector<float>(100)});
  EXPECT_GE(s.bytes(), empty + 4 * 1600);
  const std::size_t without = s.bytes();
  auto ledger = std::make_shared<LedgerTable>();
  ledger->accounts.assign(100, {1, 0.5, std::vector<double>(6), std::vector<double>(48)});
  s.ledger = ledger;
  EXPECT_GE(s.bytes(), without + 100 * 8 * 54);
}

} // namespace
} // namespace flipbook
