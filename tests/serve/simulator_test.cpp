// SPDX-License-Identifier: MIT
// A live run and its replay: whatever a hand did, the study that is saved makes the same frames again.
#include "app/live/simulator.h"
#include "app/session/driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

namespace flipbook::app::live {
namespace {

using namespace std::chrono_literals;

/// A live run whose frames are all recorded, with somebody at the controls.
class Player {
public:
  explicit Player(const std::string& study) : simulator_(budget_, [] {}) {
    simulator_.open([study] { return parse_study(study, "played.toml"); }, "file");
    wait([&] { return simulator_.newest() != nullptr; });
    simulator_.record(true);
    frames(1);
  }

  Simulator& operator*() { return simulator_; }
  Simulator* operator->() { return &simulator_; }

  /// Steps until there are so many frames.
  void frames(std::size_t n) {
    if (recorded_.size() >= n) return;
    simulator_.play(true);
    wait([&] { return recorded_.size() >= n; });
    simulator_.play(false);
    wait([&] { return !simulator_.status().running; });
    settle();
  }
  /// Until everything asked for has happened.
  void settle() {
    const std::size_t before = saved_;
    simulator_.save();
    wait([&] { return saved_ > before; });
  }
  void set(const std::string& path, Value value, int pane = -1) { simulator_.edit(pane, {path, std::move(value)}); }

  [[nodiscard]] const std::vector<LiveFrame>& recorded() const { return recorded_; }
  [[nodiscard]] const Study& study() const { return study_; }
  [[nodiscard]] const std::vector<std::string>& errors() const { return errors_; }

private:
  template <class Done> void wait(Done&& done) {
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (!done()) {
      ASSERT_LT(std::chrono::steady_clock::now(), end) << "it never happens";
      if (auto frame = simulator_.take_recorded()) recorded_.push_back(std::move(*frame));
      for (const Report& r : simulator_.take_reports()) {
        if (r.what == Report::What::message) errors_.push_back(r.text);
        if (r.what == Report::What::save) study_ = *r.study, ++saved_;
      }
      std::this_thread::sleep_for(1ms);
    }
  }

  Budget budget_{2};
  std::vector<LiveFrame> recorded_;
  std::vector<std::string> errors_;
  Study study_;
  std::size_t saved_ = 0;
  Simulator simulator_;
};

/// The frames of an offline run.
std::vector<Bundle> replayed(const std::string& study) {
  const Resolved resolved = resolve(parse_study(study, "saved.toml"));
  Budget budget(2);
  Exchange<Bundle> out(std::size_t{1} << 30U);
  Driver driver(
      resolved, Schedule::video(resolved.output.fps, resolved.scale, resolved.frames), budget, out,
      [] { return false; }, nullptr, nullptr);
  std::thread thread([&] { driver.drive(); });
  std::vector<Bundle> bundles;
  while (auto b = out.take()) bundles.push_back(std::move(*b));
  thread.join();
  return bundles;
}

/// A curve has gaps where it is not defined.
bool same_curve(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

void expect_same(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.dt, b.dt);
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    EXPECT_EQ(a.channels[c].name, b.channels[c].name);
    EXPECT_EQ(a.channels[c].lo, b.channels[c].lo);
    EXPECT_EQ(a.channels[c].hi, b.channels[c].hi);
    EXPECT_EQ(a.channels[c].values, b.channels[c].values);
  }
  ASSERT_EQ(a.parameters.size(), b.parameters.size());
  for (std::size_t p = 0; p < a.parameters.size(); ++p)
    EXPECT_EQ(a.parameters[p].value, b.parameters[p].value) << a.parameters[p].path;
  ASSERT_EQ(a.solids.size(), b.solids.size());
  for (std::size_t s = 0; s < a.solids.size(); ++s) EXPECT_EQ(a.solids[s].pose.shift, b.solids[s].pose.shift);
  ASSERT_EQ(a.history->columns.size(), b.history->columns.size());
  for (std::size_t c = 0; c < a.history->columns.size(); ++c)
    EXPECT_TRUE(same_curve(a.history->columns[c].y, b.history->columns[c].y)) << a.history->columns[c].name;
}

void expect_replay(const Player& player, std::size_t least) {
  EXPECT_TRUE(player.errors().empty()) << player.errors().front();
  const std::string saved = to_toml(player.study());
  const std::vector<Bundle> again = replayed(saved);
  ASSERT_GE(player.recorded().size(), least);
  ASSERT_EQ(again.size(), player.recorded().size());
  for (std::size_t k = 0; k < again.size(); ++k) {
    SCOPED_TRACE("frame " + std::to_string(k));
    const Bundle& live = player.recorded()[k].bundle;
    ASSERT_EQ(live.stop.frame, k);
    EXPECT_EQ(live.stop.time, again[k].stop.time);
    ASSERT_EQ(live.snapshots.size(), again[k].snapshots.size());
    for (std::size_t i = 0; i < live.snapshots.size(); ++i) expect_same(*live.snapshots[i], *again[k].snapshots[i]);
    render::ViewSettings a = live.view, b = again[k].view;
    const auto seen = parameters_of(a), seen_again = parameters_of(b);
    for (std::size_t p = 0; p < seen.size(); ++p) EXPECT_EQ(seen[p].value, seen_again[p].value) << seen[p].path;
    if (testing::Test::HasFailure()) return;
  }
}

Hold hold(Hold::What what, Triple at, std::uint32_t press, int variant = -1) {
  Hold h;
  h.what = what;
  h.variant = variant;
  h.at = at;
  h.radius = 0.12;
  h.press = press;
  return h;
}

const std::string two_panes = R"(
scene = "dam_break"
grid.cells = [24, 24]
output.fps = 60
[[variant]]
transfer.scheme = "flip"
[[variant]]
transfer.scheme = "apic"
[[key]]
t = 0.05
over = 0.2
variant = 1
transfer.flip_ratio = 0.2
)";

TEST(Simulator, ParametersThatAHandMovedMoveAgain) {
  Player player(two_panes);
  player.frames(3);
  player.set("transfer.scheme", std::string("aflip"), 1); // while it is paused,
  player.set("transfer.flip_ratio", 0.7, 1);              // one after the other
  player.set("view.azimuth", 12.5);
  player.frames(6);
  player.set("transfer.flip_ratio", 0.4); // against the key that moves it
  player->play(true);
  player.set("fluid.gravity", std::vector<double>{2, -9, 0}); // while it runs
  player.frames(12);
  player.set("view.colour", std::string("vorticity")); // not published so far
  player.set("transfer.kernel", std::string("quadratic"));
  player.frames(20);
  expect_replay(player, 20);
  const auto& channels = player.recorded().back().bundle.snapshots[0]->channels;
  EXPECT_TRUE(std::any_of(channels.begin(), channels.end(), [](auto& c) { return c.name == "vorticity"; }));
  const auto& first = player.recorded().front().bundle.view;
  EXPECT_FALSE(first.pointer);
  EXPECT_TRUE(first.steady);
}

TEST(Simulator, WhatAHandDidToTheFluidHappensAgain) {
  Player player(two_panes);
  player.frames(2);
  for (std::uint32_t i = 0; i < 8; ++i) { // while it is paused, and from frame to frame
    player->hold(hold(Hold::What::push, {0.2 + 0.02 * i, 0.3, 0}, 1));
    player.frames(3 + i);
  }
  player->hold(std::nullopt);
  player->hold(hold(Hold::What::remove, {0.2, 0.1, 0}, 2, 0));
  player.frames(13);
  player->hold(hold(Hold::What::add, {0.8, 0.8, 0}, 3, 1));
  player.frames(16);
  player->hold(std::nullopt);
  player.frames(20);
  expect_replay(player, 20);
  EXPECT_NE(player.recorded().back().bundle.snapshots[0]->particles(),
            player.recorded().back().bundle.snapshots[1]->particles());
}

TEST(Simulator, SolidsOfTheMaterialPointMethodAreReplayed) {
  Player player("scene = \"two_blocks\"\ngrid.cells = [32, 32]\noutput.fps = 120\n");
  player.frames(2);
  player->hold(hold(Hold::What::push, {0.3, 0.5, 0}, 1));
  player.frames(4);
  player->hold(hold(Hold::What::push, {0.34, 0.5, 0}, 1));
  player.frames(5);
  player->hold(hold(Hold::What::add, {0.5, 0.8, 0}, 2));
  player.frames(7);
  player->hold(hold(Hold::What::remove, {0.3, 0.5, 0}, 3));
  player.frames(9);
  player->hold(std::nullopt);
  player.frames(12);
  expect_replay(player, 12);
}

TEST(Simulator, ADraggedObstacleIsReplayed) {
  Player player("scene = \"drop_on_sphere\"\ngrid.cells = [24, 24]\ndim = 2\noutput.fps = 60\n");
  ASSERT_GT(player->status().solids, 0U);
  player.frames(2);
  for (std::uint32_t i = 0; i < 6; ++i) {
    player->hold(hold(Hold::What::solid, {0.5 + 0.03 * i, 0.3, 0}, 1));
    player.frames(3 + i);
  }
  player->hold(std::nullopt);
  player.frames(12);
  expect_replay(player, 12);
  EXPECT_NE(player.recorded().front().bundle.snapshots[0]->solids[0].pose.shift[0],
            player.recorded().back().bundle.snapshots[0]->solids[0].pose.shift[0]);
}

TEST(Simulator, ATapBetweenTwoFramesCounts) {
  Player player(two_panes);
  player.frames(2);
  const std::size_t before = player->status().particles;
  player->hold(hold(Hold::What::remove, {0.2, 0.1, 0}, 1));
  player->hold(std::nullopt);
  player.frames(4);
  EXPECT_LT(player->status().particles, before);
  EXPECT_EQ(player->status().edits, 1U); // and once
  expect_replay(player, 4);
}

TEST(Simulator, AResetKeepsWhatTheHandHasSet) {
  Player player(two_panes);
  player.set("transfer.flip_ratio", 0.25, 0);
  player.set("view.colour", std::string("pressure"));
  player.frames(4);
  player->reset();
  player.settle();
  const LiveStatus s = player->status();
  EXPECT_EQ(s.frame, 0U);
  EXPECT_EQ(s.edits, 0U);
  EXPECT_FALSE(s.recording); // which ended with the take
  EXPECT_EQ(s.take->number, 2U);
  EXPECT_EQ(s.take->resolved.variants[0].scene.settings.transfer.corner().flip_ratio, 0.25);
  EXPECT_EQ(player->newest()->bundle.view.colour, s.take->resolved.view.colour);
  EXPECT_TRUE(player.errors().empty());
}

TEST(Simulator, AnotherResolutionBeginsAgain) {
  Player player(two_panes);
  player.frames(3);
  player.set("grid.cells", std::vector<double>{16, 16});
  player.settle();
  EXPECT_EQ(player->status().take->number, 2U);
  EXPECT_EQ(player->newest()->bundle.snapshots[0]->cells[0], 16);
  player.set("grid.cells", std::vector<double>{1e9, 1e9}); // too large for any machine: the run goes on
  player.set("grid.cells", std::vector<double>{16, 17});
  player.settle();
  EXPECT_EQ(player.errors().size(), 2U);
  EXPECT_EQ(player->status().take->number, 2U);
}

TEST(Simulator, NonsenseIsRefusedAndTheRunGoesOn) {
  Player player(two_panes);
  player.set("transfer.flip_ratio", 7.0);
  player.set("transfer.flip_ratio", std::string("much"));
  player.set("no.such", 1.0);
  player.set("output.ledger", std::string("x.csv"));
  player.set("view.colour", std::string("von_mises")); // which a fluid has not
  player.set("view.panel", std::vector<std::string>{"nothing"});
  player.set("time.cfl", 0.3, 7);
  player.settle();
  EXPECT_EQ(player.errors().size(), 7U);
  player.frames(3);
  EXPECT_EQ(player->status().edits, 0U);
}

} // namespace
} // namespace flipbook::app::live
