// SPDX-License-Identifier: MIT
// The ledger as a file: a table that a spreadsheet opens, and whose sums close.
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace flipbook::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

/// The fields of a CSV text, row by row, as RFC 4180 has them.
std::vector<Words> parse_csv(const std::string& text) {
  std::vector<Words> rows(1, Words(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
      rows.back().back() += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && c == ',')
      rows.back().emplace_back();
    else if (!quoted && c == '\n')
      rows.emplace_back(1);
    else
      rows.back().back() += c;
  }
  rows.pop_back(); // behind the last line's end
  return rows;
}

constexpr std::size_t first_quantity = 5;

/// What was held before and all changes make what is held; returns the number of groups looked at.
std::size_t expect_sums_close(const std::vector<Words>& rows) {
  struct Group {
    std::vector<double> held, sum, scale;
  };
  std::map<std::string, Group> last; // of each variant
  std::size_t groups = 0;
  const auto close = [&](const Group& g, const std::string& variant) {
    for (std::size_t q = 0; q < g.held.size(); ++q)
      EXPECT_LE(std::abs(g.sum[q]), 1e-12 * g.scale[q]) << variant << ", " << rows[0][first_quantity + q];
    ++groups;
  };
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Words& row = rows[i];
    Group& g = last[row[0]];
    std::vector<double> numbers;
    for (std::size_t q = first_quantity; q < row.size(); ++q) numbers.push_back(row[q].empty() ? 0 : std::stod(row[q]));
    if (row[4] == "particles") {
      if (!g.held.empty()) close(g, row[0]);
      // sum = held before + changes - held now: begins below zero and must end there.
      std::vector<double> sum(numbers.size()), scale(numbers.size());
      for (std::size_t q = 0; q < numbers.size(); ++q) {
        sum[q] = (g.held.empty() ? numbers[q] : g.held[q]) - numbers[q];
        scale[q] = std::abs(numbers[q]) + std::abs(sum[q]) + 1e-300;
      }
      g = {numbers, sum, scale};
      continue;
    }
    for (std::size_t q = 0; q < numbers.size(); ++q) {
      g.sum[q] += numbers[q];
      g.scale[q] += std::abs(numbers[q]);
    }
  }
  for (const auto& [variant, g] : last) close(g, variant);
  return groups;
}

const Words tiny{"--cells", "16", "--frames", "4", "--size", "320x180", "-q"};

Words with(Words words, const Words& more = {}) {
  words.insert(words.end(), tiny.begin(), tiny.end());
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::size_t rows_of(const std::vector<Words>& rows, const std::string& stage) {
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](auto& r) { return r[4] == stage; }));
}

TEST(LedgerFile, IsATableWhoseSumsClose) {
  const Folder f;
  const Outcome o = run(with({"compare", "dam_break", "--schemes", "pic,flip:0.97", "--ledger", "l.csv"}), f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "l.csv\n");
  EXPECT_THAT(f.files(), ElementsAre("l.csv")) << "without -o nothing is drawn";
  const std::vector<Words> rows = parse_csv(read_file(f.path() / "l.csv"));
  EXPECT_THAT(rows[0], ElementsAre("variant", "frame", "substep", "t (s)", "stage", "mass (kg/m)",
                                   "momentum_x (kg m/s/m)", "momentum_y (kg m/s/m)", "angular_momentum_z (kg m^2/s/m)",
                                   "kinetic (J/m)", "potential (J/m)"));
  for (const Words& row : rows) ASSERT_EQ(row.size(), rows[0].size());
  EXPECT_EQ(rows[1][0], "PIC");
  EXPECT_EQ(rows[2][0], "FLIP 0.97");
  EXPECT_EQ(rows_of(rows, "particles"), 2U * 4U) << "the start and three frames, of two variants";
  EXPECT_EQ(rows_of(rows, "p2g"), 2U * 3U);
  EXPECT_EQ(rows_of(rows, "g2p"), 2U * 3U);
  EXPECT_EQ(expect_sums_close(rows), 2U * 4U);
  EXPECT_THAT(rows.back()[1], "3");
}

TEST(LedgerFile, HasAGroupForEachStepIfAsked) {
  const Folder f;
  const Outcome o = run(with({"render", "drop", "--ledger", "l.csv", "--set", "ledger.rows=step"}), f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  const std::vector<Words> rows = parse_csv(read_file(f.path() / "l.csv"));
  EXPECT_EQ(expect_sums_close(rows), rows_of(rows, "particles"));
  // Within a frame substeps count from 1; times grow.
  std::map<std::string, int> last;
  double t = -1;
  for (const Words& row : rows) {
    if (row[4] != "particles") continue;
    if (row[1] != "0") {
      EXPECT_EQ(std::stoi(row[2]), ++last[row[1]]);
    }
    EXPECT_GT(std::stod(row[3]), t);
    t = std::stod(row[3]);
  }
  ASSERT_EQ(last.size(), 3U);
  EXPECT_GT(last["3"], 1) << "more than one step in a frame";
}

TEST(LedgerFile, QuotesTitlesAndLeavesOutWhatIsNotDefined) {
  const Folder f;
  (void)f.write("s.toml",
                "scene = \"taylor_green\"\n[[variant]]\nlabel = \"a, \\\"b\\\"\"\ntransfer.scheme = \"apic\"\n");
  const Outcome o = run(with({"render", "s.toml", "--ledger", "l.csv"}), f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  const std::string text = read_file(f.path() / "l.csv");
  EXPECT_THAT(text, HasSubstr("\"a, \"\"b\"\"\",1,"));
  const std::vector<Words> rows = parse_csv(text);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][0], "a, \"b\"");
    EXPECT_EQ(rows[i][8], "") << "with a periodic axis there is no angular momentum";
    EXPECT_NE(rows[i][9], "");
  }
  expect_sums_close(rows);
}

TEST(LedgerFile, CountsRoundTripsWhereThereIsNoTime) {
  const Folder f;
  for (const auto& [dt, unit] : {std::pair("1", "t (trips)"), std::pair("0.5", "t (s)")}) {
    const Outcome o =
        run(with({"render", "transfer_shear", "--ledger", "l.csv"}, {"--set", "time.dt=" + std::string(dt)}), f.path());
    ASSERT_EQ(o.code, 0) << o.err;
    EXPECT_EQ(parse_csv(read_file(f.path() / "l.csv"))[0][3], unit);
    std::filesystem::remove(f.path() / "l.csv");
  }
}

/// Nothing falls, no wall stands and no air is near: what remains has something to say.
TEST(LedgerFile, LeavesOutStagesThatCanChangeNothing) {
  const Folder f;
  const Outcome o = run(with({"render", "taylor_green", "--ledger", "l.csv"}), f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  const std::vector<Words> rows = parse_csv(read_file(f.path() / "l.csv"));
  for (const char* stage : {"forces", "walls", "free_faces", "extrapolation"})
    EXPECT_EQ(rows_of(rows, stage), 0U) << stage;
  for (const char* stage : {"p2g", "projection", "g2p", "advection"}) EXPECT_EQ(rows_of(rows, stage), 3U) << stage;
  expect_sums_close(rows);
}

TEST(LedgerFile, NamesBothUnitsWhereTwoDimensionsMeet) {
  const Folder f;
  const Outcome o = run({"compare", "drop", "--schemes", "apic", "--vary", "dim=2,3", "--cells", "8", "--frames", "2",
                         "--ledger", "l.csv", "-q"},
                        f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  const std::vector<Words> rows = parse_csv(read_file(f.path() / "l.csv"));
  EXPECT_THAT(rows[0], testing::Contains("kinetic (J/m or J)"));
  EXPECT_THAT(rows[0], testing::Contains("momentum_z (kg m/s)"));
  EXPECT_EQ(rows[1][std::size_t(std::find(rows[0].begin(), rows[0].end(), "momentum_z (kg m/s)") - rows[0].begin())],
            "")
      << "the plane has none";
  EXPECT_EQ(expect_sums_close(rows), 4U);
}

TEST(LedgerFile, TheSameBytesForAnyNumberOfThreads) {
  const Folder f;
  for (const std::string threads : {"1", "3"}) {
    const Outcome o = run(
        with({"compare", "dam_break", "--schemes", "flip,apic", "--ledger", threads + ".csv"}, {"--threads", threads}),
        f.path());
    ASSERT_EQ(o.code, 0) << o.err;
  }
  EXPECT_EQ(read_file(f.path() / "1.csv"), read_file(f.path() / "3.csv"));
}

TEST(LedgerFile, IsAskedForByAStudyToo) {
  const Folder f;
  (void)f.write("s.toml", "scene = \"drop\"\n[output]\nledger = \"numbers/l.csv\"\n");
  Outcome o = run(with({"render", "s.toml", "-o", "p/"}), f.path());
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "p/\nnumbers/l.csv\n");
  EXPECT_THAT(read_file(f.path() / "numbers/l.csv"), HasSubstr(",particles,"));
  EXPECT_TRUE(std::filesystem::exists(f.path() / "p/frame_000003.png")) << "pictures are drawn as well";
  o = run(with({"render", "s.toml", "--ledger", "other.csv"}), f.path());
  EXPECT_EQ(o.out, "other.csv\n") << "the option says where";
}

/// A study may come from anyone: it names no place outside the folder where the program runs.
TEST(LedgerFile, OfAStudyStaysBelowTheFolder) {
  const Folder f;
  for (const std::string name : {"/tmp/l.csv", "../l.csv", "a/../../l.csv", "l.txt", ".bashrc"}) {
    (void)f.write("s.toml", "scene = \"drop\"\n[output]\nledger = \"" + name + "\"\n");
    expect_refusal(run(with({"render", "s.toml", "-o", "p/"}), f.path()), 2, {"s.toml:3:", name, ".csv"});
  }
  EXPECT_THAT(f.files(), ElementsAre("s.toml"));
}

TEST(LedgerFile, ReplacesATableButNothingElse) {
  const Folder f;
  const Words words = with({"render", "drop", "--ledger", "l.csv"});
  ASSERT_EQ(run(words, f.path()).code, 0);
  const std::string before = read_file(f.path() / "l.csv");
  EXPECT_EQ(run(words, f.path()).code, 0);
  EXPECT_EQ(read_file(f.path() / "l.csv"), before);
  (void)f.write("l.csv", "name,salary\nme,1\n");
  expect_refusal(run(words, f.path()), 2, {"l.csv", "in the way"});
  EXPECT_EQ(read_file(f.path() / "l.csv"), "name,salary\nme,1\n");
  (void)f.write("l.csv", "");
  EXPECT_EQ(run(words, f.path()).code, 0) << "an empty file is nothing to lose";
  std::filesystem::create_directory(f.path() / "folder.csv");
  expect_refusal(run(with({"render", "drop", "--ledger", "folder.csv"}), f.path()), 2, {"folder.csv", "in the way"});
}

TEST(LedgerFile, SaysWhatKeepsNone) {
  const Folder f;
  const auto refused = [&](const Words& words, const Words& says) {
    expect_refusal(run(with(words, {"--ledger", "l.csv"}), f.path()), 2, says);
  };
  refused({"render", "drop", "--set", "ledger.on=false"}, {"--ledger", "ledger.on = false"});
  refused({"compare", "drop", "--schemes", "pic,apic", "--set", "ledger.on=false"}, {"variant 1", "ledger.on = false"});
  expect_refusal(run({"render",   "drop",
                      "--dim",    "3",
                      "--set",    "preset=tutorial",
                      "--set",    "transfer.scheme=flip",
                      "--set",    "precision=double",
                      "--set",    "time.dt=0.005",
                      "--set",    "fluid.gravity=0,0,-9.80665",
                      "--cells",  "8",
                      "--frames", "1",
                      "--ledger", "l.csv",
                      "-q"},
                     f.path()),
                 2, {"--ledger", "tutorial"});
  expect_refusal(run(with({"render", "drop", "--ledger", "l.txt"}), f.path()), 2, {"l.txt", ".csv"});
  ASSERT_EQ(run(with({"render", "drop", "--particles", "series"}), f.path()).code, 0);
  expect_refusal(run({"render", "series", "--ledger", "l.csv"}, f.path()), 2, {"--ledger", "no ledger"});
  EXPECT_FALSE(std::filesystem::exists(f.path() / "l.csv"));
}

TEST(LedgerFile, LeavesNothingOnAFullDisk) {
  const Folder f;
  const Words words = with({"render", "drop", "--ledger", "new/l.csv", "--set", "ledger.rows=step"});
  expect_refusal(run(words, f.path(), {.file_size_limit = 4096}), 3, {"cannot write", "l.csv"});
  EXPECT_TRUE(f.files().empty());
}

TEST(LedgerFile, IsInHelpAndCompletion) {
  const Folder f;
  for (const std::string command : {"render", "compare"})
    EXPECT_THAT(run({command, "--help"}, f.path()).out, HasSubstr("--ledger FILE.csv")) << command;
  EXPECT_THAT(run({"still", "--help"}, f.path()).out, Not(HasSubstr("--ledger"))) << "a still has no frames";
  EXPECT_THAT(run({"list", "parameters"}, f.path()).out, HasSubstr("output.ledger"));
}

} // namespace
} // namespace flipbook::test
