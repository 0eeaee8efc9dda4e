// SPDX-License-Identifier: MIT
// Values of others for the plots: tables of numbers, [[reference]] in scenes and studies.
#include "app/study/resolve.h"
#include "sim/files/number_table.h"
#include "sim/scene/read_reference.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>

namespace flipbook {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

// === Tables

std::string table_message(const std::string& text) {
  const TemporaryFile file("table.csv", text);
  std::string message = message_of([&] { (void)read_number_table(file.path()); });
  if (message.starts_with(file.path())) message.replace(0, file.path().size(), "F");
  return message;
}

TEST(NumberTable, HasNamesAndColumns) {
  const TemporaryFile file("table.csv", "# measured\r\n\r\nT; \"Z of x\"\n0.5;1\n 1;2e-3\n");
  const NumberTable t = read_number_table(file.path());
  EXPECT_THAT(t.names, ElementsAre("T", "Z of x"));
  EXPECT_THAT(t.columns[0], ElementsAre(0.5, 1));
  EXPECT_THAT(t.columns[1], ElementsAre(1, 0.002));
}

TEST(NumberTable, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(table_message("# nothing\n"), "F:1: the file is empty");
  EXPECT_EQ(table_message("1,2\n3,4\n"), "F:1: the first line must name the columns, for example t,x, not \"1,2\"");
  EXPECT_EQ(table_message("t,x\n"), "F:1: there is no row of numbers");
  EXPECT_EQ(table_message("t,x\n1,2\n3\n"), "F:3: 1 column in a row, and 2 in the header");
  EXPECT_EQ(table_message("t,x\n1,2,3\n"), "F:2: 3 columns in a row, and 2 in the header");
  EXPECT_EQ(table_message("t,x\n1,two\n"), "F:2: column \"x\": expected a number, not \"two\"");
  EXPECT_EQ(table_message("t,x\n1,\n"), "F:2: column \"x\": expected a number, not \"\"");
  EXPECT_EQ(table_message("t,x\n1,\"2\n"), "F:2: a quote is not closed in this line");
  std::string wide = "a", tall = "t,x\n";
  for (int i = 0; i < 64; ++i) wide += ",a";
  for (int i = 0; i <= 10000; ++i) tall += "1,2\n";
  EXPECT_EQ(table_message(wide), "F:1: more than 64 columns");
  EXPECT_EQ(table_message(tall), "F:10002: more than 10000 rows");
  EXPECT_THAT(table_message("t,x\n1,nan\n"), HasSubstr("F:2: column \"x\": "));
  EXPECT_THAT(message_of([] { (void)read_number_table("/nowhere/table.csv"); }), HasSubstr("/nowhere/table.csv"));
}

// === References

/// The references of a study that lists these, and the text that is wrong with it.
std::vector<ReferenceCurve> references(const std::string& tables) {
  const auto r = app::resolve(app::parse_study("scene = \"still_pool\"\n" + tables, "s.toml"));
  return r.references ? *r.references : std::vector<ReferenceCurve>{};
}
std::string mistake(const std::string& tables) {
  return message_of([&] { (void)references(tables); });
}

const std::string front = "[[reference]]\nplot = \"front\"\nfile = \"martin_moyce_1952_front.csv\"\n";

TEST(Reference, IsScaledToTheUnitsOfTheRun) {
  // t = t0 + x_scale T, y = y_scale Z: with a = 0.4 m the first row, T = 0.41 and Z = 1.11, is at 0.41 sqrt(0.4
  // / 19.62).
  const auto all =
      references(front + "label = \"Martin & Moyce\"\nstyle = \"line\"\nx_scale = \"sqrt(0.4 / (2 * 9.81))\"\n"
                         "y_scale = 0.4\nt0 = 0.5\n");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].plot, "front");
  EXPECT_EQ(all[0].label, "Martin & Moyce");
  EXPECT_EQ(all[0].style, ReferenceCurve::Style::line);
  ASSERT_EQ(all[0].t.size(), 15U);
  EXPECT_THAT(all[0].t[0], DoubleEq(0.5 + 0.41 * std::sqrt(0.4 / 19.62)));
  EXPECT_THAT(all[0].y[0], DoubleEq(0.4 * 1.11));
}

TEST(Reference, TakesItsColumnsByNameAndSortsTheirTimes) {
  const TemporaryFile file("table.csv", "a,b,c\n3,1,10\n2,2,20\n1,3,30\n");
  const std::string table = "[[reference]]\nplot = \"kinetic\"\nfile = \"" + file.path() + "\"\n";
  auto all = references(table + "x = \"a\"\ny = \"c\"\n");
  EXPECT_THAT(all.at(0).t, ElementsAre(1, 2, 3));
  EXPECT_THAT(all.at(0).y, ElementsAre(30, 20, 10));
  EXPECT_EQ(all.at(0).label, std::filesystem::path(file.path()).stem().string()) << "until it is given one";
  EXPECT_EQ(all.at(0).style, ReferenceCurve::Style::points);
  all = references(table + "x_scale = -1\n");
  EXPECT_THAT(all.at(0).t, ElementsAre(-3, -2, -1));
  EXPECT_THAT(all.at(0).y, ElementsAre(1, 2, 3));
}

TEST(Reference, OfASceneComesWithIt) {
  const auto r = app::resolve(app::study_of_scene("dam_break"));
  ASSERT_TRUE(r.references);
  ASSERT_EQ(r.references->size(), 2U);
  // tau = 2 and H = 0.5: half of 0.8 m after 2 sqrt(0.4 / 9.81) s
  EXPECT_NEAR((*r.references)[1].t[8], 2 * std::sqrt(0.4 / 9.81), 1e-12);
  EXPECT_NEAR((*r.references)[1].y[8], 0.4, 1e-12);
}

TEST(Reference, IsWrittenWithItsStudy) {
  const app::Study first = app::parse_study("scene = \"dam_break\"\n" + front, "s.toml");
  const std::string text = to_toml(first);
  EXPECT_THAT(text, HasSubstr("\n[[reference]]\nplot = \"front\"\nfile = \"martin_moyce_1952_front.csv\"\n"));
  EXPECT_THAT(text, HasSubstr("\n[[scene.reference]]\n"));
  const app::Study second = app::parse_study(text, "again.toml");
  EXPECT_EQ(to_toml(second), text);
  EXPECT_EQ(app::resolve(second).references->size(), 3U);
  // What is found by its name anywhere keeps it.
  EXPECT_THAT(to_toml(app::for_folder(first, "/tmp")), HasSubstr("file = \"martin_moyce_1952_front.csv\""));
}

TEST(Reference, SaysWhatIsWrongAndWhere) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"reference = \"Martin\"\n", "s.toml:2:1: references are written as [[reference]]"},
      {"reference = [1]\n", "s.toml:2:1: references are written as [[reference]]"},
      {"[[reference]]\nfile = \"martin_moyce_1952_front.csv\"\n", "s.toml:2:1: a reference needs \"plot\""},
      {"[[reference]]\nplot = \"front\"\n", "s.toml:2:1: a reference needs \"file\""},
      {front + "plto = 1\n", "s.toml:5:1: unknown key \"plto\" in a reference; did you mean \"plot\"?"},
      {"[[reference]]\nplot = \"fornt\"\nfile = \"martin_moyce_1952_front.csv\"\n",
       "s.toml:3:1: no curve is called \"fornt\"; did you mean \"front\"?"},
      {front + "style = \"dots\"\n", "s.toml:5:1: there is no style \"dots\": it is \"points\" or \"line\""},
      {front + "x = \"t\"\n", "s.toml:5:1: the table has no column \"t\"; did you mean \"T\"?"},
      {front + "x_scale = true\n", "s.toml:5:1: \"x_scale\" must be a number or a formula in quotes, not true"},
      {front + "x_scale = \"sqrt(-1)\"\n", "s.toml:5:1: the formula \"sqrt(-1)\" is not a finite number"},
      {front + "y_scale = \"2 * a\"\n", "s.toml:5:1: the formula \"2 * a\" uses the unknown name \"a\""},
      {front + "y_scale = 1e300\n", "s.toml:5:1: \"y_scale\" must be within ±1e12, not 1e+300"},
      {front + "t0 = 1e9\n", "s.toml:5:1: \"t0\" must be a number from -1000000 to 1000000, not 1000000000"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(mistake(text), message) << text;
  EXPECT_THAT(mistake("[[reference]]\nplot = \"front\"\nfile = \"nothing.csv\"\n"),
              HasSubstr("s.toml:4:1: there is no file \"nothing.csv\""));
  std::string many;
  for (int i = 0; i < 17; ++i) many += front;
  EXPECT_EQ(mistake(many), "s.toml:2:3: there may be 16 references, not 17");
  EXPECT_EQ(mistake("[view]\nlog = [\"kinetik\"]\n"),
            "s.toml:3:1: view.log: no curve is called \"kinetik\"; did you mean \"kinetic\"?");
}

} // namespace
} // namespace flipbook
