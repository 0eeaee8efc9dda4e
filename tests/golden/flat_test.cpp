// SPDX-License-Identifier: MIT
// Areas of 2D panes: that what is drawn lies where it should and has the colour of its value. Expected places and areas
// are those of circles and boxes; tolerances are parts of a pixel.
#include "render/views/flat_areas.h"
#include "tests/golden/bodies.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace flipbook::test {
namespace {

using namespace render;

constexpr float metre = 200; // pixels
const Area whole{10, 20, 200, 200};

Snapshot unit_square(double spacing = 1.0 / 32) {
  Snapshot s = empty_tank(2, {0, 0, 0}, {1, 1, 1});
  s.particle_spacing = spacing;
  return s;
}

PaneView pane_of(const Snapshot& s) {
  return {&s, {0, 10, 220, 220}, whole.rect(), metre, {}};
}

/// Of pixel (x, y) of the area, in metres.
double at_x(int x) {
  return (x + 0.5) / static_cast<double>(metre);
}
double at_y(int y) {
  return 1 - (y + 0.5) / static_cast<double>(metre);
}

/// f(x, y) at the samples.
template <class F> LatticeData lattice_of(const std::string& name, int n, double origin, double dx, F&& f) {
  LatticeData l{
      name, {n, n, 1}, {static_cast<float>(origin), static_cast<float>(origin), 0}, static_cast<float>(dx), {}};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) l.values.push_back(static_cast<float>(f(origin + i * dx, origin + j * dx)));
  return l;
}
template <class F> LatticeData at_cells(const std::string& name, F&& f) {
  return lattice_of(name, 16, 1.0 / 32, 1.0 / 16, f);
}

double covered(const AreaPicture& picture) { // m^2
  double sum = 0;
  for (const Colour& c : picture.pixels) sum += c.a / 255.0;
  return sum / static_cast<double>(metre * metre);
}

const ColourScale& any_scale() {
  static const Frame f = dam_frame(1);
  static const ViewSettings view;
  static const ColourScale s =
      shared_scale(f, view, std::vector(1, colour_values(*f.panes[0].snapshot, chosen_quantity(view))));
  return s;
}

const Colour blue{0, 0, 255, 255}, white{255, 255, 255, 255};
AreaStyle body(float line = 0) {
  return {true, true, line, blue, white};
}
AreaPicture painted(const Snapshot& s, const AreaStyle& style) {
  return paint_areas(pane_of(s), {}, any_scale(), style, whole, {});
}

// === Lattices at pixels

TEST(LatticePixels, GiveBackParabolas) {
  const Snapshot s = unit_square();
  const auto f = [](double x, double y) { return 2 - 3 * x + 0.5 * y + 4 * x * y - x * x + 2 * y * y; };
  const Pixels p = resample(at_cells("any", f), pane_of(s), whole, {});
  const int away = 20; // pixels from where the lattice ends and the nearest sample holds
  for (int y = away; y < whole.h - away; ++y)
    for (int x = away; x < whole.w - away; ++x)
      ASSERT_NEAR(p.values[p.at(x, y)], f(at_x(x), at_y(y)), 1e-5) << x << " " << y;
}

TEST(LatticePixels, RepeatThemselvesAcrossPeriodicSides) {
  Snapshot s = unit_square();
  s.periodic = {true, true, false};
  const double k = 2 * std::numbers::pi;
  const auto f = [&](double x, double y) { return std::sin(k * x) * std::cos(k * y); };
  for (const LatticeData& l : {at_cells("any", f), lattice_of("any", 17, 0, 1.0 / 16, f)}) {
    const Pixels p = resample(l, pane_of(s), whole, {});
    for (int y = 0; y < whole.h; ++y) // Catmull-Rom: of third order in dx k = 0.39
      for (int x = 0; x < whole.w; ++x) ASSERT_NEAR(p.values[p.at(x, y)], f(at_x(x), at_y(y)), 0.01) << x << " " << y;
  }
}

TEST(LatticePixels, AverageWhatIsFinerThanPixels) {
  const Snapshot s = unit_square();
  int sign = 1;
  const LatticeData l = lattice_of("any", 1601, 0, 1.0 / 1600, [&](double, double) { return sign = -sign; });
  for (const float v : resample(l, pane_of(s), whole, {}).values) ASSERT_LT(std::abs(v), 0.1F);
}

TEST(LatticePixels, DoNotDependOnThreads) {
  const Snapshot s = unit_square();
  const LatticeData l = at_cells("any", [](double x, double y) { return std::sin(9 * x) * y; });
  const Workers backwards = [](int chunks, const std::function<void(int)>& run) {
    for (int i = chunks - 1; i >= 0; --i) run(i);
  };
  EXPECT_EQ(resample(l, pane_of(s), whole, {}).values, resample(l, pane_of(s), whole, backwards).values);
}

// === The surface

/// A disc that the solver's level set gives.
Snapshot disc(double radius) {
  Snapshot s = unit_square();
  s.lattices = {at_cells("surface", [&](double x, double y) { return std::hypot(x - 0.5, y - 0.5) - radius; })};
  add_particle(s, {0.5, 0.5, 0});
  return s;
}

TEST(Areas, TheOutlineLiesWherePhiIsZero) {
  const double radius = 0.3;
  const AreaPicture p = painted(disc(radius), body(3));
  int on = 0;
  for (int y = 0; y < whole.h; ++y)
    for (int x = 0; x < whole.w; ++x) {
      const double d = (std::hypot(at_x(x) - 0.5, at_y(y) - 0.5) - radius) * static_cast<double>(metre);
      const Colour c = p.pixels[static_cast<std::size_t>(x + whole.w * y)];
      if (std::abs(d) < 0.75) { // the line is three pixels wide, and its edges half a pixel soft
        EXPECT_EQ(c.a, 255) << x << " " << y;
        EXPECT_GT(c.r, 250) << x << " " << y;
        ++on;
      } else if (d < -2.25) {
        EXPECT_EQ(c.packed(), blue.packed()) << x << " " << y;
      } else if (d > 2.25) {
        EXPECT_EQ(c.a, 0) << x << " " << y;
      }
    }
  EXPECT_GT(on, 400);
}

TEST(Areas, AreCoveredInPartAtTheirEdges) {
  for (const double radius : {0.2, 0.3001, 0.4})
    EXPECT_NEAR(covered(painted(disc(radius), body())), std::numbers::pi * radius * radius, 5e-4) << radius;
}

TEST(Areas, AnOutlineAloneIsAsLongAsTheSurfaceTimesItsWidth) {
  AreaStyle style = body(2);
  style.fill = false;
  const double length = 2 * std::numbers::pi * 0.3, width = 2 / static_cast<double>(metre);
  EXPECT_NEAR(covered(painted(disc(0.3), style)), length * width, 0.02 * length * width);
}

TEST(Areas, WhatTheLevelSetLeavesOutIsADropOfItsArea) {
  Snapshot s = disc(0.2);
  const double before = covered(painted(s, body()));
  add_particle(s, {0.9, 0.11, 0});
  add_particle(s, {0.55, 0.5, 0}); // inside
  const double spacing = s.particle_spacing;
  EXPECT_NEAR(covered(painted(s, body())) - before, spacing * spacing, 0.04 * spacing * spacing);
}

/// The edges are at pixels 50 and 150, a spacing has 6.25 of them. The samples alone put the surface there; the cubic
/// takes it up to 0.14 cells (1.8 pixels) outwards, because phi grows faster outside than inside.
TEST(Areas, OfParticlesEndHalfASpacingBeyondTheLastRow) {
  Snapshot s = unit_square();
  add_particles(s, s.particle_spacing,
                [](const Vec3& x) { return x[0] > 0.25 && x[0] < 0.75 && x[1] > 0.25 && x[1] < 0.75; });
  ASSERT_EQ(s.particles(), 256U);
  EXPECT_NEAR(covered(painted(s, body())), 0.25, 0.02);
  const Pixels phi = surface_pixels(pane_of(s), whole, {});
  for (int y = 80; y < 120; ++y) {
    for (const int inside : {51, 148}) EXPECT_LT(phi.values[phi.at(inside, y)], 0) << inside << " " << y;
    for (const int outside : {46, 153}) EXPECT_GT(phi.values[phi.at(outside, y)], 0) << outside << " " << y;
  }
}

/// Wherever it is, seen by the lattice or not.
TEST(Areas, OfAParticleAloneIsNeverLost) {
  for (const double x : {0.5, 0.505, 0.51, 0.52, 0.53}) {
    Snapshot s = unit_square();
    const double area = s.particle_spacing * s.particle_spacing;
    add_particle(s, {x, 0.5, 0});
    EXPECT_GT(covered(painted(s, body())), 0.7 * area) << x;
    EXPECT_LT(covered(painted(s, body())), 5 * area) << x;
  }
}

TEST(Areas, HaveNoHolesOfAFewSamples) {
  Snapshot s = unit_square();
  s.lattices = {at_cells("surface", [](double x, double y) { return std::abs(x - 0.5) + std::abs(y - 0.5) - 0.35; })};
  add_particle(s, {0.5, 0.5, 0});
  const double before = covered(painted(s, body()));
  LatticeData& l = s.lattices[0];
  l.values[8 + 16 * 8] = l.values[8 + 16 * 9] = 0.02F;
  EXPECT_NEAR(covered(painted(s, body())), before, 1e-6);
  for (std::size_t i = 6; i < 10; ++i) l.values[i + 16 * 8] = l.values[i + 16 * 9] = 0.02F; // a bubble
  EXPECT_LT(covered(painted(s, body())), before - 0.01);
}

TEST(Areas, OfTwoBodiesStayApart) {
  Snapshot s = unit_square();
  const double h = s.particle_spacing; // particles end 2.5 h on either side of the middle
  add_particles(s, h, [&](const Vec3& x) {
    return x[1] > 0.2 && x[1] < 0.8 && std::abs(x[0] - 0.5) > 2 * h && std::abs(x[0] - 0.5) < 0.3;
  });
  const Pixels phi = surface_pixels(pane_of(s), whole, {});
  for (int y = 90; y < 110; ++y) EXPECT_GT(phi.values[phi.at(100, y)], 0.5 * h);
  EXPECT_LT(phi.values[phi.at(86, 100)], 0) << "beyond the last row, within half a spacing";
}

TEST(Areas, OfParticlesMeetTheWalls) {
  Snapshot s = unit_square();
  add_particles(s, s.particle_spacing, [](const Vec3& x) { return x[1] < 0.5; });
  const AreaPicture p = painted(s, body(3));
  for (int y = 110; y < whole.h; ++y)
    for (int x = 0; x < whole.w; ++x)
      ASSERT_EQ(p.pixels[static_cast<std::size_t>(x + whole.w * y)].packed(), blue.packed()) << x << " " << y;
  EXPECT_NEAR(covered(painted(s, body())), 0.5, 0.01);
}

// === Fields

Frame frame_with(Snapshot s) {
  Frame f;
  f.title = "Field";
  f.panes.push_back({"APIC", std::make_shared<const Snapshot>(std::move(s))});
  return f;
}

struct Painted {
  AreaPicture picture;
  ColourScale scale;
};
Painted painted(const Snapshot& s, const std::string& quantity, const std::string& range) {
  const Frame f = frame_with(s);
  const ViewSettings view = view_with({"view.colour=" + quantity, "view.range=" + range});
  const std::vector<std::vector<float>> values{colour_values(s, chosen_quantity(view))};
  const ColourScale scale = shared_scale(f, view, values);
  AreaStyle style;
  style.one_colour = false;
  return {paint_areas(pane_of(s), values[0], scale, style, whole, {}), scale};
}

void expect_colour(const Painted& p, int x, int y, double value) {
  const double share = (value - p.scale.lo) / (p.scale.hi - p.scale.lo);
  const Colour want = p.scale.table[static_cast<std::size_t>(std::lround(share * 255))];
  const Colour is = p.picture.pixels[static_cast<std::size_t>(x + whole.w * y)];
  for (const int difference : {is.r - want.r, is.g - want.g, is.b - want.b})
    EXPECT_LE(std::abs(difference), 3) << x << " " << y << ", value " << value;
  EXPECT_EQ(is.a, 255);
}

TEST(Fields, HaveTheColourOfTheirValue) {
  const auto f = [](double x, double y) { return 5 * x * y - 2 * y; };
  Snapshot s = disc(0.4);
  s.lattices.push_back(lattice_of("vorticity", 17, 0, 1.0 / 16, f));
  s.channels = {{"vorticity", "1/s", -2, 2, true, {0}}};
  const Painted p = painted(s, "vorticity", "-2,2");
  for (const int x : {60, 90, 133})
    for (const int y : {70, 101, 140}) expect_colour(p, x, y, f(at_x(x), at_y(y)));
  EXPECT_EQ(p.picture.pixels[5].a, 0) << "outside the liquid there is no field";
}

/// Averages of values that grow with x are that of the middle, but near edges.
TEST(Fields, WithoutALatticeComeFromTheParticles) {
  Snapshot s = unit_square();
  add_particles(s, s.particle_spacing, [](const Vec3&) { return true; });
  s.channels = {{"noise", "m/s", 0, 1, false, {}}};
  for (std::size_t p = 0; p < s.particles(); ++p) s.channels[0].values.push_back(s.x[2 * p]);
  const Painted p = painted(s, "noise", "0,1");
  for (const int x : {20, 77, 100, 170}) expect_colour(p, x, 60, at_x(x));
}

/// Names have no averages: between two bodies lies an edge and no third colour.
TEST(Fields, OfNamesTakeTheNearestParticle) {
  Snapshot s = unit_square();
  add_particles(s, s.particle_spacing, [](const Vec3&) { return true; });
  s.channels = {{"material", "", 0, 2, false, {}}};
  for (std::size_t p = 0; p < s.particles(); ++p) s.channels[0].values.push_back(s.x[2 * p] < 0.5F ? 0 : 2);
  const Painted p = painted(s, "material", "0,2");
  for (int x = 0; x < whole.w; ++x) expect_colour(p, x, 100, x < 100 ? 0 : 2);
}

// === In the picture

TEST(Styles, ASurfaceIsOneColourAndHasNoColourBar) {
  const auto context = Context::create(Backend::automatic);
  Renderer renderer(*context, 480, 360, {});
  const std::vector<std::string> bare{"view.show_panel=false", "view.plot_height=0", "view.style=surface"};
  const Image image = renderer.draw(frame_with(disc(0.3)), view_with(bare));
  const Colour liquid = palette(Theme::dark).liquid;
  int n = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    n += image.rgba[i] == liquid.r && image.rgba[i + 1] == liquid.g && image.rgba[i + 2] == liquid.b ? 1 : 0;
  EXPECT_GT(n, 5000);
  for (const TextBox& t : renderer.labels()) EXPECT_EQ(t.text.find("speed"), std::string::npos);
}

} // namespace
} // namespace flipbook::test
