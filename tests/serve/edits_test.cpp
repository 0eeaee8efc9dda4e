// SPDX-License-Identifier: MIT
// The [[edit]] tables of a study.
#include "app/study/resolve.h"
#include "sim/frame/errors.h"

#include <gtest/gtest.h>

#include <string>

namespace flipbook::app {
namespace {

Study study_with(const std::string& edits) {
  return parse_study(
      "scene = \"dam_break\"\ngrid.cells = [16, 16]\n[[variant]]\ntransfer.scheme = \"flip\"\n[[variant]]\n"
      "transfer.scheme = \"apic\"\n" +
          edits,
      "here.toml");
}

std::string mistake_in(const std::string& edits) {
  try {
    (void)resolve(study_with(edits));
  } catch (const UserError& e) {
    return e.what();
  }
  return "";
}

const std::string all_kinds = R"(
[[edit]]
t = 0.1
pane = 1
transfer.flip_ratio = 0.5

[[edit]]
t = 0.1
view.azimuth = 12

[[edit]]
t = 0.2
push = { at = [0.25, 0.5], radius = 0.125, velocity = [1, -2] }

[[edit]]
t = 0.2
pane = 2
add = { at = [0.25, 0.5], radius = 0.125 }

[[edit]]
t = 0.3
remove = { at = [0.25, 0.5, 0.75], radius = 0.125 }

[[edit]]
t = 0.30000000000000004
move = { solid = 3, by = [0.1, 0], over = 0.05 }
)";

TEST(Edits, AreReadAndWrittenAgain) {
  const Study study = study_with(all_kinds);
  ASSERT_EQ(study.edits.size(), 6U);
  EXPECT_EQ(std::get<SetParameter>(study.edits[0].action).value, Value(0.5));
  const auto push = std::get<Push>(std::get<Interaction>(study.edits[2].action));
  EXPECT_EQ(push.at, (Triple{0.25, 0.5, 0}));
  EXPECT_EQ(push.velocity, (Triple{1, -2, 0}));
  EXPECT_EQ(study.edits[3].pane, 2);
  EXPECT_EQ(std::get<RemoveParticles>(std::get<Interaction>(study.edits[4].action)).at[2], 0.75);
  const auto move = std::get<MoveSolid>(std::get<Interaction>(study.edits[5].action));
  EXPECT_EQ(move.solid, 2U); // counted from 1 in a text
  EXPECT_EQ(study.edits[5].t, 0.30000000000000004);
  const std::string text = to_toml(study);
  EXPECT_EQ(to_toml(parse_study(text, "again.toml")), text);
}

TEST(Edits, ActAtTheFirstFrameThatIsNotBeforeTheirTime) {
  const Resolved r = resolve(study_with(all_kinds));
  ASSERT_EQ(r.edits.size(), 6U);
  EXPECT_EQ(r.edits[0].frame, 3U); // 0.1 s at 30 frames a second
  EXPECT_EQ(r.edits[0].variant, 0);
  EXPECT_EQ(r.edits[1].variant, -1);
  EXPECT_EQ(r.edits[4].frame, 9U);
  EXPECT_EQ(r.edits[5].frame, 10U); // a little later than frame 9
  for (std::uint64_t k = 0; k < 2000; ++k) {
    EXPECT_EQ(frame_at(r, r.time_of(k)), k);
    EXPECT_EQ(frame_at(r, std::nextafter(r.time_of(k), 1e9)), k + 1);
  }
}

TEST(Edits, MistakesAreToldWithTheirPlace) {
  EXPECT_EQ(mistake_in(all_kinds), "");
  const auto says = [](const std::string& edits, const char* what) {
    const std::string said = mistake_in(edits);
    EXPECT_NE(said.find(what), std::string::npos) << said;
    EXPECT_EQ(said.rfind("here.toml:", 0), 0U) << said;
  };
  says("[[edit]]\nt = 1\ntransfer.flip_ratoi = 0.5\n", "did you mean \"transfer.flip_ratio\"");
  says("[[edit]]\nt = 1\ngrid.cells = [8, 8]\n", "grid.cells cannot change during a run");
  says("[[edit]]\nt = 1\noutput.fps = 8\n", "holds for the whole run");
  says("[[edit]]\nt = 1\npane = 2\nview.zoom = 2\n", "the panes share the view");
  says("[[edit]]\nt = 1\npane = 3\ntime.cfl = 0.2\n", "there is no pane 3");
  says("[[edit]]\nt = 1\n", "an edit needs a parameter");
  says("[[edit]]\nt = 1\npush = { at = [0, 0] }\n", "needs \"radius\"");
  says("[[edit]]\nt = 1\nadd = { at = [0, 0], radius = 1, colour = 1 }\n", "unknown key \"colour\"");
  says("[[edit]]\nt = 1\ntime.cfl = 0.2\n[[edit]]\nt = 0.5\ntime.cfl = 0.3\n", "in the order of their times");
  says("[[edit]]\ntime.cfl = 0.2\n", "needs \"t\"");
}

} // namespace
} // namespace flipbook::app
