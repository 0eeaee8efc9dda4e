// SPDX-License-Identifier: MIT
// What figures claim is in their numbers: read from their tables, as computed with few cells.
#include "app/figures/spec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace flipbook::app {
namespace {

using Row = std::map<std::string, std::string>;

/// The rows of a figure's first table, by column.
std::vector<Row> rows_of(const std::string& figure) {
  Budget budget(2);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  const FigureTable table = kind_of(read_figure(figure, true))->compute({pool})->tables().front();
  std::vector<Row> rows;
  for (const auto& cells : table.rows) {
    rows.emplace_back();
    for (std::size_t c = 0; c < cells.size(); ++c) rows.back()[table.columns[c]] = cells[c];
  }
  return rows;
}

double number(const Row& row, const std::string& column) {
  return std::stod(row.at(column));
}

TEST(Claims, TheMoreAParticleKeepsTheMoreEnergyComesBack) {
  std::map<std::string, double> kept, all;
  for (const Row& r : rows_of("lens")) {
    kept[r.at("panel")] += number(r, "weight") * std::pow(number(r, "painted"), 2);
    all[r.at("panel")] += number(r, "weight") * std::pow(number(r, "grid"), 2);
  }
  const auto share = [&](const std::string& panel) { return kept.at(panel) / all.at(panel); };
  EXPECT_LT(share("PIC, FLIP keep 2") + 0.05, share("RPIC keeps 3"));
  EXPECT_LT(share("RPIC keeps 3") + 0.05, share("APIC keeps 6"));
  EXPECT_LT(share("APIC keeps 6") + 0.03, share("PolyPIC keeps 8"));
  EXPECT_LT(share("PolyPIC keeps 8"), 1);
}

TEST(Claims, AStepConservesWhatTheStoryboardDraws) {
  double before = 0, on_grid = 0;
  Budget budget(1);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  const auto tables = kind_of(read_figure("storyboard", true))->compute({pool})->tables();
  for (const auto& row : tables[0].rows) before += std::stod(row[3]);                      // m = 1, vx
  for (const auto& row : tables[1].rows) on_grid += std::stod(row[2]) * std::stod(row[3]); // m u
  EXPECT_NEAR(on_grid, before, 1e-12);
  EXPECT_GT(std::abs(before), 1);
}

TEST(Claims, ApicAndRpicKeepTheSpinOfTheDisc) {
  for (const Row& r : rows_of("rotating_disc")) {
    const double L = number(r, "L_ratio");
    if (r.at("scheme") == "APIC" || r.at("scheme") == "RPIC") {
      EXPECT_NEAR(L, 1, 1e-12) << r.at("scheme");
    }
    if (r.at("scheme") == "PIC" && number(r, "revolutions") >= 1) {
      EXPECT_LT(L, 0.1);
    }
  }
}

TEST(Claims, TheViscosityIsTheVarianceOfTheKernel) {
  const std::map<std::string, double> variance{{"linear", 1.0 / 6}, {"quadratic", 1.0 / 4}, {"cubic", 1.0 / 3}};
  int compared = 0;
  for (const Row& r : rows_of("viscosity"))
    if (const auto at = variance.find(r.at("series")); at != variance.end()) {
      const double predicted = at->second * (1 - number(r, "x"));
      EXPECT_NEAR(number(r, "y"), predicted, 0.08 * predicted + 0.002) << r.at("series");
      ++compared;
    }
  EXPECT_EQ(compared, 6);
}

TEST(Claims, WhatMustFailIsTenPowersOfTenAway) {
  double worst = 0, least = 1;
  for (const Row& r : rows_of("propositions")) {
    if (r.at("standing") == "must fail")
      least = std::min(least, number(r, "error"));
    else if (r.at("precision") == "double")
      worst = std::max(worst, number(r, "error"));
  }
  EXPECT_GT(worst, 0);
  EXPECT_GT(least, 1e10 * worst);
}

TEST(Claims, OnlyTheReportsSpinKeepsAngularMomentumWithTheLinearKernel) {
  double off = 0;
  for (const Row& r : rows_of("rpic_spin")) {
    if (!r.at("panel").starts_with("Angular")) continue;
    const double share = number(r, "y");
    if (r.at("series") == "skew part, linear")
      off = std::max(off, std::abs(share - 1));
    else
      EXPECT_NEAR(share, 1, 1e-10) << r.at("series");
  }
  EXPECT_GT(off, 0.1);
}

TEST(Claims, PreconditionersSaveIterations) {
  std::map<std::string, double> after_ten;
  for (const Row& r : rows_of("pressure"))
    if (r.at("panel").starts_with("Residual") && number(r, "x") <= 10) after_ten[r.at("series")] = number(r, "y");
  EXPECT_LT(after_ten.at("multigrid-CG"), 0.1 * after_ten.at("MIC(0)-CG"));
  EXPECT_LT(after_ten.at("MIC(0)-CG"), 0.1 * after_ten.at("CG"));
}

TEST(Claims, TheDropFillsItsEllipse) {
  for (const Row& r : rows_of("elliptical_drop")) {
    EXPECT_NEAR(number(r, "a"), number(r, "exact_a"), 0.01 * number(r, "exact_a"));
    EXPECT_NEAR(number(r, "b"), number(r, "exact_b"), 0.01 * number(r, "exact_b"));
  }
}

} // namespace
} // namespace flipbook::app
