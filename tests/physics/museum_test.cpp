// SPDX-License-Identifier: MIT
// Every mistake of the museum changes the line of the ledger, or the curve, that it says it does, and none of them
// leaves a trace in a run beside it.
#include "sim/boundary/shape.h"
#include "sim/frame/errors.h"
#include "sim/museum/museum.h"
#include "sim/scene/velocity.h"
#include "tests/physics/flow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace flipbook::test {
namespace {

using Claim = LedgerTable::Claim;
using ::testing::HasSubstr;

std::size_t number_of(std::string_view name) {
  const auto& all = museum::exhibits();
  const auto at = std::find_if(all.begin(), all.end(), [&](const museum::Exhibit& e) { return e.name == name; });
  EXPECT_NE(at, all.end()) << name;
  return static_cast<std::size_t>(at - all.begin());
}

/// A column of liquid that falls over: walls, a free surface, gravity, rotation.
Scene column(int scheme, KernelName kernel, int dim = 2, Precision precision = Precision::double_) {
  Scene scene;
  const int n = dim == 2 ? 20 : 10;
  scene.settings = box({n, n, n}, 1.0 / n, dim);
  scene.settings.precision = precision;
  scene.settings.pressure.tolerance = 1e-6;
  scene.settings.transfer.scheme = scheme;
  scene.settings.transfer.kernel = kernel;
  scene.fluid.push_back({make_box({{0, 0, 0}, 3}, {{0.4, 0.7, 1}, 3}), components_velocity({0, 0, 0}, {})});
  return scene;
}

/// What a run had come to after 0.4 s.
class Course {
public:
  /// `mistake` empty: none.
  Course(const Scene& scene, std::string_view mistake, double until = 0.4) {
    Budget budget(2);
    Pool pool(budget);
    const Budget::Permit permit(budget);
    const auto run =
        mistake.empty()
            ? make_simulation(scene, pool)
            : museum::make_mistaken(scene, museum::hang({{number_of(mistake)}, 0}, number_of(mistake)), pool);
    (void)run->snapshot(0, {});
    for (int frame = 1; frame <= 8; ++frame) {
      const double to = until * frame / 8;
      while (run->time() < to * (1 - 1e-12)) {
        const double left = to - run->time();
        run->step(left / std::max(1.0, std::ceil(left / run->max_dt() * (1 - 1e-12))));
      }
      end = run->snapshot(static_cast<std::uint64_t>(frame), {});
    }
  }

  [[nodiscard]] Claim claim(std::string_view stage, std::string_view quantity) const {
    return end->ledger->claims[at(stage, quantity)];
  }
  [[nodiscard]] double total(std::string_view stage, std::string_view quantity) const {
    return end->ledger->total[at(stage, quantity)];
  }
  /// The curve's last value.
  [[nodiscard]] double curve(std::string_view name) const {
    for (const History::Column& c : end->history->columns)
      if (c.name == name) return static_cast<double>(c.y.back());
    ADD_FAILURE() << "no curve " << name;
    return 0;
  }
  [[nodiscard]] bool any_fails() const {
    const auto& all = end->ledger->claims;
    return std::find(all.begin(), all.end(), Claim::fails) != all.end();
  }

  std::shared_ptr<const Snapshot> end;

private:
  [[nodiscard]] std::size_t at(std::string_view stage, std::string_view quantity) const {
    const LedgerTable& t = *end->ledger;
    for (std::size_t s = 0; s < t.stages.size(); ++s)
      for (std::size_t q = 0; q < t.quantities.size(); ++q)
        if (t.stages[s].name == stage && t.quantities[q].name == quantity) return t.at(s, q);
    ADD_FAILURE() << "no line " << stage << " " << quantity;
    return 0;
  }
};

// === Lines that turn red

struct Red {
  const char* mistake;
  int scheme;
  KernelName kernel;
  std::vector<std::pair<const char*, const char*>> lines; ///< stage and quantity
};

void PrintTo(const Red& r, std::ostream* out) {
  *out << r.mistake << " " << scheme_names[r.scheme];
}

std::string named(const ::testing::TestParamInfo<Red>& one) {
  return std::string(one.param.mistake) + "_" + scheme_names[one.param.scheme];
}

class RedLines : public ::testing::TestWithParam<Red> {};

TEST_P(RedLines, FailWithTheMistakeOnly) {
  const Red& r = GetParam();
  const Scene scene = column(r.scheme, r.kernel);
  ASSERT_EQ(museum::needs(number_of(r.mistake), scene.settings), "");
  const Course right(scene, ""), wrong(scene, r.mistake);
  EXPECT_FALSE(right.any_fails());
  for (const auto& [stage, quantity] : r.lines) {
    EXPECT_EQ(wrong.claim(stage, quantity), Claim::fails) << stage << " " << quantity;
    EXPECT_EQ(right.claim(stage, quantity), Claim::holds) << stage << " " << quantity;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Museum, RedLines,
    ::testing::Values(
        Red{"reversed_offset", apic, KernelName::linear, {{"p2g", "angular_momentum_z"}}},
        Red{"reversed_offset", rpic, KernelName::quadratic, {{"p2g", "angular_momentum_z"}}},
        Red{"reversed_offset", polypic, KernelName::linear, {{"p2g", "angular_momentum_z"}}},
        Red{"transposed_c", apic, KernelName::quadratic, {{"g2p", "angular_momentum_z"}}},
        Red{"quadratic_d", apic, KernelName::cubic, {{"g2p", "angular_momentum_z"}, {"g2p", "kinetic"}}},
        Red{"quadratic_d", rpic, KernelName::cubic, {{"g2p", "angular_momentum_z"}}},
        Red{"missing_d", apic, KernelName::quadratic, {{"g2p", "angular_momentum_z"}}},
        Red{"twice_d", apic, KernelName::quadratic, {{"p2g", "angular_momentum_z"}, {"p2g", "kinetic"}}},
        Red{"gradient_c", apic, KernelName::quadratic, {{"g2p", "angular_momentum_z"}}},
        Red{"late_old", flip, KernelName::linear, {{"g2p", "momentum_y"}}},
        Red{"moved_early", pic, KernelName::linear, {{"g2p", "momentum_x"}, {"g2p", "momentum_y"}}},
        Red{"moved_early", apic, KernelName::quadratic, {{"g2p", "momentum_x"}, {"g2p", "angular_momentum_z"}}},
        Red{"stale_velocity", apic, KernelName::linear, {{"g2p", "momentum_y"}, {"g2p", "kinetic"}}},
        Red{"padded_mass", flip, KernelName::linear, {{"p2g", "momentum_x"}, {"p2g", "momentum_y"}}}),
    named);

TEST(Museum, TurnsTheSameLinesRedInSpace) {
  const auto red = [](std::string_view mistake, int scheme, KernelName kernel, std::string_view stage,
                      std::string_view quantity) {
    const Scene scene = column(scheme, kernel, 3);
    const Course right(scene, "", 0.3), wrong(scene, mistake, 0.3);
    EXPECT_FALSE(right.any_fails()) << mistake;
    EXPECT_EQ(wrong.claim(stage, quantity), Claim::fails) << mistake;
  };
  red("reversed_offset", polypic, KernelName::linear, "p2g", "angular_momentum_z");
  red("transposed_c", apic, KernelName::quadratic, "g2p", "angular_momentum_z");
  red("gradient_c", apic, KernelName::cubic, "g2p", "angular_momentum_z");
  red("late_old", flip, KernelName::linear, "g2p", "momentum_y");
  red("moved_early", apic, KernelName::linear, "g2p", "momentum_x");
  red("stale_velocity", rpic, KernelName::linear, "g2p", "momentum_y");
  red("padded_mass", pic, KernelName::linear, "p2g", "momentum_y");
}

// === Those that no proposition speaks of, so that a number changes

TEST(Museum, ALooseToleranceLeavesDivergence) {
  const Scene scene = column(apic, KernelName::linear);
  const double right = Course(scene, "").curve("divergence"),
               wrong = Course(scene, "loose_tolerance").curve("divergence");
  EXPECT_GT(wrong, 100 * right); // measured: 1.9e-8 and 2.4e-5
  EXPECT_LT(wrong, 1e-3);
}

TEST(Museum, ASmallRadiusLosesVolumeMoreSoInSpace) {
  const auto lost = [](int dim) {
    const Scene scene = column(apic, KernelName::linear, dim);
    return Course(scene, "", 0.1).curve("settled_volume") - Course(scene, "small_radius", 0.1).curve("settled_volume");
  };
  const double plane = lost(2), space = lost(3);
  EXPECT_GT(plane, 0.02);
  EXPECT_GT(space, plane);
}

TEST(Museum, LateWallsLeaveDivergenceAtTheFloor) {
  const Scene scene = column(apic, KernelName::linear);
  const Course right(scene, ""), wrong(scene, "late_walls");
  EXPECT_GT(wrong.curve("divergence"), 1e-4); // 5e-3
  EXPECT_LT(right.curve("divergence"), 1e-6);
  EXPECT_LT(wrong.curve("settled_volume"), right.curve("settled_volume") - 0.03); // 0.977 and 1.060
}

TEST(Museum, WithoutExtrapolationThatStageTakesEnergy) {
  const Scene scene = column(apic, KernelName::linear);
  EXPECT_GT(Course(scene, "").total("extrapolation", "kinetic"), 0); // 26 J/m: it fills faces that had none
  EXPECT_LT(Course(scene, "no_extrapolation").total("extrapolation", "kinetic"), -20);
}

TEST(Museum, TheOtherAlphaMakesPicOfFlip) {
  Scene scene = column(flip, KernelName::linear);
  const Course right(scene, ""), wrong(scene, "other_alpha");
  EXPECT_GT(wrong.curve("transfer_loss"), 5 * right.curve("transfer_loss")); // 213 and 15 J/m
  scene.settings.transfer.scheme = pic;
  const Course pure(scene, "");
  EXPECT_EQ(wrong.end->x, pure.end->x) << "FLIP 1 read as a share of PIC of 1 is PIC, to the bit";
}

// === What a run with a mistake says and does

TEST(Museum, SaysSoInTitleNoteAndWatermark) {
  const Scene scene = column(apic, KernelName::linear);
  const Course wrong(scene, "reversed_offset", 0.1);
  EXPECT_EQ(wrong.end->title, "APIC, mistake");
  EXPECT_EQ(wrong.end->watermark, "WITH A MISTAKE: reversed offset");
  EXPECT_THAT(wrong.end->notes.front(), HasSubstr("wrong sign"));
  EXPECT_EQ(Course(scene, "", 0.1).end->watermark, "");
  const Scene other = column(flip, KernelName::linear);
  const Course same(other, "", 0.1);
  for (const Parameter& p : wrong.end->parameters) // nothing gives away that a number was changed
    if (p.path.starts_with("pressure.") || p.path.starts_with("fluid.")) {
      const auto at = std::find_if(same.end->parameters.begin(), same.end->parameters.end(),
                                   [&](const Parameter& q) { return q.path == p.path; });
      EXPECT_EQ(p.value, at->value) << p.path;
    }
}

TEST(Museum, StandsStillWhereItFliesApart) {
  const Scene scene = column(apic, KernelName::quadratic);
  const Course early(scene, "twice_d", 0.2), late(scene, "twice_d", 0.4);
  EXPECT_THAT(early.end->watermark, HasSubstr("flew apart at"));
  EXPECT_EQ(early.end->watermark, late.end->watermark);
  EXPECT_EQ(late.end->x, early.end->x);
  EXPECT_NEAR(late.end->time, 0.4, 1e-9);
  const auto& t = late.end->history->t;
  EXPECT_TRUE(std::is_sorted(t.begin(), t.end(), std::less_equal<>())) << "no row twice";
}

TEST(Museum, RunsEveryMistakeInEveryPrecisionAndDimension) {
  for (const museum::Exhibit& e : museum::exhibits())
    for (const int dim : {2, 3})
      for (const int scheme : {apic, flip}) {
        const Scene scene =
            column(scheme, e.name == "quadratic_d" ? KernelName::cubic : KernelName::quadratic, dim, Precision::single);
        if (!museum::needs(number_of(e.name), scene.settings).empty()) continue;
        const Course right(scene, "", 0.15), wrong(scene, e.name, 0.15);
        EXPECT_NE(right.end->v, wrong.end->v) << e.name << " " << dim << " " << scheme_names[scheme];
      }
}

TEST(Museum, EveryMysteryIsAllOfThemInSomeOrder) {
  std::set<std::size_t> first;
  for (int n = 1; n <= 200; ++n) {
    const std::vector<std::size_t> order = museum::mystery_order(n);
    EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), museum::exhibits().size());
    first.insert(order.front());
  }
  EXPECT_EQ(first.size(), museum::exhibits().size()) << "every one comes first for some number";
}

TEST(Museum, KeepsToTheStepItWasMadeFor) {
  Budget budget(1);
  Pool pool(budget);
  const Budget::Permit permit(budget);
  Scene scene = column(apic, KernelName::linear);
  const museum::Hung hung = museum::hang({{number_of("moved_early")}, 0}, number_of("moved_early"));
  EXPECT_THAT(museum::make_mistaken(scene, hung, pool)->set("time.splitting", "midpoint").message, HasSubstr("lie"));
  scene.settings.time.splitting = Splitting::midpoint;
  EXPECT_THROW((void)museum::make_mistaken(scene, hung, pool), UserError);
}

} // namespace
} // namespace flipbook::test
