// SPDX-License-Identifier: MIT
// Pictures of stored snapshots against stored pictures. FLIPBOOK_UPDATE_GOLDEN=1 rewrites the stored
// ones.
#include "app/panel/panel.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

namespace flipbook::test {
namespace {

// Debian 12 and 13 (Dear ImGui 1.86 and 1.90, Mesa 22.3 and 25.0) draw the same bytes but for the handle of a held
// slider, where a 4x4 block differs by 17. Another FreeType may move the edge of a glyph by a fraction of a pixel,
// which changes a block by less than 40; a wrong colour, a missing line or a shifted word changes one by more.
constexpr double most_anywhere = 40;
// Between the same two systems: 0.0014. A missing pane of four gives 0.5, another colour map more.
constexpr double most_on_average = 0.15;

struct Case {
  std::string name;
  std::vector<std::string> changes; ///< of the view
  std::function<render::Frame()> frame;
  int width = 640, height = 360;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

render::Frame two_dams() {
  return frame_of("Dam break", {"dam_flip", "dam_apic"});
}
render::Frame vortices() {
  return frame_of("Taylor–Green vortices", {"vortices_flip", "vortices_apic"});
}
render::Frame one(const std::string& name) {
  return frame_of("One pane", {name});
}

/// The timeline holds the slider of one pane.
render::Frame dragged() {
  render::Frame f = dam_frame(4);
  f.pointer = {{"transfer.flip_ratio", 1, 1, true}};
  return f;
}

render::Frame warned() {
  render::Frame f = two_dams();
  f.warnings = {"panes 1 and 2 show identical particles"};
  return f;
}

const std::vector<std::string> bare{"view.show_panel=false", "view.plot_height=0", "view.captions=false"};
std::vector<std::string> bare_with(std::vector<std::string> more) {
  more.insert(more.end(), bare.begin(), bare.end());
  return more;
}

std::vector<Case> cases() {
  return {
      {"speed_dark", bare, two_dams, 480, 270},
      {"speed_light", bare_with({"view.theme=light"}), two_dams, 480, 270},
      {"vorticity_dark", bare_with({"view.colour=vorticity"}), vortices, 480, 270},
      {"vorticity_light", bare_with({"view.colour=vorticity", "view.theme=light"}), vortices, 480, 270},
      {"id", bare_with({"view.colour=id"}), vortices, 480, 270},
      {"velocity_viridis", bare_with({"view.colour=velocity_x", "view.map=viridis"}), two_dams, 480, 270},
      {"not_published", bare_with({"view.colour=pressure"}), two_dams, 480, 270},
      {"range", bare_with({"view.range=0,1"}), two_dams, 480, 270},
      {"grid_and_arrows", bare_with({"view.grid=true", "view.arrows=true", "view.particle_size=0.6"}), two_dams, 480,
       270},
      {"balls", bare, [] { return one("dam_3d"); }, 480, 270},
      {"one_pane", {}, [] { return one("dam_flip"); }},
      {"two_panes_light", {"view.theme=light", "view.show_panel=false"}, warned},
      {"four_panes_dragged", {}, dragged},
      {"four_panes_dragged_light", {"view.theme=light", "view.plots=kinetic,total"}, dragged},
      {"twelve_panes", {"view.panel=cfl,gravity,kernel"}, [] { return dam_frame(12); }, 854, 480},
  };
}

class Golden : public testing::TestWithParam<Case> {};

TEST_P(Golden, AgreesWithStoredPicture) {
  const Case& c = GetParam();
  // One instruction set for the shader compiler of the software rasteriser, whatever the machine has.
  setenv("LP_NATIVE_VECTOR_WIDTH", "128", 1);
  const auto context = render::Context::create(render::Backend::automatic);
  render::Renderer renderer(*context, c.width, c.height, app::make_panel());
  ASSERT_EQ(renderer.note(), "") << "the stored pictures are drawn with DejaVu";
  const render::Image actual = renderer.draw(c.frame(), view_with(c.changes));

  const std::string reference = std::string(FLIPBOOK_SOURCE_DIR "/tests/golden/references/") + c.name + ".png";
  if (std::getenv("FLIPBOOK_UPDATE_GOLDEN") != nullptr) {
    write_png(actual, reference);
    return;
  }
  const render::Image expected = read_png(reference);
  const Difference d = difference(actual, expected);
  const std::string out = std::string(FLIPBOOK_BINARY_DIR "/golden/") + c.name;
  if (d.largest > most_anywhere || d.mean > most_on_average) {
    write_png(actual, out + "_actual.png");
    write_png(difference_picture(actual, expected), out + "_difference.png");
  }
  EXPECT_LE(d.largest, most_anywhere) << "see " << out << "_difference.png";
  EXPECT_LE(d.mean, most_on_average) << "see " << out << "_difference.png";
}

INSTANTIATE_TEST_SUITE_P(Pictures, Golden, testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

/// The thresholds see what they have to see.
TEST(Golden, ThresholdsSeeAMissingPane) {
  const auto context = render::Context::create(render::Backend::automatic);
  render::Renderer renderer(*context, 640, 360, app::make_panel());
  render::Frame frame = dam_frame(4);
  const render::Image whole = renderer.draw(frame, {});
  auto empty = std::make_shared<Snapshot>(*frame.panes[2].snapshot);
  empty->x.clear(), empty->v.clear(), empty->id.clear(), empty->channels.clear();
  frame.panes[2].snapshot = empty;
  const Difference d = difference(whole, renderer.draw(frame, {}));
  EXPECT_GT(d.largest, most_anywhere);
  EXPECT_GT(d.mean, most_on_average);
}

TEST(Golden, ThresholdsSeeAChangedColour) {
  const auto context = render::Context::create(render::Backend::automatic);
  render::Renderer renderer(*context, 480, 270, {});
  const render::Image one = renderer.draw(two_dams(), view_with(bare));
  const render::Image other = renderer.draw(two_dams(), view_with(bare_with({"view.map=cividis"})));
  EXPECT_GT(difference(one, other).mean, most_on_average);
}

} // namespace
} // namespace flipbook::test
