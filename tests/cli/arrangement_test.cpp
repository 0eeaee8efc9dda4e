// SPDX-License-Identifier: MIT
// Layouts and differences from outside: what cannot be arranged is refused, and the curve of a difference is the same
// for a video and for a still.
#include "app/session/differences.h"
#include "sim/frame/parameters.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace flipbook::test {
namespace {

using Words = std::vector<std::string>;
using render::DifferenceOf;

Words tiny(Words words) {
  words.insert(words.end(), {"--cells", "16", "--frames", "3", "--size", "320x180", "-q"});
  return words;
}

struct Case {
  const char* name;
  Words arguments, says;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class WrongArrangement : public testing::TestWithParam<Case> {};

TEST_P(WrongArrangement, IsRefused) {
  const Folder f;
  expect_refusal(run(tiny(GetParam().arguments), f.path()), 2, GetParam().says);
  EXPECT_THAT(f.files(), testing::IsEmpty());
}

const Case wrong[] = {
    {"split_of_one",
     {"compare", "dam_break", "--schemes", "apic", "--set", "view.layout=split"},
     {"--set", "view.layout = \"split\"", "takes two panes, and there is one"}},
    {"difference_of_one",
     {"compare", "dam_break", "--schemes", "apic", "--set", "view.difference=speed"},
     {"view.difference takes two panes"}},
    {"pair_too_far",
     {"compare", "dam_break", "--schemes", "pic,apic", "--set", "view.layout=split", "--set", "view.pair=1,3"},
     {"view.pair = [1, 3]", "there are 2 panes"}},
    {"pair_of_one",
     {"compare", "dam_break", "--schemes", "pic,apic", "--set", "view.layout=split", "--set", "view.pair=2,2"},
     {"view.pair = [2, 2]", "two different panes"}},
    {"pair_of_nothing", {"compare", "dam_break", "--set", "view.pair=0,1"}, {"view.pair", "from 1 to 12"}},
    {"large_too_far",
     {"compare", "dam_break", "--schemes", "pic,apic", "--set", "view.layout=large", "--set", "view.large=3"},
     {"view.large = 3", "there are 2 panes"}},
    {"large_beyond_the_difference",
     {"compare", "dam_break", "--schemes", "pic,apic", "--set", "view.layout=large", "--set", "view.large=4", "--set",
      "view.difference=speed"},
     {"view.large = 4", "there are 2 panes and a difference"}},
    {"layout_misspelt", {"render", "dam_break", "--set", "view.layout=splt"}, {"splt", "\"split\""}},
    {"difference_misspelt", {"render", "dam_break", "--set", "view.difference=sped"}, {"sped", "\"speed\""}},
    {"divider_outside", {"render", "dam_break", "--set", "view.divider=1.5"}, {"view.divider", "1.5"}},
};
INSTANTIATE_TEST_SUITE_P(Each, WrongArrangement, testing::ValuesIn(wrong),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Arrangement, OfDifferentDomainsIsRefusedWithFileAndLine) {
  const Folder f;
  (void)f.write("s.toml", "[scene]\ngrid.cells = [16, 16]\nduration = 1\n[[scene.body]]\nshape = \"box\"\n"
                          "lo = [0, 0]\nhi = [0.5, 0.5]\n[[variant]]\n[[variant]]\ngrid.size = [2, 2]\n"
                          "[view]\nlayout = \"split\"\n");
  expect_refusal(run({"render", "s.toml", "-q", "--frames", "1"}, f.path()), 2,
                 {"s.toml:12:", "view.pair = [1, 2]", "different domains", "share a frame"});
}

TEST(Arrangement, OfAKeyIsCheckedWhereTheKeyIs) {
  const Folder f;
  const std::string scene =
      "scene = \"dam_break\"\n[[variant]]\ntransfer.scheme = \"pic\"\n[[variant]]\n[[key]]\nt = 0.1\n";
  (void)f.write("s.toml", scene + "view.difference = \"speed\"\nview.pair = [1, 4]\n");
  expect_refusal(run(tiny({"render", "s.toml"}), f.path()), 2, {"s.toml:8:", "[1, 4]", "there are 2 panes"});
}

TEST(Arrangement, OfAnEditIsCheckedWhereTheEditIs) {
  const Folder f;
  (void)f.write("s.toml", "scene = \"dam_break\"\n[[edit]]\nt = 0.1\nview.layout = \"split\"\n");
  expect_refusal(run(tiny({"render", "s.toml"}), f.path()), 2, {"s.toml:", "takes two panes"});
}

/// Divider, large pane and compared pair move; the video's frame 5 is the still of its time, curve and all.
TEST(Arrangement, AStillHasTheCurveOfTheVideo) {
  const Folder f;
  (void)f.write("s.toml", R"(
scene = "dam_break"
grid.cells = [24, 24]
[[variant]]
transfer.scheme = "pic"
[[variant]]
transfer.scheme = "flip"
[[variant]]
transfer.scheme = "apic"
[[key]]
t = 0.05
over = 0.2
view.divider = 0.8
[[key]]
t = 0.1
view.pair = [3, 1]
[[key]]
t = 0.2
view.difference = "density"
[view]
layout = "split"
difference = "speed"
[output]
fps = 20
frames = 6
size = [640, 360]
)");
  const auto must_run = [&](const Words& words) {
    const Outcome o = run(words, f.path());
    ASSERT_EQ(o.code, 0) << o.err;
  };
  must_run({"render", "s.toml", "-q", "--threads", "1", "-o", "one/"});
  must_run({"render", "s.toml", "-q", "--threads", "3", "-o", "three/"});
  must_run({"still", "s.toml", "-q", "--at", "0.15,0.25", "-o", "still/"});
  std::vector<std::string> stills;
  for (const std::string& name : f.files())
    if (name.starts_with("still/") && name.ends_with(".png")) stills.push_back(read_file(f.path() / name));
  ASSERT_EQ(stills.size(), 2U);
  EXPECT_TRUE(stills[0] == read_file(f.path() / "one/frame_000003.png"));
  EXPECT_TRUE(stills[1] == read_file(f.path() / "one/frame_000005.png"));
  for (int k = 0; k < 6; ++k) {
    const std::string name = "frame_00000" + std::to_string(k) + ".png";
    EXPECT_TRUE(read_file(f.path() / "one" / name) == read_file(f.path() / "three" / name)) << name;
  }
}

/// Neither --cells, which asks about the scene's domain, nor --vary and mistakes, which make the panes, mind the view.
TEST(Arrangement, IsOfThePanesThatThereAreInTheEnd) {
  const Folder f;
  const Words view{"--set", "view.layout=split", "--set", "view.difference=speed", "-o", "a/"};
  const auto made = [&](Words words) {
    words = tiny(words);
    words.insert(words.end(), view.begin(), view.end());
    const Outcome o = run(words, f.path());
    EXPECT_EQ(o.code, 0) << o.err;
  };
  made({"compare", "dam_break", "--schemes", "pic,apic"});
  made({"compare", "dam_break", "--vary", "transfer.flip_ratio=0,1"});
  made({"compare", "dam_break", "--schemes", "apic", "--with-mistake", "reversed_offset"});
}

/// Particles from files are compared like simulated ones: and what cannot be is refused.
TEST(Arrangement, OfASeriesIsChecked) {
  const Folder f;
  const Words view{"--set", "view.layout=split",     "--set", "view.difference=surface",
                   "--set", "view.plots=difference", "--set", "view.show_panel=false",
                   "--set", "view.captions=false"};
  const auto with = [&](Words words, const Words& more) {
    words.insert(words.end(), view.begin(), view.end());
    words.insert(words.end(), more.begin(), more.end());
    return run(words, f.path());
  };
  const Outcome first = with(tiny({"compare", "dam_break", "--schemes", "pic,apic"}), {"--particles", "p", "-o", "a/"});
  ASSERT_EQ(first.code, 0) << first.err;
  const Outcome again = with({"render", "p", "--size", "320x180", "-q"}, {"-o", "b/"});
  ASSERT_EQ(again.code, 0) << again.err;
  for (int k = 0; k < 3; ++k)
    EXPECT_TRUE(std::filesystem::exists(f.path() / "b" / ("frame_00000" + std::to_string(k) + ".png")));
  const Outcome third =
      run({"render", "p", "-q", "--set", "view.difference=speed", "--set", "view.pair=1,3", "-o", "c/"}, f.path());
  expect_refusal(third, 2, {"view.pair = [1, 3]", "there are 2 panes"});
}

// === The record

/// A particle in each of 8 x 8 cells, all as fast as that.
std::shared_ptr<const Snapshot> moving(float speed) {
  auto s = std::make_shared<Snapshot>();
  s->cells = {8, 8, 1};
  s->dx = 0.125;
  s->particle_spacing = 0.125;
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) {
      s->x.insert(s->x.end(), {0.125F * (static_cast<float>(i) + 0.5F), 0.125F * (static_cast<float>(j) + 0.5F)});
      s->v.insert(s->v.end(), {speed, 0});
      s->id.push_back(static_cast<std::uint32_t>(s->id.size()));
    }
  return s;
}

render::ViewSettings comparing(DifferenceOf of, std::array<int, 2> pair = {1, 2}) {
  render::ViewSettings view;
  view.arrangement.difference = of;
  view.arrangement.pair = pair;
  return view;
}

TEST(Differences, KeepARowForEachFrame) {
  const render::ViewSettings view = comparing(DifferenceOf::speed);
  app::Differences d(std::vector{view});
  for (const float t : {0.F, 1.F, 2.F}) d.add(view, static_cast<double>(t), std::vector{moving(2 * t), moving(t)});
  d.add(view, 2, std::vector{moving(9), moving(0)}); // the frame is there already
  const auto so_far = d.of(view);
  ASSERT_TRUE(so_far);
  EXPECT_EQ(so_far->curve.t, (std::vector<float>{0, 1, 2}));
  ASSERT_EQ(so_far->curve.columns.size(), 1U);
  EXPECT_EQ(so_far->curve.columns[0].name, "difference");
  EXPECT_EQ(so_far->curve.columns[0].unit, "m/s");
  EXPECT_EQ(so_far->curve.columns[0].y, (std::vector<float>{0, 1, 2}));
  EXPECT_EQ(so_far->most, 2);
  EXPECT_FALSE(d.of({})) << "a view that compares nothing";
}

/// Keys are known from the start; what a hand chooses is measured from there on, and a glimpse is not kept.
TEST(Differences, BeginWithWhatKeysAndHandsCompare) {
  const render::ViewSettings now = comparing(DifferenceOf::speed), later = comparing(DifferenceOf::speed, {2, 1}),
                             by_hand = comparing(DifferenceOf::density);
  app::Differences d(std::vector{now, later});
  const std::vector panes{moving(1), moving(0)};
  d.add(now, 0, panes);
  EXPECT_EQ(d.of(later)->curve.t.size(), 1U);
  EXPECT_FALSE(d.of(by_hand));
  EXPECT_EQ(d.glimpse(by_hand, 0, panes)->curve.t.size(), 1U);
  EXPECT_FALSE(d.of(by_hand));
  d.add(by_hand, 1, panes);
  EXPECT_EQ(d.of(by_hand)->curve.t, (std::vector<float>{1}));
  EXPECT_EQ(d.of(now)->curve.t, (std::vector<float>{0, 1}));
  EXPECT_FALSE(d.of(comparing(DifferenceOf::speed, {1, 3})));
  d.add(comparing(DifferenceOf::speed, {1, 3}), 2, panes); // a pane that is not there has no row
  EXPECT_TRUE(d.of(comparing(DifferenceOf::speed, {1, 3}))->curve.t.empty());
}

} // namespace
} // namespace flipbook::test
