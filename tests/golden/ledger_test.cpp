// SPDX-License-Identifier: MIT
// What the table of a ledger says.
#include "render/views/ledger_text.h"
#include "render/views/plots.h"
#include "tests/golden/ledgers.h"
#include "tests/golden/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using render::LedgerColumn;
using render::LedgerColumns;
using render::LedgerText;
using render::LedgerView;
using testing::ElementsAre;
using testing::HasSubstr;
using Claim = LedgerTable::Claim;

LedgerText said(const LedgerTable& l, LedgerView view = LedgerView::total, LedgerColumns columns = LedgerColumns::all) {
  Snapshot s;
  s.dim = l.quantities.size() == 6 ? 2 : 3;
  s.ledger = std::make_shared<LedgerTable>(l);
  return ledger_text(s, view, columns);
}

std::vector<std::string> texts(const LedgerColumn& c) {
  std::vector<std::string> all;
  for (const render::LedgerCell& cell : c.cells) all.push_back(cell.text);
  return all;
}

std::vector<std::string> heads(const LedgerText& t) {
  std::vector<std::string> all;
  for (const LedgerColumn& c : t.columns) all.push_back(c.symbol + c.index + " " + c.unit);
  return all;
}

TEST(LedgerText, ShowsWhatWasHeldWhatChangedAndWhatIsHeld) {
  const LedgerText t = said(dam_ledger(2, false));
  EXPECT_THAT(t.rows, ElementsAre("at the start", "P2G", "free faces", "forces", "walls", "projection", "extrapolation",
                                  "G2P", "advection", "held now"));
  EXPECT_THAT(heads(t),
              ElementsAre("kinetic % of 761 J/m", "Lz kg m²/s/m", "px kg m/s/m", "py kg m/s/m", "potential kJ/m"));
  EXPECT_THAT(texts(t.columns[0]), ElementsAre("·", "·", "·", "+100.0", "·", "−0.4", "+0.02", "−5.5", "·", "94.1"));
  EXPECT_THAT(texts(t.columns[4]), ElementsAre("1.256", "·", "·", "·", "·", "·", "·", "·", "−0.739", "0.517"));
  EXPECT_EQ(t.title, "since the start");
}

TEST(LedgerText, RoundingIsADot) {
  for (const bool affine : {false, true}) {
    const LedgerText t = said(dam_ledger(2, affine));
    EXPECT_EQ(t.columns[2].cells[1].text, "·");
    EXPECT_TRUE(t.columns[2].cells[1].nothing);
    EXPECT_EQ(t.columns[2].cells[1].claim, Claim::holds);
  }
}

/// However small: what fails is beyond rounding.
TEST(LedgerText, WhatFailsIsNeverADot) {
  LedgerTable l = dam_ledger(2, true);
  set_change(l, "g2p", "angular_momentum_z", -3e-5);
  set_claim(l, "g2p", "angular_momentum_z", Claim::fails);
  const render::LedgerCell cell = said(l).columns[1].cells[7];
  EXPECT_EQ(cell.text, "−3e−5");
  EXPECT_FALSE(cell.nothing);
}

TEST(LedgerText, SaysWhereKineticEnergyWasLost) {
  EXPECT_EQ(said(dam_ledger(2, false)).sentence,
            "Kinetic energy lost: G2P 5.5\u00a0%, projection 0.4\u00a0%, elsewhere 0.");
  EXPECT_EQ(said(dam_ledger(2, true)).sentence,
            "Kinetic energy lost: P2G 0.8\u00a0%, projection 0.4\u00a0%, G2P 0.3\u00a0%, elsewhere 0.");
  EXPECT_EQ(said(empty_ledger(2)).sentence, "No kinetic energy yet.");
}

/// FLIP's particles keep what the grid cannot hold: P2G takes it out and G2P puts it back, in every step.
TEST(LedgerText, TakesTransfersTogetherWhereOneGivesBack) {
  EXPECT_EQ(said(vortex_ledger()).sentence,
            "Kinetic energy lost: projection 1.6\u00a0%, transfers 1.4\u00a0%, elsewhere 0.");
  LedgerTable l = vortex_ledger();
  set_change(l, "advection", "kinetic", 0.002);
  EXPECT_THAT(said(l).sentence, HasSubstr("elsewhere 0; advection added 0.8\u00a0%."));
}

/// A step loses little of what there is.
TEST(LedgerText, SaysSmallLossesOfAStep) {
  LedgerTable l = empty_ledger(2);
  l.step_in = 100;
  set_change(l, "g2p", "kinetic", -0.04);
  set_change(l, "projection", "kinetic", -0.003);
  EXPECT_EQ(said(l, LedgerView::step).sentence, "Kinetic energy lost: G2P 0.04\u00a0%, elsewhere 0.");
  set_change(l, "g2p", "kinetic", 1e-6);
  set_change(l, "projection", "kinetic", -1e-6);
  EXPECT_EQ(said(l, LedgerView::step).sentence, "No stage lost kinetic energy.");
}

TEST(LedgerText, StepsReferToWhatTheStepHad) {
  LedgerTable l = dam_ledger(2, false);
  for (double& x : l.step) x = 0;
  l.step[l.at(6, 4)] = -7; // G2P, kinetic
  l.step_in = 700;
  const LedgerText t = said(l, LedgerView::step);
  EXPECT_EQ(t.title, "last step");
  EXPECT_EQ(t.columns[0].unit, "% of 700 J/m");
  EXPECT_EQ(t.rows.front(), "before the step");
  EXPECT_EQ(t.columns[0].cells[7].text, "−1.0");
  EXPECT_THAT(t.sentence, HasSubstr("G2P 1.0\u00a0%, elsewhere 0."));
  EXPECT_DOUBLE_EQ(std::stod(t.columns[0].cells.front().text) - 1, std::stod(t.columns[0].cells.back().text));
}

TEST(LedgerText, SaysWhatIsNotDefined) {
  const LedgerColumn c = said(vortex_ledger()).columns[1];
  EXPECT_EQ(c.unit, "not defined");
  for (const render::LedgerCell& cell : c.cells) {
    EXPECT_EQ(cell.text, "–");
    EXPECT_EQ(cell.claim, Claim::none);
  }
}

TEST(LedgerText, VectorsInSpaceAreLengthsAndTheirWorstClaim) {
  LedgerTable l = dam_ledger(3, true);
  set_claim(l, "g2p", "angular_momentum_y", Claim::fails);
  set_claim(l, "p2g", "momentum_z", Claim::none);
  const LedgerText t = said(l);
  EXPECT_THAT(heads(t), ElementsAre("kinetic % of 761 J", "|L| kg m²/s", "|p| kg m/s", "potential kJ"));
  EXPECT_EQ(t.columns[1].cells[7].claim, Claim::fails);
  EXPECT_EQ(t.columns[2].cells[1].claim, Claim::none) << "nothing is said about one component";
  EXPECT_EQ(t.columns[2].cells[7].claim, Claim::holds);
  EXPECT_EQ(t.columns[2].cells[5].text, "1446");
}

TEST(LedgerText, FormsGoFromMuchToLittle) {
  const LedgerTable l = dam_ledger(2, true);
  using enum LedgerColumns;
  EXPECT_EQ(heads(said(l, LedgerView::total, all)).size(), 5U);
  EXPECT_EQ(heads(said(l, LedgerView::total, without_potential)).size(), 4U);
  EXPECT_THAT(heads(said(l, LedgerView::total, lengths)),
              ElementsAre("kinetic % of 761 J/m", "Lz kg m²/s/m", "|p| kg m/s/m"));
  EXPECT_THAT(heads(said(l, LedgerView::total, no_momentum)), ElementsAre("kinetic % of 761 J/m", "Lz kg m²/s/m"));
  EXPECT_THAT(heads(said(l, LedgerView::total, energy)), ElementsAre("kinetic % of 761 J/m"));
}

/// A solid: the same with energy that the walls put into its deformation.
LedgerTable solid_ledger() {
  const LedgerTable fluid = dam_ledger(2, true);
  LedgerTable l = fluid;
  l.quantities.push_back({"elastic", "elastic", "J/m", 0, 0, true});
  const std::size_t size = l.stages.size() * l.quantities.size();
  l.step.assign(size, 0);
  l.total.assign(size, 0);
  l.claims.assign(size, Claim::none);
  for (std::size_t s = 0; s < l.stages.size(); ++s)
    for (std::size_t q = 0; q < fluid.quantities.size(); ++q) l.total[l.at(s, q)] = fluid.total[fluid.at(s, q)];
  set_change(l, "advection", "elastic", 212.6);
  close(l);
  return l;
}

TEST(LedgerText, SolidsShowTheirElasticEnergy) {
  const LedgerTable l = solid_ledger();
  using enum LedgerColumns;
  EXPECT_THAT(heads(said(l)), ElementsAre("kinetic % of 761 J/m", "elastic J/m", "Lz kg m²/s/m", "px kg m/s/m",
                                          "py kg m/s/m", "potential kJ/m"));
  EXPECT_THAT(texts(said(l).columns[1]), ElementsAre("·", "·", "·", "·", "·", "·", "·", "·", "+213", "213"));
  EXPECT_THAT(heads(said(l, LedgerView::total, no_momentum)),
              ElementsAre("kinetic % of 761 J/m", "elastic J/m", "Lz kg m²/s/m"));
  EXPECT_EQ(heads(said(l, LedgerView::total, energy)).size(), 1U);
}

/// Numbers of any size stay in their column.
TEST(LedgerText, NumbersFitTheirColumns) {
  const render::gui::Fonts fonts(1);
  for (const double size : {1e-9, 3e-4, 0.099996, 1.0, 9.9996, 99.96, 1234.56, 9999.96, 99999.4, 1.5e7, 3e19})
    for (const double held : {0.0, 1e-5, 1.0, 1e4, 1e12}) {
      LedgerTable l = dam_ledger(2, true);
      set_change(l, "g2p", "", -size);
      for (LedgerTable::Quantity& q : l.quantities) q.start = -held;
      close(l);
      for (const LedgerColumn& c : said(l).columns)
        for (const render::LedgerCell& cell : c.cells)
          EXPECT_LE(fonts.width(render::gui::Type::small, cell.text),
                    fonts.width(render::gui::Type::small, render::widest_cell))
              << cell.text;
    }
}

// === What all this makes of a picture

class LedgerPicture : public testing::Test {
protected:
  [[nodiscard]] std::vector<std::string> words(const render::Frame& frame, const std::vector<std::string>& view,
                                               int width = 1280, int height = 720) const {
    render::Renderer renderer(*context_, width, height, {});
    (void)renderer.draw(frame, view_with(view));
    std::vector<std::string> all;
    for (const render::TextBox& t : renderer.labels()) all.push_back(t.text);
    return all;
  }
  std::unique_ptr<render::Context> context_ = render::Context::create(render::Backend::automatic);
};

const std::string shared_note =
    "Particles move with the grid's velocity (rk2, rk3), not with their own: angular momentum need not hold exactly.";

/// One note is said by all panes, a second one by one of two.
TEST_F(LedgerPicture, SaysSharedNotesOnceAndOwnNotesAtTheirPane) {
  const auto off = words(ledger_frame(2), {"view.plot_height=0"});
  EXPECT_THAT(off, testing::Contains(shared_note + "  (and 1 more)"));
  const auto on = words(ledger_frame(2), {"view.plot_height=0", "view.ledger=total"});
  EXPECT_THAT(on, testing::Contains(shared_note));
  EXPECT_THAT(on, testing::Contains(HasSubstr("PIC damps every rotation")).Times(1));
  EXPECT_THAT(on, testing::Not(testing::Contains(HasSubstr("more)"))));
}

TEST_F(LedgerPicture, CountsTheNotesThatFindNoRoom) {
  render::Frame f = ledger_frame(2);
  auto s = std::make_shared<Snapshot>(*f.panes[1].snapshot);
  for (int i = 0; i < 30; ++i) s->notes.push_back("Note " + std::to_string(i) + " of this pane.");
  f.panes[1].snapshot = s;
  const auto all = words(f, {"view.ledger=total"});
  EXPECT_THAT(all, testing::Contains("Note 0 of this pane."));
  EXPECT_THAT(all, testing::Contains(testing::ContainsRegex("Note [0-9]+ of this pane. .and [0-9]+ more.")));
}

TEST_F(LedgerPicture, SaysWhereThereIsNoLedger) {
  EXPECT_THAT(words(dam_frame(2), {"view.ledger=total"}),
              testing::Contains("Warning: view.ledger: no pane keeps a ledger"));
  render::Frame f = ledger_frame(2);
  f.panes[0] = dam_frame(2).panes[0];
  EXPECT_THAT(words(f, {"view.ledger=total"}), testing::Contains("This solver keeps no ledger."));
}

/// The tables stay where they are while their numbers change: a video must not jump.
TEST_F(LedgerPicture, StaysWhereItIs) {
  const auto boxes = [&](const render::Frame& f) {
    render::Renderer renderer(*context_, 1280, 720, {});
    (void)renderer.draw(f, view_with({"view.ledger=total"}));
    std::vector<std::pair<float, float>> all;
    for (const render::TextBox& t : renderer.labels())
      if (t.text == "G2P" || t.text == "held now") all.emplace_back(t.box.x, t.box.y);
    return all;
  };
  render::Frame start = ledger_frame(2);
  for (render::Pane& p : start.panes) {
    auto s = std::make_shared<Snapshot>(*p.snapshot);
    s->ledger = std::make_shared<LedgerTable>(empty_ledger(2));
    p.snapshot = s;
  }
  EXPECT_EQ(boxes(start).size(), 4U);
  EXPECT_EQ(boxes(start), boxes(ledger_frame(2)));
}

/// "lost" stands for a plot of every stage that the run can have, whatever has happened yet.
TEST(Plots, OfWhatEachStageLost) {
  render::Frame f = ledger_frame(2);
  History h{{0, 1}, {}};
  for (const char* name : {"kinetic", "lost_p2g", "lost_forces", "lost_walls", "lost_g2p", "lost_spacing"})
    h.columns.push_back({name, "J/m", {0, 0}});
  for (render::Pane& p : f.panes) {
    auto s = std::make_shared<Snapshot>(*p.snapshot);
    s->history = std::make_shared<History>(h);
    p.snapshot = s;
  }
  std::vector<std::string> names;
  for (const render::Plot& p : render::plots_of(f, view_with({"view.plots=lost_g2p,lost,kinetic"})))
    names.push_back(p.name);
  EXPECT_THAT(names, ElementsAre("lost_g2p", "lost_p2g", "lost_walls", "kinetic"))
      << "each once, without forces, and without stages that the run cannot have";
}

} // namespace
} // namespace flipbook::test
