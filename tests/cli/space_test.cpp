// SPDX-License-Identifier: MIT
// Scenes in three dimensions from the command line: each scene runs in both, and one number of cells is enough.
#include "app/commands/variants.h"
#include "app/study/memory.h"
#include "app/study/resolve.h"
#include "sim/frame/errors.h"
#include "sim/scene/read_scene.h"
#include "tests/cli/program.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {

namespace {

using ::testing::ElementsAre;

/// The fewest cells along x, 12 or more, that are cubic in the scene's domain.
std::string few_cells(const std::string& scene, int dim) {
  const auto size = read_scene(scene).settings.grid.size;
  const auto whole = [&](double n, std::size_t axis) {
    const double cells = n * size[axis] / size[0];
    return std::abs(cells - std::round(cells)) < 1e-9;
  };
  int n = 12;
  while (!whole(n, 1) || (dim == 3 && !whole(n, 2))) n += 2;
  return std::to_string(n);
}

class EachScene : public ::testing::TestWithParam<std::string> {};

TEST_P(EachScene, RunsInBothDimensions) {
  const Folder f;
  for (const int dim : {2, 3}) {
    const Outcome o = run({"render", GetParam(), "--dim", std::to_string(dim), "--cells", few_cells(GetParam(), dim),
                           "--frames", "3", "--size", "320x180", "-q", "-o", "a/"},
                          f.path());
    EXPECT_EQ(o.code, 0) << dim << ": " << o.err;
    EXPECT_EQ(o.err, "");
  }
}
INSTANTIATE_TEST_SUITE_P(Each, EachScene, ::testing::ValuesIn(list_scenes()),
                         [](const auto& one) { return one.param; });

std::array<int, 3> cells(const std::string& scene, const std::string& dim, const std::string& n) {
  app::Study study = app::study_of_scene(scene);
  if (!dim.empty()) app::assign(study, {"dim", parse_value(dim), {"--dim", 0, 0}});
  Assignment a{"grid.cells", parse_value(n), {"--cells", 0, 0}};
  app::complete_cells(a, study);
  app::assign(study, a);
  return app::resolve(study).variants.front().scene.settings.grid.cells;
}

TEST(Cells, OneNumberIsThatAlongX) {
  EXPECT_THAT(cells("dam_break", "3", "24"), ElementsAre(24, 24, 24));
  EXPECT_THAT(cells("double_dam", "3", "48"), ElementsAre(48, 24, 24));
  EXPECT_THAT(cells("elliptical_drop", "3", "24"), ElementsAre(24, 16, 4));
  EXPECT_THAT(cells("column_and_block", "", "64"), ElementsAre(64, 20, 20));
  EXPECT_THAT(cells("sphere_in_tank", "", "[40, 25]"), ElementsAre(40, 25, 40));
  EXPECT_THAT(cells("sphere_in_tank", "", "[40, 25, 40]"), ElementsAre(40, 25, 40));
  EXPECT_THROW((void)cells("sphere_in_tank", "", "[40, 25, 20]"), UserError);
  EXPECT_THROW((void)cells("sphere_in_tank", "", "42"), UserError);
  EXPECT_NO_THROW((void)cells("elliptical_drop", "2", "27")) << "three to two: the depth is of no concern";
}

TEST(Cells, AnyWayToWriteThemIsTheSame) {
  const Folder f;
  std::string first;
  for (const std::string n : {"16", "16x16", "16x16x16", "16,16,16"}) {
    const Outcome o = run({"render", "dam_break", "--dim", "3", "--cells", n, "--frames", "2", "--size", "320x180",
                           "--threads", "2", "-q", "-o", "a/"},
                          f.path());
    ASSERT_EQ(o.code, 0) << o.err;
    const std::string pixels =
        run_other({"ffmpeg", "-v", "error", "-i", "a/frame_000001.png", "-f", "rawvideo", "-"}, f.path()).out;
    ASSERT_EQ(pixels.size(), 320U * 180U * 3U);
    if (first.empty()) first = pixels;
    EXPECT_TRUE(pixels == first) << n;
  }
}

TEST(Cells, ManyOfThemAreAWarning) {
  const auto said = [](const std::string& scene, const std::string& dim) {
    app::Study study = app::study_of_scene(scene);
    app::assign(study, {"dim", parse_value(dim), {"--dim", 0, 0}});
    app::assign(study, {"grid.cells", std::vector<double>{128, 128}, {"--cells", 0, 0}});
    study.variants.resize(4);
    return app::long_run(app::resolve(study));
  };
  // 4 * 0.32 * 256^3 = 21.5 million; the estimate looks at fewer places
  EXPECT_THAT(said("dam_break", "3"), ElementsAre("21 million particles in all panes will take long; half as many "
                                                  "cells along x are 8 times fewer"));
  EXPECT_THAT(said("dam_break", "2"), ElementsAre());
}

} // namespace

} // namespace flipbook::test
