// SPDX-License-Identifier: MIT
// Pictures of stored snapshots against stored pictures. FLIPBOOK_UPDATE_GOLDEN=1 rewrites the stored
// ones.
#include "app/panel/panel.h"
#include "tests/golden/bodies.h"
#include "tests/golden/curves.h"
#include "tests/golden/ledgers.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <cmath>
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

render::Frame labelled() {
  render::Frame f = dam_frame(2);
  f.labelled = true;
  f.label = "Back to FLIP 1: too late, energy that was lost does not return";
  return f;
}

render::Frame warned() {
  render::Frame f = two_dams();
  f.warnings = {"panes 1 and 2 show identical particles"};
  return f;
}

render::Frame made(const Snapshot& s) {
  render::Frame f;
  f.title = "One pane";
  f.duration = 1;
  f.panes.push_back({s.title, std::make_shared<Snapshot>(s)});
  return f;
}

/// Two rows and three columns, named at the margins.
render::Frame six_in_a_sheet() {
  render::Frame f = dam_frame(6);
  f.sheet = {{"FLIP 0.95", "APIC"}, {"linear", "quadratic", "cubic"}};
  return f;
}

/// The last pane makes a mistake.
render::Frame mistaken(render::Frame f) {
  auto s = std::make_shared<Snapshot>(*f.panes.back().snapshot);
  s->watermark = "WITH A MISTAKE: reversed offset";
  f.panes.back().snapshot = s;
  return f;
}

render::Frame z_up() {
  Snapshot s = with_z_up(*stored("dam_3d"));
  s.periodic = {false, true, false};
  return made(s);
}

/// A ball of particles above the floor, a box and a sphere on it, and one drop near the lid.
render::Frame shadows() {
  Snapshot s = empty_tank(3, {0, 0, 0}, {2, 1, 1});
  const auto within = [](const Vec3& x, const Vec3& centre, double r) {
    return std::hypot(x[0] - centre[0], x[1] - centre[1], x[2] - centre[2]) < r;
  };
  add_particles(s, 0.025, [&](const Vec3& x) {
    return within(x, {0.4, 0.22, 0.5}, 0.17) || within(x, {1.2, 0.9, 0.3}, 0.06) || (x[0] > 1.75 && x[1] < 0.12);
  });
  s.solids = {{box_mesh({-0.15, -0.2, -0.15}, {0.15, 0.2, 0.15}), {}}, {sphere_mesh(0.16, 24), {}}};
  const double c = std::cos(0.5), n = std::sin(0.5);
  s.solids[0].pose = {{c, 0, n, 0, 1, 0, -n, 0, c}, {0.95, 0.2, 0.4}};
  s.solids[1].pose.shift = {1.45, 0.16, 0.7};
  return made(s);
}

render::Frame bodies_2d() {
  Snapshot s = empty_tank(2, {-1, 2, 0}, {1, 3, 1});
  add_particles(s, 0.03, [](const Vec3& x) { return x[1] < 2.3 && std::hypot(x[0] - 0.2, x[1] - 2.3) > 0.21; });
  s.solids = {{disc_mesh(0.2, 48), {}}, {disc_mesh(0.25, 4), {}}};
  s.solids[0].pose.shift = {0.2, 2.3, 0};
  s.solids[1].pose.shift = {-0.6, 2.1, 0};
  return made(s);
}

/// With lattices of a grid, and particles alone.
render::Frame splash_and_dam() {
  return frame_of("Splash", {"splash", "dam_apic"});
}

/// A block of one material on a bed of another, a ball of a third beside them.
render::Frame two_materials() {
  Snapshot s = empty_tank(2, {0, 0, 0}, {2, 1, 1});
  const auto kind = [](const Vec3& x) {
    if (x[1] < 0.25) return 0;
    if (x[1] < 0.6 && std::abs(x[0] - 0.6) < 0.25) return 1;
    return std::hypot(x[0] - 1.4, x[1] - 0.55) < 0.2 ? 2 : -1;
  };
  add_particles(s, 0.03, [&](const Vec3& x) { return kind(x) >= 0; });
  s.particle_spacing = 0.03;
  s.channels = {{"material", "", 0, 2, false, {}}};
  for (std::size_t p = 0; p < s.particles(); ++p)
    s.channels[0].values.push_back(
        static_cast<float>(kind({static_cast<double>(s.x[2 * p]), static_cast<double>(s.x[2 * p + 1]), 0})));
  return made(s);
}

/// Without a ledger, with one where L is not defined, with one that changed nothing yet, and in space.
render::Frame ledger_states() {
  render::Frame f = frame_of("Ledgers", {"dam_pic", "vortices_flip", "dam_apic", "dam_3d"});
  const auto give = [&](std::size_t pane, std::shared_ptr<const LedgerTable> ledger) {
    auto s = std::make_shared<Snapshot>(*f.panes[pane].snapshot);
    s->ledger = std::move(ledger);
    f.panes[pane].snapshot = s;
  };
  give(1, std::make_shared<LedgerTable>(vortex_ledger()));
  give(2, std::make_shared<LedgerTable>(empty_ledger(2)));
  give(3, std::make_shared<LedgerTable>(dam_ledger(3, false)));
  return f;
}

/// Fronts that meet a wall one after the other, over an experiment's.
render::Frame fronts() {
  render::Frame f = curves_frame(3, {{"front", "m", [](std::size_t i, double t) {
                                        return std::min(1.0, 0.4 + (1.0 + 0.25 * static_cast<double>(i)) * t * t * 2);
                                      }}});
  add_references(f, "front");
  return emptied(f);
}

/// Every line style at once; the last value of each.
render::Frame twelve_curves() {
  const auto wave = [](std::size_t i, double t) {
    return 100 * static_cast<double>(i + 1) * (1 + 0.1 * std::sin(20 * t));
  };
  return emptied(curves_frame(12, {{"total", "J/m", wave}}, 0.8));
}

/// Three dam breaks, the third compared with the first, and how they differed so far.
render::Frame compared() {
  render::Frame f = dam_frame(3);
  auto so_far = std::make_shared<render::DifferenceSoFar>();
  so_far->curve.t = {0, 0.1F, 0.2F, 0.3F, 0.4F};
  so_far->curve.columns = {{"difference", "m/s", {0, 0.02F, 0.05F, 0.21F, 0.3F}}};
  so_far->most = 0.9;
  f.difference = so_far;
  return f;
}

/// The divider is dragged by its slider.
render::Frame moved_divider() {
  render::Frame f = dam_frame(2);
  f.pointer = {{"view.divider", -1, 1, true}};
  return f;
}

/// A lower and slower pool in the same tank; what is stored has speeds, not velocities.
render::Frame two_in_space() {
  render::Frame f = one("dam_3d");
  const auto pane = [](const std::string& title, float height, float speed) {
    auto s = std::make_shared<Snapshot>(*stored("dam_3d"));
    for (std::size_t p = 0; p < s->particles(); ++p) {
      s->x[3 * p + 1] = static_cast<float>(s->lo[1]) + height * (s->x[3 * p + 1] - static_cast<float>(s->lo[1]));
      s->v[3 * p] = s->channels[0].values[p] *= speed;
    }
    return render::Pane{title, s};
  };
  f.panes = {pane("FLIP 0.97", 1, 1), pane("APIC", 0.8F, 0.6F)};
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
      {"field_vorticity", bare_with({"view.style=field", "view.colour=vorticity"}), vortices, 480, 270},
      {"field_pressure_light",
       bare_with({"view.style=field", "view.colour=pressure", "view.theme=light", "view.outline=true"}),
       [] { return one("splash"); }, 360, 270},
      {"area_dark", bare_with({"view.style=surface"}), splash_and_dam, 480, 270},
      {"area_light", bare_with({"view.style=surface", "view.theme=light"}), splash_and_dam, 480, 270},
      {"area_materials", bare_with({"view.style=surface", "view.colour=material", "view.range=0,2"}), two_materials,
       480, 270},
      {"outline", bare_with({"view.outline=true", "view.particle_size=0.7"}), splash_and_dam, 480, 270},
      {"arrows_on_faces",
       bare_with({"view.style=surface", "view.arrows=true", "view.arrows_at=faces", "view.grid=true"}),
       [] { return one("splash"); }, 480, 400},
      {"cell_types", bare_with({"view.cell_types=true", "view.particle_size=0.6"}), [] { return one("splash"); }, 480,
       400},
      {"cell_types_light",
       bare_with({"view.cell_types=true", "view.particle_size=0.6", "view.theme=light", "view.arrows=true"}),
       [] { return one("splash"); }, 480, 400},
      {"trails", bare_with({"view.trails=0.3", "view.style=surface"}), [] { return one("splash"); }, 480, 270},
      {"trails_light", bare_with({"view.trails=0.3", "view.theme=light"}), [] { return one("splash"); }, 480, 270},
      {"water_3d", bare, [] { return one("dam_3d"); }, 480, 270},
      {"water_3d_light", bare_with({"view.theme=light", "view.grid=true"}), [] { return one("dam_3d"); }, 480, 270},
      {"water_3d_orbited",
       bare_with({"view.azimuth=60", "view.elevation=40", "view.zoom=1.6", "view.target=0.7,0.4,0.5"}),
       [] { return one("dam_3d"); }, 480, 270},
      {"water_3d_without_walls", bare_with({"view.walls=false", "view.particle_size=0.8"}),
       [] { return one("dam_3d"); }, 480, 270},
      {"z_up_periodic", bare, z_up, 480, 270},
      {"shadows_dark", bare_with({"view.elevation=30"}), shadows, 480, 270},
      {"shadows_light", bare_with({"view.elevation=30", "view.theme=light", "view.grid=true"}), shadows, 480, 270},
      {"surface_dark", bare_with({"view.style=surface"}), [] { return one("dam_3d"); }, 480, 270},
      {"surface_light", bare_with({"view.style=surface", "view.theme=light", "view.azimuth=35", "view.elevation=28"}),
       [] { return one("dam_3d"); }, 480, 270},
      {"surface_draft", bare_with({"view.style=surface", "view.quality=draft", "view.tint=true"}),
       [] { return one("dam_3d"); }, 480, 270},
      {"surface_bodies", bare_with({"view.style=surface", "view.elevation=30", "view.theme=light"}), shadows, 480, 270},
      {"bodies_2d", bare, bodies_2d, 480, 270},
      {"bodies_2d_light", bare_with({"view.theme=light"}), bodies_2d, 480, 270},
      {"four_panes_3d",
       {"view.colour=speed"},
       [] {
         return frame_of("Four", {"dam_3d", "dam_3d", "dam_3d", "dam_3d"});
       }},
      {"one_pane", {}, [] { return one("dam_flip"); }},
      {"two_panes_light", {"view.theme=light", "view.show_panel=false"}, warned},
      {"labelled", {"view.show_panel=false"}, labelled},
      {"four_panes_dragged", {}, dragged},
      {"four_panes_dragged_light", {"view.theme=light", "view.plots=kinetic,total"}, dragged},
      {"ledger_beside", {"view.ledger=total", "view.show_panel=false"}, [] { return ledger_frame(1); }, 854, 480},
      {"ledger_light",
       {"view.ledger=step", "view.theme=light", "view.plot_height=0"},
       [] { return ledger_frame(2); },
       1280,
       720},
      {"ledger_states", {"view.ledger=total", "view.show_panel=false", "view.plot_height=0"}, ledger_states, 1280, 720},
      {"ledger_left_out", {"view.ledger=total"}, [] { return ledger_frame(4); }},
      {"plots_log",
       {"view.show_panel=false", "view.plot_height=0.5", "view.log=transfer_loss,total",
        "view.plots=transfer_loss,total,kinetic"},
       [] { return emptied(curves_frame(4, energies())); },
       854,
       480},
      {"plots_references_light",
       {"view.show_panel=false", "view.plot_height=0.5", "view.theme=light", "view.plots=front"},
       fronts,
       640,
       480},
      {"plots_shared_axes",
       {"view.show_panel=false", "view.plot_height=0.45", "view.shared_axes=true"},
       [] { return emptied(curves_frame(3, energies())); },
       854,
       480},
      {"plots_twelve_light",
       {"view.show_panel=false", "view.plot_height=0.6", "view.theme=light", "view.plots=total", "view.captions=false"},
       twelve_curves,
       854,
       480},
      {"mistake_dark", bare, [] { return mistaken(two_dams()); }, 480, 270},
      {"mistake_3d_light", bare_with({"view.theme=light"}), [] { return mistaken(one("dam_3d")); }, 480, 270},
      {"large", {"view.layout=large", "view.large=2"}, [] { return dam_frame(4); }},
      {"large_light", bare_with({"view.layout=large", "view.theme=light"}), [] { return dam_frame(6); }, 480, 270},
      {"split", {"view.layout=split", "view.divider=0.4", "view.plot_height=0"}, moved_divider},
      {"split_light",
       {"view.layout=split", "view.theme=light", "view.show_panel=false", "view.arrows=true", "view.plots=total"},
       [] { return dam_frame(3); }},
      {"split_3d", bare_with({"view.layout=split"}), two_in_space, 480, 270},
      {"split_ledger",
       {"view.layout=split", "view.ledger=total", "view.show_panel=false", "view.plot_height=0"},
       [] { return ledger_frame(3); },
       854,
       480},
      {"difference", {"view.difference=speed", "view.pair=3,1", "view.show_panel=false", "view.plots=total"}, compared},
      {"difference_light", bare_with({"view.difference=surface", "view.theme=light"}), [] { return dam_frame(2); }, 480,
       270},
      {"difference_large",
       {"view.difference=density", "view.layout=large", "view.large=3", "view.show_panel=false", "view.plot_height=0"},
       two_dams,
       480,
       270},
      {"difference_3d", bare_with({"view.difference=speed", "view.layout=split"}), two_in_space, 640, 270},
      {"twelve_panes", {"view.panel=cfl,gravity,kernel"}, [] { return dam_frame(12); }, 854, 480},
      {"sheet_dark", {"view.layout=sheet", "view.sheet_columns=3", "view.show_panel=false"}, six_in_a_sheet, 480, 270},
      {"sheet_of_titles_light",
       {"view.layout=sheet", "view.theme=light", "view.show_panel=false", "view.sparkline=kinetic"},
       [] { return dam_frame(7); },
       480,
       270},
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
