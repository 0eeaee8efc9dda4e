// SPDX-License-Identifier: MIT
// flipbook verify: its table, its JSON and its exit codes.
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <regex>
#include <set>

namespace flipbook::test {

namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string table_of(const std::vector<std::string>& more, int code = 0) {
  const Folder f;
  std::vector<std::string> words{"verify"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome o = run(words, f.path());
  EXPECT_EQ(o.code, code) << o.out << o.err;
  return o.out;
}

TEST(Verify, PrintsALineForEachPropositionUnderWhatItIs) {
  const std::string out = table_of({});
  for (const char* part :
       {"nodes: proved", "MAC: extended", "OURS", "MUST FAIL", "200 eps", "sum m |x| |v|", " 0 failed"})
    EXPECT_THAT(out, HasSubstr(part));
  EXPECT_THAT(out, Not(HasSubstr("FAILED")));
  std::size_t ok = 0, longest = 0, begin = 0;
  for (std::size_t end; (end = out.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string line = out.substr(begin, end - begin);
    ok += line.ends_with("   ok") ? 1 : 0;
    longest = std::max(longest, line.size());
  }
  EXPECT_EQ(ok, 10u + 12 + 12);
  EXPECT_LE(longest, 120u);
  for (const char* id : {"4.1", "4.2", "4.3", "4.4", "4.5", "5.1", "5.2", "5.3", "5.4", "5.5"})
    EXPECT_THAT(out, HasSubstr("\n" + std::string(id) + "  ")) << id;
}

TEST(Verify, ShowsEveryCaseWhereAsked) {
  const std::string out = table_of({"--only", "5.5,cubic,apic", "--all"});
  EXPECT_TRUE(std::regex_search(out, std::regex(R"(APIC +cubic +3D  mac +single +\d\.\d+e-\d\d  at most +\S+  ok)")))
      << out;
  EXPECT_TRUE(std::regex_search(out, std::regex(R"(APIC +cubic +2D  nodes +double +\d\.\d+e-\d\d  at least +\S+  ok)")))
      << out;
}

TEST(Verify, KeepsTheCasesThatAnswerToTheWords) {
  EXPECT_THAT(table_of({"--only", "angular", "--only", "rpic"}), AllOf(HasSubstr("4.5"), Not(HasSubstr("5.5"))));
  EXPECT_THAT(table_of({"--only", "clamped"}), AllOf(HasSubstr("MUST FAIL"), Not(HasSubstr("OURS"))));
  const Folder f;
  const Outcome wrong = run({"verify", "--only", "angluar"}, f.path());
  EXPECT_EQ(wrong.code, 2);
  EXPECT_EQ(wrong.out, "");
  EXPECT_THAT(wrong.err, HasSubstr("\"angular\""));
  EXPECT_EQ(run({"verify", "--only", "4.1 apic"}, f.path()).code, 2);
}

TEST(Verify, JsonHoldsEveryCaseUnderStableNames) {
  const json all = json::parse(table_of({"--only", "2d", "--json", "--seed", "7"}));
  EXPECT_EQ(all.at("seed"), 7);
  EXPECT_EQ(all.at("failed"), 0);
  std::set<std::string> standings;
  for (const json& c : all.at("cases")) {
    std::set<std::string> names;
    for (const auto& [name, value] : c.items()) names.insert(name);
    EXPECT_EQ(names, (std::set<std::string>{"id", "standing", "statement", "quantity", "scheme", "kernel", "layout",
                                            "precision", "dim", "cycles", "error", "relation", "bound", "passed",
                                            "relative_to", "reason"}));
    standings.insert(c.at("standing"));
    EXPECT_EQ(c.at("dim"), 2);
    const double error = c.at("error"), bound = c.at("bound");
    EXPECT_EQ(c.at("passed"), c.at("relation") == "<=" ? error <= bound : error >= bound);
    EXPECT_EQ(c.at("relation") == ">=", c.at("standing") == "must fail");
  }
  EXPECT_EQ(standings, (std::set<std::string>{"proved", "extension", "ours", "must fail"}));
}

TEST(Verify, AFailureIsExitCode1AndNamed) {
  const std::string out = table_of({"--only", "5.5,cubic", "--strict", "1e9"}, 1);
  EXPECT_THAT(out, AllOf(HasSubstr("FAILED (8 of 8)"), Not(HasSubstr(" 0 failed"))));
  EXPECT_TRUE(std::regex_search(out, std::regex(R"(5\.5  PIC .*FAILED)"))) << "a floor out of reach";
  const json cases = json::parse(table_of({"--only", "4.2", "--strict", "1e9", "--json"}, 1));
  EXPECT_EQ(cases.at("failed"), cases.at("cases").size());
  EXPECT_EQ(table_of({"--only", "4.2", "--strict", "3"}).find("FAILED"), std::string::npos);
}

TEST(Verify, TheOutputDependsOnTheSeedAndNotOnTheThreads) {
  const std::vector<std::string> some{"--only", "2d,quadratic", "--json", "--threads"};
  const auto with = [&](const std::string& threads, const std::string& seed) {
    std::vector<std::string> words = some;
    words.insert(words.end(), {threads, "--seed", seed});
    return table_of(words);
  };
  EXPECT_EQ(with("1", "3"), with("4", "3"));
  EXPECT_NE(with("1", "3"), with("1", "4"));
}

TEST(Verify, RefusesNumbersThatAreNone) {
  const Folder f;
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--seed", "1.5"}, {"--seed", "-1"}, {"--seed", "x"}, {"--strict", "0"}, {"--strict", "nan"}}) {
    const Outcome o = run({"verify", words[0], words[1]}, f.path());
    EXPECT_EQ(o.code, 2) << words[1];
    EXPECT_THAT(o.err, HasSubstr(words[0] + " " + words[1]));
  }
}

} // namespace

} // namespace flipbook::test
