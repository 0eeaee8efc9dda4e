// SPDX-License-Identifier: MIT
// The stages of a step as pictures: they tell of the step that the run takes, no label covers another, and a page and a
// sheet look as they did.
#include "app/session/make_variants.h"
#include "app/stages/page.h"
#include "render/chart/text_check.h"
#include "render/compose/layout.h"
#include "tests/golden/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace flipbook::app {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Bench {
  Budget budget{1};
  Budget::Permit permit{budget};
  Pool pool{budget};
};

/// A scene with few cells in double, so that all machines draw the same, one variant for each list of changes.
Resolved small(const std::string& scene, const std::vector<std::vector<std::string>>& variants,
               const std::vector<double>& cells = {24, 24}) {
  Study study = study_of_scene(scene);
  const auto change = [](const std::string& text) {
    const std::size_t equals = text.find('=');
    return Assignment{text.substr(0, equals), parse_value(text.substr(equals + 1)), {}};
  };
  assign(study, {"grid.cells", cells, {}});
  assign(study, change("precision=double"));
  assign(study, change("pressure.tolerance=1e-10"));
  study.variants.clear();
  for (const auto& changes : variants) {
    study.variants.emplace_back();
    for (const std::string& text : changes) study.variants.back().parameters.push_back(change(text));
  }
  return resolve(study);
}

StageBook book_of(const Resolved& study, double time, render::Theme theme = render::Theme::dark,
                  const std::string& window = "") {
  Bench b;
  return {study.title, record_steps(study, time, {b.pool}), window, theme};
}

std::vector<std::string> names_of(const RecordedStep& step) {
  std::vector<std::string> names;
  for (const StoryStage& s : story_of(step)) names.push_back(s.name);
  return names;
}

TEST(Stages, TellTheStepOfALiquid) {
  Bench b;
  const Resolved study = small("dam_break", {{"transfer.scheme=apic"}});
  const std::vector<RecordedStep> steps = record_steps(study, 0.2, {b.pool});
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].title, "APIC");
  EXPECT_EQ(steps[0].time(), 0.2);
  EXPECT_THAT(names_of(steps[0]), ElementsAre("Start", "P2G", "Forces", "Divergence before", "Pressure",
                                              "Divergence after", "G2P", "Advection"));
}

TEST(Stages, TellTheStepOfASolidAndOfARoundTrip) {
  Bench b;
  EXPECT_THAT(names_of(record_steps(small("jelly_cubes", {{}}, {32, 32}), 0.01, {b.pool})[0]),
              ElementsAre("Start", "P2G", "Forces", "Stress", "Contact", "G2P", "Motion"));
  EXPECT_THAT(names_of(record_steps(small("transfer_vortex", {{}}, {16, 16}), 0, {b.pool})[0]),
              ElementsAre("Start", "P2G", "G2P"));
}

/// Both halves of a step that acts in its middle; the correction that opens it has no pressure of its own.
TEST(Stages, TellOtherSplittings) {
  Bench b;
  const Resolved study = small("dam_break", {{"transfer.scheme=flip", "time.splitting=midpoint"}});
  EXPECT_THAT(names_of(record_steps(study, 0.2, {b.pool})[0]),
              ElementsAre("Start", "P2G", "Divergence before", "Divergence after", "G2P", "Advection", "P2G", "Forces",
                          "Divergence before", "Pressure", "Divergence after", "Second half", "G2P", "Advection"));
}

/// The recorded step is the one that the run takes next: from there on it is where the recorded particles are.
TEST(Stages, AreOfTheRunsOwnStep) {
  Bench b;
  const Resolved study = small("dam_break", {{"transfer.scheme=flip"}, {"transfer.scheme=apic"}});
  const std::vector<RecordedStep> steps = record_steps(study, 0.2, {b.pool});
  const std::unique_ptr<Stepper> run = make_variants(study, b.pool);
  for (const Resolved& r = study; (*run)[0].time() < 0.2 - 1e-12;) { // frame by frame, as a video
    const auto next = static_cast<std::uint64_t>(std::floor((*run)[0].time() * r.output.fps / r.scale + 1e-9)) + 1;
    run->advance_to(r.time_of(next), [] { return false; });
  }
  EXPECT_EQ((*run)[0].steps(), steps[0].before->steps);
  int calls = 0;
  run->advance_to(study.time_of(7), [&] { return calls++ > 0; }); // one step of those to the next frame
  for (std::size_t v = 0; v < 2; ++v) {
    const ParticleTable now = (*run)[v].particle_table();
    const StageStill& end = steps[v].stills.back();
    EXPECT_NEAR(steps[v].stills.front().dt, (*run)[v].time() - 0.2, 1e-14) << "a whole step";
    ASSERT_EQ(now.id, end.id);
    for (std::size_t p = 0; p < end.id.size(); ++p) EXPECT_EQ(now.find("x")->values[p], end.x[2 * p]);
  }
}

TEST(Stages, OfSeveralSchemesShareWhatIsSaid) {
  Bench b;
  const Resolved study = small("dam_break", {{"transfer.scheme=pic"}, {"transfer.scheme=flip"}});
  const std::vector<RecordedStep> steps = record_steps(study, 0.2, {b.pool});
  const std::vector<StoryStage> common = common_story(steps);
  EXPECT_EQ(common[1].equation, story_of(steps[0])[1].equation) << "both paint v_p";
  EXPECT_NE(common[6].equation, story_of(steps[0])[6].equation);
  EXPECT_THAT(common[6].equation, testing::HasSubstr("r ("));
}

TEST(StagesLens, LooksWhereTheLiquidMovesMost) {
  RecordedStep step;
  auto s = std::make_shared<Snapshot>();
  s->cells = {20, 20, 1};
  s->dx = 0.05;
  step.before = s;
  step.stills.emplace_back();
  StageStill& start = step.stills.back();
  start.dx = 0.05;
  for (const double x : {0.1, 0.5, 0.7}) {
    start.id.push_back(static_cast<std::uint32_t>(start.id.size()));
    start.x.insert(start.x.end(), {x, x});
    start.v.insert(start.v.end(), {0.0, x == 0.7 ? -3.0 : 1.0});
  }
  const render::Window w = liveliest_window({step}, {4, 4});
  EXPECT_LE(w.lo[0], 0.7);
  EXPECT_GE(w.hi[0], 0.7);
  EXPECT_NEAR(w.hi[0] - w.lo[0], 0.2, 1e-12);
  start.v = {0, 9, 0, 0, 0, 0}; // in the corner: a bit of both walls shows
  const render::Window corner = liveliest_window({step}, {4, 4});
  EXPECT_LT(corner.lo[0], 0);
  EXPECT_LT(corner.lo[1], 0);
}

class StagePages : public testing::TestWithParam<std::array<int, 2>> {};

TEST_P(StagePages, CanBeRead) {
  const auto [width, height] = GetParam();
  const std::vector<Resolved> studies{
      small("dam_break", {{"transfer.scheme=flip", "transfer.flip_ratio=0.97"}}),
      small("dam_break", {{"transfer.scheme=pic"}, {"transfer.scheme=apic"}, {"transfer.scheme=polypic"}}),
      small("drop_on_sphere", {{"time.splitting=reflection"}}), small("jelly_cubes", {{}}, {32, 32})};
  for (const Resolved& study : studies) {
    const StageBook book = book_of(study, 0.02);
    for (std::size_t k = 0; k < book.pages(); ++k) {
      std::vector<render::TextBox> texts;
      const render::Image page = book.page(k, width, height, &texts);
      EXPECT_EQ(page.width, width);
      EXPECT_EQ(page.height, height);
      EXPECT_GE(texts.size(), book.pages() + 4);
      const float scale = render::point_size(width, height);
      const render::Rect frame{0, 0, static_cast<float>(width) / scale, static_cast<float>(height) / scale};
      EXPECT_THAT(render::text_conflicts(texts, frame), IsEmpty()) << study.name << ", page " << k + 1;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, StagePages,
                         testing::Values(std::array{854, 480}, std::array{1280, 720}, std::array{1080, 1080},
                                         std::array{1080, 1920}),
                         [](const auto& test) {
                           return std::to_string(test.param[0]) + "x" + std::to_string(test.param[1]);
                         });

TEST(StageSheets, CanBeReadInEveryMedium) {
  for (const Resolved& study : {small("dam_break", {{"transfer.scheme=flip"}}),
                                small("dam_break", {{"transfer.scheme=pic"}, {"transfer.scheme=apic"}})}) {
    const StageBook book = book_of(study, 0.2, render::Theme::light);
    const StageBook::Sheet sheet = book.sheet(render::Medium::pixels, 1920);
    EXPECT_EQ(sheet.image.width, 1920);
    EXPECT_THAT(render::text_conflicts(
                    sheet.texts, {0, 0, static_cast<float>(sheet.page.width), static_cast<float>(sheet.page.height)}),
                IsEmpty());
    const std::vector<std::uint8_t> pdf = book.sheet(render::Medium::pdf, 490).file;
    ASSERT_GT(pdf.size(), 4U);
    EXPECT_EQ(std::string(pdf.begin(), pdf.begin() + 4), "%PDF");
  }
}

/// Against a stored picture; FLIPBOOK_UPDATE_GOLDEN=1 rewrites it. Cairo draws glyphs as outlines without hinting, so
/// that only its rounding of edges may change from one version to the next: a block by less than 20.
void expect_golden(const render::Image& image, const std::string& name) {
  const std::string file = FLIPBOOK_SOURCE_DIR "/tests/figures/references/" + name + ".png";
  if (std::getenv("FLIPBOOK_UPDATE_GOLDEN")) return test::write_png(image, file);
  const test::Difference d = test::difference(image, test::read_png(file));
  EXPECT_LT(d.largest, 20) << name;
  EXPECT_LT(d.mean, 0.15) << name;
  if (d.largest >= 20 || d.mean >= 0.15) test::write_png(image, FLIPBOOK_BINARY_DIR "/golden/" + name + "_actual.png");
}

constexpr const char* few_cells = "0.25,0,0.5,0.16666"; // of 24: 6 x 4

TEST(StageGolden, Pages) {
  const Resolved study = small("dam_break", {{"transfer.scheme=flip", "transfer.flip_ratio=0.97"}});
  const StageBook dark = book_of(study, 0.2, render::Theme::dark, few_cells),
                  light = book_of(study, 0.2, render::Theme::light, few_cells);
  expect_golden(dark.page(1, 640, 360), "stages_p2g");
  expect_golden(light.page(2, 640, 360), "stages_forces_light");
  expect_golden(dark.page(3, 640, 360), "stages_divergence");
}

TEST(StageGolden, SheetOfTwoSchemes) {
  const Resolved study = small("dam_break", {{"transfer.scheme=pic"}, {"transfer.scheme=apic"}});
  const StageBook book = book_of(study, 0.2, render::Theme::light, few_cells);
  expect_golden(book.sheet(render::Medium::pixels, 800).image, "stages_sheet");
}

} // namespace
} // namespace flipbook::app
