// SPDX-License-Identifier: MIT
// What colour maps promise: equal steps of value look equal, order can be read from lightness alone, zero is neutral.
#include "render/theme.h"
#include "render/views/colour_by.h"
#include "render/views/curve_style.h"
#include "tests/golden/colour_vision.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flipbook::test {
namespace {

using namespace render;

std::vector<Oklab> lab_table(const ColourMap& map) {
  std::vector<Oklab> out;
  for (const Colour& c : table(map)) out.push_back(to_oklab(c));
  return out;
}

TEST(ColourMaps, StepsLookEqual) {
  for (const ColourMap& map : colour_maps()) {
    const std::vector<Oklab> t = lab_table(map);
    ASSERT_EQ(t.size(), 256U);
    // Over 16 entries, so that rounding to 8 bits does not matter; a corner at a control colour shortens a step.
    double shortest = 1e9, longest = 0;
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t i = 128 * half; i + 16 < 128 * (half + 1); i += 8) {
        const double d = distance(t[i], t[i + 16]);
        shortest = std::min(shortest, d);
        longest = std::max(longest, d);
      }
    EXPECT_LT(longest / shortest, 1.6) << map.name;
  }
}

TEST(ColourMaps, LightnessGivesTheOrder) {
  for (const ColourMap& map : colour_maps()) {
    const std::vector<Oklab> t = lab_table(map);
    if (map.kind == MapKind::sequential) {
      const double up = t.back().l > t.front().l ? 1 : -1;
      for (std::size_t i = 8; i < t.size(); ++i) EXPECT_GT(up * (t[i].l - t[i - 8].l), 0) << map.name << " " << i;
      EXPECT_GT(std::abs(t.back().l - t.front().l), 0.45) << map.name;
    }
    if (map.kind == MapKind::diverging) {
      EXPECT_LT(std::hypot(t[127].a, t[127].b), 0.03) << map.name << ": zero is not grey";
      EXPECT_NEAR(t.front().l, t.back().l, 0.12) << map.name;
      EXPECT_GT(std::abs(t.front().l - t[127].l), 0.2) << map.name;
    }
    if (map.kind == MapKind::cyclic) {
      EXPECT_LT(distance(t.front(), t.back()), 0.02) << map.name;
    }
  }
}

TEST(ColourMaps, AutomaticOnesStandOutFromThePage) {
  for (const Theme theme : {Theme::light, Theme::dark})
    for (const MapKind kind : {MapKind::sequential, MapKind::diverging, MapKind::cyclic})
      for (const Colour& c : table(choose_map(0, kind, theme)))
        EXPECT_GT(distance(to_oklab(c), to_oklab(palette(theme).pane)), 0.12) << choose_map(0, kind, theme).name;
}

TEST(Palettes, VariantsDifferFromEachOtherAndThePage) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const Palette& p = palette(theme);
    for (std::size_t i = 0; i < p.variants.size(); ++i) {
      EXPECT_GT(std::abs(to_oklab(p.variants[i]).l - to_oklab(p.page).l), 0.25) << i;
      for (std::size_t k = i + 1; k < p.variants.size(); ++k)
        EXPECT_GT(distance(to_oklab(p.variants[i]), to_oklab(p.variants[k])), 0.05) << i << " " << k;
    }
    EXPECT_GT(std::abs(to_oklab(p.text).l - to_oklab(p.page).l), 0.7);
    EXPECT_GT(std::abs(to_oklab(p.muted).l - to_oklab(p.pane).l), 0.35);
  }
}

/// Whatever cones a reader has: the first six and all neighbours differ in colour, and any two in colour or in their
/// lines. 0.05 in Oklab is two and a half just noticeable differences.
TEST(Palettes, VariantsDifferForEveryColourVision) {
  for (const Theme theme : {Theme::light, Theme::dark})
    for (const ColourVision& vision : colour_visions) {
      const Palette& p = palette(theme);
      const auto apart = [&](std::size_t i, std::size_t k) {
        return distance(to_oklab(seen(vision, p.variants[i])), to_oklab(seen(vision, p.variants[k])));
      };
      for (std::size_t i = 0; i < p.variants.size(); ++i) {
        EXPECT_GT(std::abs(to_oklab(seen(vision, p.variants[i])).l - to_oklab(p.page).l), 0.2)
            << vision.name << " " << i;
        for (std::size_t k = i + 1; k < p.variants.size(); ++k) {
          const CurveStyle &a = curve_style(i), &b = curve_style(k);
          const bool lines = a.pattern != b.pattern || a.marker != b.marker;
          EXPECT_TRUE(lines || apart(i, k) > 0.05) << vision.name << " " << i << " " << k;
          const double least = k < 6 ? 0.06 : k == i + 1 ? 0.055 : 0;
          EXPECT_GT(apart(i, k), least) << vision.name << " " << i << " " << k;
        }
      }
    }
}

std::vector<std::vector<float>> values_of(const Frame& f, const ViewSettings& view) {
  std::vector<std::vector<float>> v;
  for (const Pane& p : f.panes) v.push_back(colour_values(*p.snapshot, chosen_quantity(view)));
  return v;
}

TEST(ColourScale, IsSharedAndRound) {
  const Frame f = dam_frame(3);
  const ViewSettings view;
  const ColourScale s = shared_scale(f, view, values_of(f, view));
  EXPECT_EQ(s.lo, 0);
  EXPECT_DOUBLE_EQ(s.hi, round(s.hi * 10) / 10);
  for (const Pane& p : f.panes) EXPECT_GE(s.hi, p.snapshot->channels[0].hi);
  EXPECT_EQ(s.unit, "m/s");
}

TEST(ColourScale, OfSignedQuantitiesIsSymmetric) {
  const Frame f = dam_frame(3);
  const ViewSettings view = view_with({"view.colour=vorticity"});
  const ColourScale s = shared_scale(f, view, values_of(f, view));
  EXPECT_EQ(s.lo, -s.hi);
  EXPECT_EQ(s.map->kind, MapKind::diverging);
}

TEST(ColourScale, TakesTheRangeItIsGivenAndSaysWhatIsBeyond) {
  const Frame f = dam_frame(3);
  const ViewSettings view = view_with({"view.range=0.5,1"});
  const ColourScale s = shared_scale(f, view, values_of(f, view));
  EXPECT_EQ(s.lo, 0.5);
  EXPECT_EQ(s.hi, 1);
  EXPECT_TRUE(s.above);
  EXPECT_TRUE(s.below);
}

TEST(ColourValues, ComeFromVelocitiesWhereNoChannelWasPublished) {
  Snapshot s = *stored("dam_flip");
  const std::vector<float> published = colour_values(s, colour_quantities()[0]);
  s.channels.clear();
  const std::vector<float> computed = colour_values(s, colour_quantities()[0]);
  ASSERT_EQ(published.size(), computed.size());
  for (std::size_t p = 0; p < computed.size(); ++p) EXPECT_NEAR(computed[p], published[p], 1e-5F * (1 + published[p]));
}

} // namespace
} // namespace flipbook::test
