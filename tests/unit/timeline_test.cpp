// SPDX-License-Identifier: MIT
#include "app/study/resolve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flipbook::app {
namespace {

const std::string scene = "[scene]\ngrid.cells = [16, 16]\nduration = 2\n[[scene.body]]\nshape = \"box\"\n"
                          "lo = [0, 0]\nhi = [1, 0.5]\n";
const std::string panes = "[[variant]]\ntransfer.scheme = \"flip\"\ntransfer.flip_ratio = 0.8\n"
                          "[[variant]]\ntransfer.scheme = \"apic\"\n"
                          "[[variant]]\nlabel = \"other\"\ntransfer.scheme = \"flip\"\ntransfer.flip_ratio = 0.2\n";

Resolved with_keys(const std::string& keys, const std::string& settings = "") {
  return resolve(parse_study(settings + "output.fps = 10\n" + scene + panes + keys, "s.toml"));
}

double ratio(const Resolved& r, int variant, double t) {
  return std::get<double>(r.timeline.value(variant, "transfer.flip_ratio", t, -1.0));
}

/// 0.8 -> 0.4 with s^2 (3 - 2 s), s = t - 0.5.
TEST(Timeline, EasesFromTheValueThatIsThere) {
  const Resolved r = with_keys("[[key]]\nt = 0.5\nover = 1\ntransfer.flip_ratio = 0.4\n");
  EXPECT_DOUBLE_EQ(ratio(r, 0, 0), 0.8);
  EXPECT_DOUBLE_EQ(ratio(r, 0, 0.5), 0.8);
  EXPECT_DOUBLE_EQ(ratio(r, 0, 0.75), 0.8 - 0.4 * 0.15625);
  EXPECT_DOUBLE_EQ(ratio(r, 0, 1), 0.6);
  EXPECT_DOUBLE_EQ(ratio(r, 0, 1.5), 0.4);
  EXPECT_DOUBLE_EQ(ratio(r, 0, 9), 0.4);
  EXPECT_DOUBLE_EQ(ratio(r, 2, 1), 0.3) << "each variant from its own value";
  EXPECT_DOUBLE_EQ(ratio(r, 1, 1), -1) << "APIC has no such parameter";
}

TEST(Timeline, KnowsTheOtherEases) {
  const Resolved linear = with_keys("[[key]]\nt = 0.5\nover = 1\nease = \"linear\"\ntransfer.flip_ratio = 0.4\n");
  EXPECT_DOUBLE_EQ(ratio(linear, 0, 0.75), 0.7);
  const Resolved step = with_keys("[[key]]\nt = 0.5\nover = 1\nease = \"step\"\ntransfer.flip_ratio = 0.4\n");
  EXPECT_DOUBLE_EQ(ratio(step, 0, 0.4999), 0.8);
  EXPECT_DOUBLE_EQ(ratio(step, 0, 0.5), 0.4);
  const Resolved at_once = with_keys("[[key]]\nt = 0.5\ntransfer.flip_ratio = 0.4\n");
  EXPECT_DOUBLE_EQ(ratio(at_once, 0, 0.4999), 0.8);
  EXPECT_DOUBLE_EQ(ratio(at_once, 0, 0.5), 0.4);
}

TEST(Timeline, LabelsHoldUntilTheNextOne) {
  const std::string keys = "[[key]]\nt = 0.5\nlabel = \"first\"\n"
                           "[[key]]\nt = 0.75\ntransfer.flip_ratio = 0.4\n"
                           "[[key]]\nt = 1\nlabel = \"second\"\ntransfer.flip_ratio = 0.5\ntransfer.affine = 0.5\n";
  const Resolved r = with_keys(keys);
  EXPECT_EQ(r.timeline.label(0.4999), "");
  EXPECT_EQ(r.timeline.label(0.5), "first");
  EXPECT_EQ(r.timeline.label(0.9), "first") << "a key without a label does not end it";
  EXPECT_EQ(r.timeline.label(1), "second");
  EXPECT_EQ(r.timeline.label(9), "second");
  EXPECT_TRUE(r.timeline.has_labels());
  EXPECT_DOUBLE_EQ(ratio(r, 0, 1), 0.5);
  EXPECT_FALSE(with_keys("[[key]]\nt = 0.75\ntransfer.flip_ratio = 0.4\n").timeline.has_labels());
}

TEST(Timeline, AKeyMayOnlyHaveALabel) {
  const Study study =
      parse_study("output.fps = 10\n" + scene + panes + "[[key]]\nt = 0.5\nlabel = \"a \\\"b\\\"\"\n", "s.toml");
  const Study again = parse_study(to_toml(study), "s.toml");
  ASSERT_EQ(again.keys.size(), 1U);
  EXPECT_EQ(again.keys[0].label, "a \"b\"");
  EXPECT_EQ(resolve(again).timeline.label(1), "a \"b\"");
  EXPECT_TRUE(resolve(again).commands().empty());
  EXPECT_THROW((void)with_keys("[[key]]\nt = 0.5\n"), UserError);
  EXPECT_THROW((void)with_keys("[[key]]\nt = 0.5\nvariant = 1\nlabel = \"a\"\n"), UserError);
}

TEST(Timeline, ANewKeyTakesOverInMidMove) {
  const Resolved r = with_keys("[[key]]\nt = 0\nover = 1\nease = \"linear\"\ntransfer.flip_ratio = 0\n"
                               "[[key]]\nt = 0.5\nover = 1\nease = \"linear\"\ntransfer.flip_ratio = 1\n");
  EXPECT_DOUBLE_EQ(ratio(r, 0, 0.5), 0.4);
  EXPECT_DOUBLE_EQ(ratio(r, 0, 1), 0.7);
  EXPECT_DOUBLE_EQ(ratio(r, 0, 1.5), 1);
}

TEST(Timeline, PicksAVariantByLabelTitleOrScheme) {
  for (const char* name : {"other", "OTHER", "FLIP 0.2", "flip 0.2"}) {
    const Resolved r =
        with_keys(std::string("[[key]]\nt = 0\nvariant = \"") + name + "\"\ntransfer.flip_ratio = 0.5\n");
    EXPECT_DOUBLE_EQ(ratio(r, 0, 1), -1) << name;
    EXPECT_DOUBLE_EQ(ratio(r, 2, 1), 0.5) << name;
  }
  const Resolved both = with_keys("[[key]]\nt = 0\nvariant = \"flip\"\ntransfer.flip_ratio = 0.5\n");
  EXPECT_DOUBLE_EQ(ratio(both, 0, 1), 0.5);
  EXPECT_DOUBLE_EQ(ratio(both, 2, 1), 0.5);
}

TEST(Timeline, CommandsSayWhatChangesFromFrameToFrame) {
  const Resolved r =
      with_keys("[[key]]\nt = 0.5\nover = 0.2\nease = \"linear\"\ntransfer.flip_ratio = 0.4\nvariant = \"other\"\n"
                "[[key]]\nt = 1\ntime.cfl = 0.25\n");
  const CommandLog log = r.commands();
  ASSERT_EQ(log.size(), 5U);
  // Frame 5 stands at t = 0.5, where the move begins; 6 is half way and 7 the end.
  EXPECT_EQ(log[0].frame, 6U);
  EXPECT_EQ(log[0].variant, 2);
  EXPECT_NEAR(std::get<double>(std::get<SetParameter>(log[0].action).value), 0.3, 1e-12);
  EXPECT_EQ(log[1].frame, 7U);
  EXPECT_EQ(std::get<SetParameter>(log[1].action).value, Value(0.4));
  for (std::size_t i = 2; i < 5; ++i) {
    EXPECT_EQ(log[i].frame, 10U);
    EXPECT_EQ(log[i].variant, static_cast<int>(i) - 2);
    EXPECT_EQ(std::get<SetParameter>(log[i].action).path, "time.cfl");
  }
}

TEST(Timeline, RunsInSimulatedTime) {
  const CommandLog log = with_keys("[[key]]\nt = 1\ntime.cfl = 0.25\n", "time.scale = 0.5\n").commands();
  ASSERT_EQ(log.size(), 3U);
  EXPECT_EQ(log[0].frame, 20U) << "1 s simulated is 2 s of video at 10 frames a second";
}

TEST(Timeline, FollowsAChangeOfScheme) {
  const Resolved r = with_keys("[[key]]\nt = 0.5\nvariant = \"apic\"\ntransfer.scheme = \"flip\"\n"
                               "[[key]]\nt = 1\nover = 1\nease = \"linear\"\ntransfer.flip_ratio = 0\n");
  EXPECT_EQ(r.timeline.value(1, "transfer.scheme", 0.6, false), Value(std::string("flip")));
  EXPECT_DOUBLE_EQ(ratio(r, 1, 1.5), 0.5) << "from FLIP's own 1";
}

TEST(Timeline, PicksAVariantByNumber) {
  const Resolved one = with_keys("[[key]]\nt = 0\nvariant = 3\ntransfer.flip_ratio = 0.5\n");
  EXPECT_DOUBLE_EQ(ratio(one, 0, 1), -1);
  EXPECT_DOUBLE_EQ(ratio(one, 2, 1), 0.5);
  const Resolved two = with_keys("[[key]]\nt = 0\nvariant = [1, 3]\ntransfer.flip_ratio = 0.5\n");
  EXPECT_DOUBLE_EQ(ratio(two, 0, 1), 0.5);
  EXPECT_DOUBLE_EQ(ratio(two, 2, 1), 0.5);
}

TEST(Timeline, PinnedKeysKeepTheirVariantWhateverItBecomes) {
  Study s = parse_study(scene + panes + "[[key]]\nt = 1\nvariant = \"FLIP 0.8\"\ntransfer.flip_ratio = 0\n", "s.toml");
  pin_keys(s);
  assign(s, {"transfer.flip_ratio", 0.5, {}});
  const Resolved r = resolve(s);
  EXPECT_DOUBLE_EQ(ratio(r, 0, 1), 0);
  EXPECT_DOUBLE_EQ(ratio(r, 2, 1), -1);
  assign(s, {"transfer.scheme", std::string("pic"), {}});
  EXPECT_EQ(drop_idle_keys(s, resolve(s)).size(), 1U);
  EXPECT_TRUE(s.keys.empty());
}

TEST(Timeline, MovesTheViewAndAsksForAllThatItWillShow) {
  const Resolved r = with_keys("[[key]]\nt = 0.5\nover = 1\nease = \"linear\"\nview.particle_size = 3\n"
                               "[[key]]\nt = 1\nview.colour = \"vorticity\"\nview.arrows = true\n",
                               "view.colour = \"speed\"\nview.range = [0, 3]\nview.particle_size = 1\n");
  EXPECT_TRUE(r.commands().empty()) << "no solver has such a parameter";
  const auto view = [&](double t) { return r.timeline.view(t, r.view); };
  EXPECT_TRUE(r.timeline.moves("view.particle_size"));
  EXPECT_FALSE(r.timeline.moves("view.azimuth"));
  EXPECT_DOUBLE_EQ(view(0).particle_size, 1);
  EXPECT_DOUBLE_EQ(view(1).particle_size, 2);
  EXPECT_FALSE(view(0.9).arrows);
  EXPECT_TRUE(view(1).arrows);
  EXPECT_EQ(view(0.9).colour, r.view.colour);
  EXPECT_NE(view(1).colour, r.view.colour);
  EXPECT_EQ(view(0.9).range[1], 3);
  EXPECT_EQ(view(1).range[1], 0) << "a range belongs to the quantity that it was written for";
  const FrameRequest request = r.request();
  EXPECT_EQ(request.channels, (std::vector<std::string>{"speed", "vorticity"}));
  EXPECT_TRUE(request.faces);
  EXPECT_FALSE(request.noise);
}

TEST(Timeline, AsksForTheLatticesAndTrailsThatKeysShow) {
  const Resolved r = with_keys("[[key]]\nt = 0.5\nview.style = \"field\"\nview.colour = \"pressure\"\n"
                               "[[key]]\nt = 1\nover = 1\nview.trails = 0.5\nview.cell_types = true\n");
  const FrameRequest request = r.request();
  EXPECT_EQ(request.fields, (std::vector<std::string>{"pressure"}));
  EXPECT_TRUE(request.surface);
  EXPECT_TRUE(request.cells);
  EXPECT_EQ(request.trails, 0.5);
  EXPECT_FALSE(with_keys("").request().surface);
}

TEST(Timeline, AsksForTheNoiseThatAKeyPlots) {
  const Resolved r = with_keys("[[key]]\nt = 1\nview.plots = [\"noise\"]\nview.ledger = \"step\"\n");
  EXPECT_TRUE(r.request().noise);
  EXPECT_EQ(r.timeline.view(0.9, r.view).ledger, render::LedgerView::off);
  EXPECT_EQ(r.timeline.view(1, r.view).ledger, render::LedgerView::step);
}

TEST(Timeline, RoundsWholeNumbers) {
  const Resolved r = with_keys("[[key]]\nt = 0\nover = 1\nease = \"linear\"\npressure.max_iterations = 1001\n");
  EXPECT_EQ(r.timeline.value(0, "pressure.max_iterations", 0.3333, 0.0), Value(1667.0));
}

TEST(Timeline, HasAPointerThatTravelsHoldsAndLeaves) {
  const Resolved r = with_keys("[[key]]\nt = 1\nover = 0.5\nvariant = \"other\"\ntransfer.flip_ratio = 0.4\n");
  const auto at = [&](double t) { return r.timeline.pointer_targets(t, r.scale); };
  for (const double t : {0.0, 0.29, 2.21}) {
    ASSERT_EQ(at(t).size(), 1U) << "the panel shows the row from the first frame on";
    EXPECT_EQ(at(t)[0].grip, 0) << "0.6 s on the way, and 0.1 s before the move";
    EXPECT_FALSE(at(t)[0].pressed);
  }
  ASSERT_EQ(at(0.6).size(), 1U);
  EXPECT_EQ(at(0.6)[0].path, "transfer.flip_ratio");
  EXPECT_EQ(at(0.6)[0].variant, 2);
  EXPECT_NEAR(at(0.6)[0].grip, 0.5, 1e-12);
  EXPECT_FALSE(at(0.6)[0].pressed);
  for (const double t : {0.95, 1.0, 1.25, 1.5}) {
    ASSERT_EQ(at(t).size(), 1U);
    EXPECT_EQ(at(t)[0].grip, 1);
    EXPECT_TRUE(at(t)[0].pressed);
  }
  double last = 0;
  for (double t = 0.31; t < 1; t += 0.01) {
    EXPECT_GE(at(t)[0].grip, last) << "comes without turning back";
    last = at(t)[0].grip;
  }
}

TEST(Timeline, PointsAtTheSharedRowWhereAllVariantsMove) {
  const Resolved r = with_keys("[[key]]\nt = 1\ntime.cfl = 0.25\n[[key]]\nt = 1.5\ntransfer.flip_ratio = 1\n");
  const auto first = r.timeline.pointer_targets(1, r.scale);
  ASSERT_GE(first.size(), 1U);
  EXPECT_EQ(first[0].path, "time.cfl") << "the firmest grip first";
  EXPECT_EQ(first[0].variant, -1);
  const auto second = r.timeline.pointer_targets(1.5, r.scale);
  ASSERT_GE(second.size(), 2U);
  EXPECT_EQ(second[0].variant, 0);
  EXPECT_EQ(second[1].variant, 2);
}

/// The hand drags the slider of the divider; other keys of the view have no row.
TEST(Timeline, PointsAtTheDivider) {
  const Resolved r = with_keys("[[key]]\nt = 1\nover = 0.5\nview.divider = 0.75\nview.zoom = 2\n",
                               "view.layout = \"split\"\nview.divider = 0.25\n");
  const auto targets = r.timeline.pointer_targets(1.25, r.scale);
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_EQ(targets[0].path, "view.divider");
  EXPECT_EQ(targets[0].variant, -1);
  EXPECT_TRUE(targets[0].pressed);
  EXPECT_DOUBLE_EQ(r.timeline.view(1.25, r.view).arrangement.divider, 0.5);
  EXPECT_EQ(r.timeline.views(r.view).size(), 5U) << "at the start, and where either move begins and ends";
}

} // namespace
} // namespace flipbook::app
