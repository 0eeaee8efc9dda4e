// SPDX-License-Identifier: MIT
// The manual page says what --help says, in roff that typesetters take without a warning.
#include "tests/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace flipbook::test {

namespace {

using ::testing::HasSubstr;
using Words = std::vector<std::string>;

/// The names of commands, as the program lists them.
Words command_names(const Folder& f) {
  Words names;
  std::istringstream lines(run({"list", "commands"}, f.path()).out);
  for (std::string line; std::getline(lines, line);) names.push_back(line.substr(0, line.find(' ')));
  return names;
}

/// Without what roff adds: "\fB\-\-cells\fR" is "--cells".
std::string plain(const std::string& roff) {
  std::string text;
  for (std::size_t i = 0; i < roff.size(); ++i) {
    if (roff[i] != '\\') {
      text += roff[i] == '\n' ? ' ' : roff[i];
    } else if (++i < roff.size()) {
      if (roff[i] == 'f')
        ++i;
      else if (roff[i] != '&')
        text += roff[i];
    }
  }
  return text;
}

/// What `--help` calls the options: "-o,--output" and what follows it up to two blanks.
Words options_in_help(const std::string& help) {
  Words names;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  -")) names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

TEST(Man, HasEveryCommandAndOptionOfTheHelp) {
  const Folder f;
  const std::string whole = plain(run({"man"}, f.path()).out);
  const Words names = command_names(f);
  EXPECT_GE(names.size(), 10U);
  for (const std::string& name : names) {
    EXPECT_THAT(whole, HasSubstr(".SS \"" + name + "\""));
    const std::string page = plain(run({"man", name}, f.path()).out);
    const Words options = options_in_help(run({name, "--help"}, f.path()).out);
    EXPECT_FALSE(options.empty()) << name;
    for (std::string option : options) {
      if (const std::size_t comma = option.find(','); comma != std::string::npos) option.insert(comma + 1, " ");
      EXPECT_THAT(page, HasSubstr(option)) << name;
      EXPECT_THAT(whole, HasSubstr(option)) << name;
    }
  }
  for (const char* title :
       {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS", "EXIT STATUS", "ENVIRONMENT", "FILES", "EXAMPLES"})
    EXPECT_THAT(whole, HasSubstr(std::string(".SH ") + title));
}

TEST(Man, IsNoRoffByAccident) {
  const Folder f;
  std::istringstream lines(run({"man"}, f.path()).out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_FALSE(line.starts_with("'")) << line;
    if (line.starts_with(".")) {
      const std::string macro = line.substr(0, line.find(' '));
      EXPECT_THAT((Words{".\\\"", ".TH", ".SH", ".SS", ".PP", ".TP", ".br", ".nh", ".ad", ".EX", ".EE", ".BR"}),
                  ::testing::Contains(macro));
    }
  }
}

TEST(Man, IsTypesetWithoutAWarning) {
  const Folder f;
  Words pages = command_names(f);
  pages.emplace_back();
  if (run_other({"groff", "--version"}, f.path()).code != 0) GTEST_SKIP() << "no groff here";
  for (const std::string& page : pages) {
    Words words{"man"};
    if (!page.empty()) words.push_back(page);
    (void)f.write("page", run(words, f.path()).out);
    const Outcome o = run_other({"groff", "-man", "-ww", "-Tutf8", "page"}, f.path());
    EXPECT_EQ(o.code, 0);
    EXPECT_EQ(o.err, "") << page;
  }
}

} // namespace

} // namespace flipbook::test
