// SPDX-License-Identifier: MIT
// What panes with preset = "tutorial" say about themselves, refuse and publish.
#include "sim/transfer/schemes.h"
#include "tests/physics/tutorial_input.h"
#include "tests/unit/message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace flipbook::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Scene block(int scheme = scheme_index<Flip>) {
  Scene scene = notes_scene(notes_block(false), 0.95);
  scene.settings.transfer.scheme = scheme;
  return scene;
}

Parameter parameter(const std::vector<Parameter>& all, const std::string& path) {
  for (const Parameter& p : all)
    if (p.path == path) return p;
  throw std::out_of_range(path);
}

const Channel& channel(const Snapshot& s, const std::string& name) {
  for (const Channel& c : s.channels)
    if (c.name == name) return c;
  throw std::out_of_range(name);
}

// === Snapshots

TEST(TutorialPane, ShowsTheNotesWorld) {
  Running run(block());
  run.steps(2);
  const auto s = run.simulation->snapshot(7, {});
  EXPECT_EQ(s->title, "FLIP 0.95");
  EXPECT_EQ(s->scheme, "flip");
  EXPECT_THAT(s->solver, HasSubstr("fluid notes"));
  ASSERT_EQ(s->notes.size(), 1U);
  EXPECT_THAT(s->notes[0], HasSubstr("The fluid notes' algorithm: "));
  EXPECT_EQ(s->frame, 7U);
  EXPECT_EQ(s->steps, 2U);
  EXPECT_EQ(s->dt, notes_dt);
  EXPECT_GT(s->pressure_iterations, 0);
  EXPECT_LE(s->pressure_residual, 1e-3);
  EXPECT_EQ(s->lo, notes_lc);
  EXPECT_NEAR(s->hi[1], 0.065, 1e-15);
  EXPECT_EQ(s->cells, notes_res);
  EXPECT_EQ(s->dx, notes_h);
  EXPECT_EQ(s->particle_spacing, notes_h / 2);
  EXPECT_EQ(s->up, (std::array<double, 3>{0, 0, 1}));
}

TEST(TutorialPane, PublishesWhatIsAskedFor) {
  Running run(block());
  run.steps(40);
  const auto s =
      run.simulation->snapshot(1, {{"speed", "velocity_z", "initial_z", "id", "pressure"}, true, false, true});
  ASSERT_EQ(s->lattices.size(), 4U);
  EXPECT_EQ(s->lattices[1].n, (std::array<int, 3>{14, 18, 16}));
  EXPECT_FLOAT_EQ(s->lattices[1].origin[1], -0.105F);
  EXPECT_FLOAT_EQ(s->lattices[1].origin[2], -0.07F);
  EXPECT_EQ(s->lattices[3].name, "p");
  const ParticleTable table = run.simulation->particle_table();
  for (std::size_t p = 0; p < s->particles(); ++p) {
    const std::size_t id = s->id[p];
    EXPECT_EQ(channel(*s, "id").values[p], static_cast<float>(id));
    EXPECT_EQ(s->x[3 * p + 2], static_cast<float>(table.columns[2].values[id]));
    EXPECT_EQ(channel(*s, "velocity_z").values[p], static_cast<float>(table.columns[5].values[id]));
    EXPECT_EQ(channel(*s, "initial_z").values[p], static_cast<float>(notes_block(false).x[id][2]));
  }
  EXPECT_GT(channel(*s, "speed").hi, 0.1);
}

/// At rest in a full tank the pressure is that of the column above.
TEST(TutorialPane, PressureIsInPascals) {
  ParticleRows rows;
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 30; ++j)
      for (int k = 0; k < 14; ++k) {
        rows.x.push_back({-0.0775 + 0.005 * i, -0.0925 + 0.005 * j, -0.0625 + 0.005 * k});
        rows.v.push_back({});
      }
  Running run(notes_scene(rows, 0.95));
  run.steps(1);
  const auto s = run.simulation->snapshot(0, {{"pressure"}, false, false, false});
  for (std::size_t p = 0; p < s->particles(); ++p) {
    const double depth = 0.01 - static_cast<double>(s->x[3 * p + 2]); // air begins at the centre of an empty cell
    if (s->x[3 * p + 2] > -0.06F) {
      EXPECT_NEAR(channel(*s, "pressure").values[p], 9806.65 * depth, 3);
    }
  }
}

TEST(TutorialPane, RefusesQuantitiesThatTheNotesLack) {
  Running run(block());
  const auto ask = [&](const FrameRequest& r) { return message_of([&] { (void)run.simulation->snapshot(0, r); }); };
  EXPECT_THAT(ask({{"vorticity"}, false, false, false}), HasSubstr("no particle quantity \"vorticity\""));
  EXPECT_THAT(ask({{"sped"}, false, false, false}), HasSubstr("\"speed\""));
  EXPECT_THAT(ask({{}, false, true, false}), HasSubstr("no level set"));
}

TEST(TutorialPane, EnergiesAddUp) {
  Running run(block());
  const auto at = [](const Snapshot& s, const std::string& name) {
    for (const auto& c : s.history->columns)
      if (c.name == name) return static_cast<double>(c.y.back());
    throw std::out_of_range(name);
  };
  const auto before = run.simulation->snapshot(0, {});
  run.steps(10); // before the floor is felt
  const auto after = run.simulation->snapshot(1, {});
  std::vector<std::string> names;
  for (const auto& c : after->history->columns) names.push_back(c.name);
  EXPECT_THAT(names,
              ElementsAre("kinetic", "potential", "total", "transfer_loss", "momentum_x", "momentum_y", "momentum_z",
                          "angular_momentum_x", "angular_momentum_y", "angular_momentum_z", "front", "height"));
  const double mass = 1000 * std::pow(notes_h / 2, 3) * static_cast<double>(run.simulation->particles());
  const double speed = 9.80665 * notes_dt * 10; // of free fall
  EXPECT_NEAR(at(*after, "kinetic"), mass * speed * speed / 2, 1e-5 * mass * speed * speed);
  EXPECT_NEAR(at(*after, "momentum_z"), -mass * speed, 1e-5 * mass * speed);
  EXPECT_NEAR(at(*after, "transfer_loss"), 0, 1e-6 * mass);
  // Forward Euler moves with the velocity from before gravity: it falls less far than its speed says.
  EXPECT_NEAR(at(*after, "total") - at(*before, "total"), mass * 9.80665 * notes_dt * speed / 2, 1e-6);
}

TEST(TutorialPane, TransfersOfPicLoseAndThoseOfFlip1DoNot) {
  const auto loss = [](double ratio) {
    Running run(notes_scene(notes_block(true), ratio));
    run.steps(40);
    const auto s = run.simulation->snapshot(0, {});
    return static_cast<double>(s->history->columns[3].y.back() / s->history->columns[0].y.back());
  };
  EXPECT_GT(loss(0), 0.1);
  EXPECT_LT(std::abs(loss(1)), 0.2 * loss(0));
}

// === Parameters

TEST(TutorialPane, OnlyFlipRatioMoves) {
  Running run(block());
  Simulation& s = *run.simulation;
  EXPECT_EQ(s.set("transfer.flip_ratio", 0.5).message, "");
  EXPECT_EQ(s.title(), "FLIP 0.5");
  EXPECT_NE(s.set("transfer.flip_ratio", 1.5).message, "");
  EXPECT_THAT(s.set("time.cfl", 0.2).message, HasSubstr("no use for time.cfl"));
  EXPECT_THAT(s.set("transfer.scheme", std::string("apic")).message, HasSubstr("cannot change during a run"));
  EXPECT_THAT(s.set("fluid.gravity", std::vector<double>{0, 0, -1}).message, HasSubstr("cannot change during a run"));
  const std::vector<Parameter> all = s.parameters();
  EXPECT_TRUE(parameter(all, "transfer.flip_ratio").applies);
  EXPECT_TRUE(parameter(all, "time.dt").applies);
  for (const char* path : {"time.cfl", "pressure.tolerance", "fluid.surface", "fluid.spacing", "transfer.kernel"})
    EXPECT_FALSE(parameter(all, path).applies) << path;
}

TEST(TutorialPane, ARatioOf0IsPic) {
  Running slid(block()), pic(block(scheme_index<Pic>));
  ASSERT_EQ(slid.simulation->set("transfer.flip_ratio", 0.0).message, "");
  slid.steps(5);
  pic.steps(5);
  const ParticleTable a = slid.simulation->particle_table(), b = pic.simulation->particle_table();
  for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(a.columns[c].values, b.columns[c].values);
}

// === Another scheme

TEST(TutorialPane, ASchemeThatTheNotesLackRunsOnFlipbooksMethodAndSaysSo) {
  Running run(block(scheme_index<Apic>));
  Simulation& s = *run.simulation;
  EXPECT_EQ(s.title(), "APIC (not in the notes)");
  EXPECT_EQ(s.fixed_dt(), 0);
  const auto first = s.snapshot(0, {{"initial_y"}, true, false, false});
  EXPECT_EQ(first->title, "APIC (not in the notes)");
  ASSERT_FALSE(first->notes.empty());
  EXPECT_EQ(first->notes[0], "The fluid notes have no APIC: Flipbook's method runs there, on the same particles.");
  EXPECT_EQ(first->lo, notes_lc);
  EXPECT_EQ(first->cells, notes_res);
  EXPECT_FLOAT_EQ(first->lattices[0].origin[0], -0.08F);
  EXPECT_EQ(parameter(first->parameters, "grid.cells").value, Value(std::vector<double>{14, 17, 16}));
  const ParticleRows rows = notes_block(false);
  for (std::size_t p = 0; p < first->particles(); ++p)
    for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(first->x[3 * p + a], rows.x[first->id[p]][a], 1e-8);
  for (std::size_t p = 0; p < first->particles(); ++p)
    EXPECT_NEAR(channel(*first, "initial_y").values[p], rows.x[first->id[p]][1], 1e-8);

  run.steps(20);
  const ParticleTable table = s.particle_table();
  for (std::size_t p = 0; p < rows.size(); ++p) { // nothing has reached a wall yet
    EXPECT_NEAR(table.columns[0].values[p], rows.x[p][0], 1e-3);
    EXPECT_NEAR(table.columns[2].values[p], rows.x[p][2] - 9.80665 * s.time() * s.time() / 2, 1e-3);
  }
}

TEST(TutorialPane, BothMethodsCountPotentialEnergyFromTheSameFloor) {
  Running notes(block()), own(block(scheme_index<Apic>));
  const auto a = notes.simulation->snapshot(0, {}), b = own.simulation->snapshot(0, {});
  EXPECT_EQ(a->history->columns[1].name, "potential");
  EXPECT_NEAR(a->history->columns[1].y[0], b->history->columns[1].y[0], 1e-6 * a->history->columns[1].y[0]);
}

TEST(TutorialPane, TheOtherMethodKeepsItsLiveParametersButNotItsScheme) {
  Running run(block(scheme_index<Apic>));
  Simulation& s = *run.simulation;
  EXPECT_EQ(s.set("transfer.affine", 0.5).message, "");
  EXPECT_EQ(s.title(), "APIC 0.5 (not in the notes)");
  EXPECT_THAT(s.set("transfer.scheme", std::string("flip")).message, HasSubstr("cannot change during a run"));
}

// === Scenes that it refuses

std::string refusal(const Scene& scene) {
  return message_of([&] { check_scene(scene); });
}

TEST(TutorialPane, RefusesSettingsThatContradictTheNotes) {
  const auto with = [](auto&& change) {
    Scene scene = block();
    change(scene.settings);
    return refusal(scene);
  };
  EXPECT_EQ(refusal(block()), "no error");
  EXPECT_THAT(with([](Settings& s) { s.dim = 2; }), HasSubstr("dim = 3"));
  EXPECT_THAT(with([](Settings& s) { s.precision = Precision::single; }), HasSubstr("double"));
  EXPECT_THAT(with([](Settings& s) { s.time.dt = 0; }), HasSubstr("needs time.dt"));
  EXPECT_THAT(with([](Settings& s) { s.fluid.gravity = {0, -9.81, 0}; }), HasSubstr("[0, 0, -9.80665]"));
  EXPECT_THAT(with([](Settings& s) { s.walls.axis[2] = Wall::no_slip; }), HasSubstr("free-slip"));
  EXPECT_THAT(with([](Settings& s) { s.transfer.kernel = KernelName::cubic; }), HasSubstr("linear"));
  EXPECT_THAT(with([](Settings& s) {
                s.grid.cells = {2, 2, 2};
                s.grid.size = {1, 1, 1};
              }),
              HasSubstr("3 cells or more"));
}

TEST(TutorialPane, RefusesScenesThatTheNotesProgramCannotRead) {
  Scene bodies = block();
  bodies.fluid.emplace_back();
  EXPECT_THAT(refusal(bodies), HasSubstr("not made with [[body]]"));
  Scene obstacle = block();
  obstacle.obstacles.emplace_back();
  EXPECT_THAT(refusal(obstacle), HasSubstr("no obstacles"));
  Scene moved = block();
  moved.particles[0].velocity = components_velocity({1, 0, 0}, {});
  EXPECT_THAT(refusal(moved), HasSubstr("velocities are those of the file"));
  Scene none = block();
  none.particles.clear();
  EXPECT_THAT(refusal(none), HasSubstr("no particles"));
  ParticleRows flat;
  flat.x = {{0, 0, 0}};
  flat.v = {{}};
  flat.planar = true;
  EXPECT_THAT(refusal(notes_scene(flat, 1)), HasSubstr("no z"));
}

/// The outer layer of cells is solid, and beyond it there is no grid.
TEST(TutorialPane, RefusesParticlesThatStartInTheSolidLayer) {
  const auto with = [](double x) {
    ParticleRows rows;
    rows.x = {{0, 0, 0}, {x, 0, 0}};
    rows.v = {{}, {}};
    return refusal(notes_scene(rows, 1));
  };
  EXPECT_EQ(with(-0.0799), "no error");
  EXPECT_EQ(with(0.0399), "no error");
  for (const double x : {-0.0801, 0.0401, -1.0, 1e300})
    EXPECT_THAT(with(x), HasSubstr("particle 2 of \"block.in\"")) << x;
}

} // namespace
} // namespace flipbook::test
