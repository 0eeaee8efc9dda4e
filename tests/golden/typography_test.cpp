// SPDX-License-Identifier: MIT
// Every picture that can be asked for: no text covers another or leaves the picture, and none is smaller than can be
// read. Only measured, not drawn, so that all combinations can be tried.
#include "app/panel/panel.h"
#include "tests/golden/curves.h"
#include "tests/golden/ledgers.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using render::Rect;

struct Size {
  int width, height;
};

/// Long enough for any picture, with a unit of some length and values of all magnitudes.
std::vector<MadeCurve> long_curves() {
  std::vector<MadeCurve> all = energies();
  all.push_back({"angular_momentum_ratio", "", [](auto i, double t) { return 1 - 0.1 * static_cast<double>(i) * t; }});
  all.push_back({"angular_momentum_z", "kg m^2/s/m",
                 [](auto i, double t) { return -123456 * std::sin(9 * t + static_cast<double>(i)); }});
  all.push_back({"a_quantity_of_somebody_else", "kg m^2/s^3/m", [](auto, double t) { return 1e-9 + 1e9 * t; }});
  all.push_back({"divergence", "", [](auto i, double t) { return std::pow(10.0, -9.0 + static_cast<double>(i) * t); }});
  return all;
}

class Typography : public testing::TestWithParam<Size> {
protected:
  /// False at the first text that covers another or leaves the picture; one message for each picture is enough.
  [[nodiscard]] testing::AssertionResult clear(const render::Frame& frame, const render::ViewSettings& view) {
    const std::vector<render::TextBox>& labels = renderer_.measure(frame, view);
    if (labels.size() < 2 * frame.panes.size()) return testing::AssertionFailure() << "texts are missing";
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto& [box, text] = labels[i];
      if (box.x < 0 || box.y < 0 || box.right() > static_cast<float>(GetParam().width) ||
          box.bottom() > static_cast<float>(GetParam().height))
        return testing::AssertionFailure() << "\"" << text << "\" leaves the picture";
      for (std::size_t k = i + 1; k < labels.size(); ++k)
        if (box.overlaps(labels[k].box))
          return testing::AssertionFailure() << "\"" << text << "\" covers \"" << labels[k].text << "\"";
    }
    return testing::AssertionSuccess();
  }

  std::unique_ptr<render::Context> context_ = render::Context::create(render::Backend::automatic);
  render::Renderer renderer_{*context_, GetParam().width, GetParam().height, app::make_panel()};
};

/// The panes, flat or in space, with short or long texts.
render::Frame panes_of(std::size_t panes, bool space, bool wordy) {
  render::Frame f = wordy ? curves_frame(panes, long_curves()) : ledger_frame(panes);
  const render::Frame ledgers = ledger_frame(panes);
  for (std::size_t i = 0; i < panes; ++i) {
    auto s = std::make_shared<Snapshot>(space ? *stored("dam_3d") : *f.panes[i].snapshot);
    s->history = f.panes[i].snapshot->history;
    s->ledger = space ? std::make_shared<LedgerTable>(dam_ledger(3, i % 2 == 0)) : ledgers.panes[i].snapshot->ledger;
    f.panes[i].snapshot = s;
    if (wordy) f.panes[i].title += ", quadratic, CFL 0.5, midpoint, no-slip walls, 256 × 256 cells";
  }
  f.labelled = true;
  f.label = "What the timeline says";
  if (!wordy) return f;
  f.label += " at great length" + std::string(300, '-');
  f.title += " to energy, vorticity and everything else that a reader of this very long title could want to know";
  f.warnings = {"panes 1 and 2 show identical particles", "one that goes on " + std::string(400, '-') + " and on"};
  add_references(f, "total");
  add_references(f, "kinetic");
  return f;
}

const std::vector<std::string>& plots() {
  static const std::vector<std::string> all{
      "view.plots=kinetic,potential,total,transfer_loss",
      "view.plots=total,angular_momentum_z,a_quantity_of_somebody_else,divergence,angular_momentum_ratio,kinetic"};
  return all;
}

TEST_P(Typography, NothingCoversAnything) {
  for (std::size_t panes = 1; panes <= 12; ++panes)
    for (const bool space : {false, true})
      for (const bool wordy : {false, true}) {
        const render::Frame frame = panes_of(panes, space, wordy);
        for (const char* panel : {"true", "false"})
          for (const char* ledger : {"off", "total"}) {
            std::vector<std::string> changes{plots()[wordy ? 1 : 0], std::string("view.show_panel=") + panel,
                                             std::string("view.ledger=") + ledger};
            if (wordy) changes.insert(changes.end(), {"view.log=divergence,total", "view.shared_axes=true"});
            EXPECT_TRUE(clear(frame, view_with(changes)))
                << panes << " panes, " << (space ? "3D" : "2D") << (wordy ? ", long texts" : "") << ", panel " << panel
                << ", ledger " << ledger;
          }
      }
}

/// The numbers at the ends of curves go with them: at any moment of a run, and where all curves meet.
TEST_P(Typography, EndValuesKeepClearAtAnyTime) {
  for (const double until : {0.01, 0.3, 0.93, 0.999, 1.0})
    for (const std::size_t panes : {1U, 2U, 4U, 6U, 9U}) {
      std::vector<MadeCurve> curves = energies();
      curves.push_back({"kept", "", [](auto, double) { return 0.5; }});
      render::Frame frame = curves_frame(panes, curves, until);
      for (const char* chosen : {"view.plots=kinetic,kept", "view.plots=kept"})
        EXPECT_TRUE(clear(frame, view_with({chosen, "view.plot_height=0.4"}))) << until << ", " << panes << " panes";
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Typography,
                         testing::Values(Size{640, 480}, Size{854, 480}, Size{1280, 720}, Size{1920, 1080},
                                         Size{2560, 1440}, Size{3840, 2160}, Size{1080, 1080}, Size{1080, 1920}),
                         [](const auto& test) {
                           return std::to_string(test.param.width) + "x" + std::to_string(test.param.height);
                         });

} // namespace
} // namespace flipbook::test
