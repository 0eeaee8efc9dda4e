// SPDX-License-Identifier: MIT
// What a figure's TOML may say, and what is said about what it may not.
#include "app/figures/spec.h"
#include "sim/frame/errors.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal_of(const std::string& toml) {
  const TemporaryFile file("figure.toml", toml);
  return message_of([&] { (void)kind_of(read_figure(file.path(), false)); });
}

TEST(FigureSpec, EveryFigureIsWhole) {
  const std::vector<std::string> names = list_figures();
  ASSERT_GE(names.size(), 6u);
  int last = 0;
  for (const std::string& name : names)
    for (const bool fast : {false, true}) {
      const FigureSpec spec = read_figure(name, fast);
      EXPECT_EQ(spec.name, name);
      EXPECT_GE(spec.number, last) << name;
      EXPECT_FALSE(spec.claim.empty() || spec.caption.empty()) << name;
      EXPECT_TRUE(spec.claim.ends_with(".")) << name << ": a claim is a sentence";
      EXPECT_NO_THROW((void)kind_of(spec)) << name;
      last = spec.number;
    }
}

TEST(FigureSpec, FastReplacesWhatRunSays) {
  const TemporaryFile file("figure.toml", "kind = \"viscosity\"\nclaim = \"A.\"\ncaption = \"B.\"\n"
                                          "[run]\ncells = 64\n[fast]\ncells = 16\n");
  EXPECT_EQ(read_figure(file.path(), false).run.size(), 1u);
  const FigureSpec fast = read_figure(file.path(), true);
  ASSERT_EQ(fast.run.size(), 2u);
  EXPECT_EQ(fast.run.back().value, Value(16.0)) << "the last one wins";
}

TEST(FigureSpec, MistakesAreNamedWhereTheyAre) {
  EXPECT_THAT(refusal_of("kind = \"lens\"\nclaim = \"A.\"\n"), HasSubstr("caption"));
  EXPECT_THAT(refusal_of("kind = \"lense\"\nclaim = \"A.\"\ncaption = \"B.\"\n"),
              AllOf(HasSubstr("lense"), HasSubstr("did you mean \"lens\"?")));
  EXPECT_THAT(refusal_of("kind = \"viscosity\"\nclaim = \"A.\"\ncaption = \"B.\"\n[run]\ncell = 64\n"),
              AllOf(HasSubstr(":5:"), HasSubstr("cell"), HasSubstr("\"cells\"")));
  EXPECT_THAT(refusal_of("kind = \"lens\"\nclaim = \"A.\"\ncaption = \"B.\"\ncolour = 3\n"), HasSubstr("colour"));
  EXPECT_THAT(message_of([] { (void)read_figure("propositoins", false); }), HasSubstr("\"propositions\""));
}

TEST(FigureSpec, WidthsAreLengths) {
  EXPECT_DOUBLE_EQ(parse_width("84mm"), 84);
  EXPECT_DOUBLE_EQ(parse_width("17.4 cm"), 174);
  EXPECT_DOUBLE_EQ(parse_width("4in"), 101.6);
  EXPECT_DOUBLE_EQ(parse_width("column"), 84);
  EXPECT_DOUBLE_EQ(parse_width("text"), 174);
  for (const char* wrong : {"84", "84px", "mm", "-84mm", "1mm", "5000mm", "nan mm", ""})
    EXPECT_THROW((void)parse_width(wrong), UserError) << wrong;
}

} // namespace
} // namespace flipbook::app
