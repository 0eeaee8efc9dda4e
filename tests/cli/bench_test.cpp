// SPDX-License-Identifier: MIT
// flipbook bench from outside: that each workload runs and says all that it promises. No time is judged.
#include "app/bench/report.h"
#include "app/bench/traffic.h"
#include "sim/frame/errors.h"
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace flipbook::test {

namespace {

using app::BenchRow;
using app::CaseResult;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

Outcome bench(const Folder& f, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"bench", "--size", "small", "--threads", "2"});
  return run(arguments, f.path());
}

std::set<std::string> values_of(const nlohmann::json& rows, const char* key, const std::string& workload) {
  std::set<std::string> all;
  for (const auto& r : rows)
    if (r["workload"] == workload) all.insert(r[key].get<std::string>());
  return all;
}

TEST(Bench, ListsItsWorkloads) {
  const Folder f;
  const Outcome o = run({"bench", "--list"}, f.path());
  EXPECT_EQ(o.code, 0);
  for (const char* name : {"W2", "W3-64", "W3-128", "T", "P-64", "P-128", "P-256", "transfers", "C4", "D3"})
    EXPECT_THAT("\n" + o.out, HasSubstr(std::string("\n") + name + " "));
}

TEST(Bench, TellsThePhasesOfAStepApart) {
  const Folder f;
  const Outcome o = bench(f, {"W2,W3-64", "--schemes", "apic", "--json"});
  ASSERT_EQ(o.code, 0) << o.err;
  const auto rows = nlohmann::json::parse(o.out);
  for (const char* workload : {"W2", "W3-64"}) {
    EXPECT_THAT(values_of(rows, "part", workload),
                IsSupersetOf({"sort", "level set", "P2G", "extrapolate", "forces", "pressure set-up", "pressure solve",
                              "G2P", "advect", "ledger", "snapshot", "other", "step", "pressure", "run"}));
    EXPECT_THAT(values_of(rows, "quantity", workload),
                IsSupersetOf({"wall", "cpu", "bandwidth", "of memory", "particle-steps", "iterations", "peak memory"}));
  }
  EXPECT_EQ(values_of(rows, "case", "W2"), (std::set<std::string>{"APIC linear single"}));
  EXPECT_EQ(values_of(rows, "case", "W3-64"), (std::set<std::string>{"APIC linear single", "APIC quadratic single"}));
  EXPECT_EQ(values_of(rows, "quantity", "machine"), (std::set<std::string>{"triad", "multiply-add"}));
  double parts = 0, step = 0;
  for (const auto& r : rows) {
    EXPECT_LE(r["min"], r["median"]);
    EXPECT_LE(r["median"], r["max"]);
    if (r["workload"] != "W2" || r["quantity"] != "wall") continue;
    (r["part"] == "step" ? step : parts) += r["median"].get<double>();
  }
  EXPECT_NEAR(parts, step, 1e-9 * step) << "the phases are exclusive and leave nothing out";
}

TEST(Bench, MeasuresEveryTransfer) {
  const Folder f;
  const Outcome o = bench(f, {"transfers", "--json"});
  ASSERT_EQ(o.code, 0) << o.err;
  const auto rows = nlohmann::json::parse(o.out);
  std::set<std::string> expected;
  for (const char* dim : {"2D ", "3D "})
    for (const char* precision : {"single ", "double "})
      for (const char* lattice : {"mac ", "nodes "})
        for (const char* kernel : {"linear ", "quadratic ", "cubic "})
          for (const char* mode : {"none", "rigid", "full", "polynomial"})
            expected.insert(std::string(dim) + precision + lattice + kernel + mode);
  EXPECT_EQ(values_of(rows, "case", "transfers"), expected);
  EXPECT_EQ(values_of(rows, "part", "transfers"), (std::set<std::string>{"P2G", "G2P"}));
  std::size_t units = 0;
  for (const auto& r : rows)
    units +=
        r["case"] == "3D single mac linear full" && r["quantity"] == "per sample, linear APIC = 1" && r["median"] == 1;
  EXPECT_EQ(units, 2U) << "P2G and G2P of what the others are measured by";
}

TEST(Bench, MeasuresThePressureAndTheNotesSizeAndScaling) {
  const Folder f;
  const Outcome o = bench(
      f, {"P-64,T", "--schemes", "apic", "--scaling", "--set", "grid.cells=[8,16,8]", "--set", "grid.size=[1,2,1]"});
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, HasSubstr("iterations"));
  EXPECT_THAT(o.out, HasSubstr("8x16x8 cells"));
  EXPECT_THAT(o.out, HasSubstr("time with one thread / time with all"));
  EXPECT_THAT(o.out, HasSubstr("1 thread\n"));
}

TEST(Bench, DrawsAndEncodes) {
  const Folder f;
  const Outcome o = bench(f, {"C4,D3", "--json"});
  ASSERT_EQ(o.code, 0) << o.err;
  const auto rows = nlohmann::json::parse(o.out);
  EXPECT_THAT(values_of(rows, "part", "C4"), IsSupersetOf({"draw", "encode", "P2G", "run"}));
  EXPECT_THAT(values_of(rows, "case", "C4"), testing::Contains("PNG"));
  EXPECT_THAT(values_of(rows, "part", "D3"), IsSupersetOf({"snapshot", "draw", "encode PNG"}));
  EXPECT_TRUE(f.files().empty());
}

TEST(Bench, ComparesTwoRuns) {
  const Folder f;
  for (const char* csv : {"before.csv", "after.csv"})
    ASSERT_EQ(bench(f, {"W2", "--schemes", "apic", "--csv", csv}).code, 0);
  const Outcome o = run({"bench", "--compare", "before.csv", "after.csv"}, f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, HasSubstr("W2  APIC linear single  (2 threads)\n"));
  EXPECT_THAT(o.out, HasSubstr("-> "));
  EXPECT_THAT(o.out, Not(HasSubstr("alone")));
}

TEST(Bench, RefusesBeforeItMeasures) {
  const Folder f;
  expect_refusal(bench(f, {"W3-46"}), 2, {"W3-46", "did you mean \"W3-64\"?"});
  expect_refusal(bench(f, {"W2", "--kernels", "quadratc"}), 2, {"--kernels", "quadratic"});
  expect_refusal(bench(f, {"W2", "--precisions", "half"}), 2, {"--precisions", "half"});
  expect_refusal(bench(f, {"W2", "--schemes", "apci"}), 2, {"apci", "apic"});
  expect_refusal(bench(f, {"W2", "--repeats", "0"}), 2, {"--repeats"});
  expect_refusal(run({"bench", "--compare", "none.csv"}, f.path()), 2, {"two tables"});
  expect_refusal(run({"bench", "--compare", "none.csv", "none.csv"}, f.path()), 2, {"none.csv", "cannot read"});
  (void)f.write("other.csv", "a,b\n1,2\n");
  expect_refusal(run({"bench", "--compare", "other.csv", "other.csv"}, f.path()), 2, {"other.csv", "flipbook bench"});
}

// === Its parts

TEST(BenchReport, MedianAndTable) {
  EXPECT_EQ(app::median({3, 1, 2}), 2);
  EXPECT_EQ(app::median({4, 1, 2, 3}), 2.5);
  CaseResult r{"W", "case", "about", {}};
  for (const double x : {1.0, 2.0, 4.0}) r.add("P2G", "wall", "ms", x);
  r.add("G2P", "wall", "ms", 8);
  EXPECT_EQ(app::table_of(r), "W  case  (about)\n"
                              "  part  wall ms   +-%\n"
                              "  P2G         2  75.0\n"
                              "  G2P         8     0\n");
}

TEST(BenchReport, CsvReadsBackAndComparesByWhatWasMeasured) {
  const Folder f;
  const BenchRow row{"A, \"B\"", "1 v2", 2, "W2", "APIC", "P2G", "wall", "ms", 5, 1.5, 1, 2};
  BenchRow faster = row, other = row;
  faster.median = 0.75;
  other.threads = 1;
  const auto file = f.write("run.csv", app::to_csv({row}));
  const auto back = app::read_csv_rows(file);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].machine, row.machine);
  EXPECT_EQ(app::to_csv(back), app::to_csv({row}));
  const std::string text = app::comparison(back, {faster, other});
  EXPECT_THAT(text, HasSubstr("x 0.500\n"));
  EXPECT_THAT(text, HasSubstr("0 measurements of the first run alone, 1 of the second alone"));
  EXPECT_THROW((void)app::comparison(back, {other}), UserError);
  const auto damaged = f.write("bad.csv", app::to_csv({row}) + "A,1 v2,2,W2,APIC,P2G,wall,ms,5,x,1,2\n");
  try {
    (void)app::read_csv_rows(damaged);
    ADD_FAILURE() << "read a damaged table";
  } catch (const UserError& e) {
    EXPECT_THAT(e.what(), HasSubstr("bad.csv:3"));
  }
}

TEST(BenchReport, ScalingIsTheRatioOfTheTimes) {
  CaseResult one{"W", "c", "", {}}, two{"W", "c", "", {}};
  one.add("P2G", "wall", "ms", 3);
  two.add("P2G", "wall", "ms", 2);
  one.add("P2G", "cpu", "ms", 3);
  const CaseResult s = app::scaling(one, two);
  ASSERT_EQ(s.measurements.size(), 1U);
  EXPECT_EQ(s.measurements[0].values, std::vector<double>{1.5});
}

/// By hand: 10 particles of APIC in 3D single precision hold 4 (3 + 3 + 1 + 9) = 64 bytes and an id.
TEST(BenchTraffic, CountsEveryArrayOnce) {
  Settings s;
  s.dim = 3;
  const app::Work w{10, 100, 20, 5, 0.5};
  EXPECT_EQ(app::phase_bytes(Phase::sort, s, w), 2 * 10 * (64 + 4) + 4 * 100);
  EXPECT_EQ(app::phase_bytes(Phase::p2g, s, w), 10 * 64 + 2 * 100 * 12);
  EXPECT_EQ(app::phase_bytes(Phase::g2p, s, w), 10 * (12 + 12 + 36) + 100 * 12);
  EXPECT_EQ(app::phase_bytes(Phase::advect, s, w), 3 * (2 * 10 * 12 + 100 * 12));
  EXPECT_EQ(app::phase_bytes(Phase::pressure_solve, s, w), 5 * 20 * (104 + 2 * 16) + 2 * 100 * 12);
  EXPECT_EQ(app::phase_bytes(Phase::ledger, s, w), 0);
}

} // namespace

} // namespace flipbook::test
