// SPDX-License-Identifier: MIT
// The fast version of every validation case: what flipbook validate --fast checks, for the schemes that the cases gate.
#include "app/validate/case.h"
#include "app/validate/report_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace flipbook::app {
namespace {

ValidationReport run_fast(const ValidationCase& c, std::vector<std::string> schemes, int threads) {
  Budget budget(threads);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  ValidationRequest request;
  request.fast = true;
  request.seeds = 1;
  request.schemes = std::move(schemes);
  return c.run(request, {pool});
}

const ValidationCase& case_named(const std::string& name) {
  for (const auto& c : validation_cases())
    if (c->name() == name) return *c;
  throw std::logic_error("no case " + name);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& c : validation_cases()) all.push_back(c->name());
  return all;
}

class ValidationCases : public testing::TestWithParam<std::string> {};

TEST_P(ValidationCases, FastVersionKeepsItsGates) {
  // Where a run takes seconds, two of the schemes; the cases themselves compare more.
  std::vector<std::string> schemes;
  for (const char* slow : {"standing_wave", "leapfrog", "taylor_vortices", "two_discs"})
    if (GetParam() == slow) schemes = {"flip:1", "apic"};
  const ValidationReport report = run_fast(case_named(GetParam()), schemes, 2);
  std::size_t gates = 0;
  for (const ValidationRow& r : report.rows) {
    gates += r.gate.has_value();
    EXPECT_TRUE(r.passed()) << r.scheme << ' ' << r.setting << ' ' << r.cells << ' ' << r.quantity << ": "
                            << r.value.min << " .. " << r.value.max << " is outside " << r.gate->lo << " .. "
                            << r.gate->hi;
  }
  EXPECT_GT(gates, 0u);
  EXPECT_FALSE(report.ran.empty());
  ASSERT_FALSE(report.chart.panels.empty());
  for (const auto& panel : report.chart.panels) EXPECT_FALSE(panel.series.empty()) << panel.title;
}

INSTANTIATE_TEST_SUITE_P(All, ValidationCases, testing::ValuesIn(names()), [](const auto& run) { return run.param; });

TEST(Validation, ResultsDoNotDependOnThreads) {
  const ValidationCase& c = case_named("elliptical_drop");
  EXPECT_EQ(csv_text(c, run_fast(c, {"apic"}, 1)), csv_text(c, run_fast(c, {"apic"}, 3)));
}

TEST(Validation, PicsViscosityIsNotTakenForApics) {
  // A gate that PIC's figure must miss: the same number with APIC's bounds.
  const ValidationReport report = run_fast(case_named("lamb_oseen"), {"pic", "apic"}, 2);
  ASSERT_EQ(report.rows.size(), 2u);
  ValidationRow wrong = report.rows[0];
  wrong.gate = report.rows[1].gate;
  EXPECT_TRUE(report.rows[0].passed());
  EXPECT_FALSE(wrong.passed());
}

} // namespace
} // namespace flipbook::app
