// SPDX-License-Identifier: MIT
#include "sim/frame/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace flipbook {
namespace {

enum class Colour { red, green };

/// One parameter of each kind.
struct Thing {
  bool on = false;
  double ratio = 0.5;
  int count = 3;
  Colour colour = Colour::red;
  std::string label = "a";
  std::array<double, 2> range{0, 1};
  std::array<int, 3> cells{8, 9, 10};
  std::vector<std::string> plots{"energy"};

  void describe(ParameterVisitor& v) {
    static constexpr Option colours[] = {{"red", "warm"}, {"green", "cool"}};
    static constexpr Option curves[] = {{"energy", "J"}, {"momentum", "kg m/s"}};
    v.flag({.name = "on", .help = "h"}, on);
    v.group("part", [&] {
      v.real({.name = "ratio", .help = "h", .unit = "m", .min = 0, .max = 1}, ratio);
      v.integer({.name = "count", .help = "h", .min = 1}, count);
      v.group("deep", [&] { v.choice({.name = "colour", .help = "h"}, colour, colours); });
    });
    v.text({.name = "label", .help = "h"}, label);
    v.reals({.name = "range", .help = "h"}, range);
    v.integers({.name = "cells", .help = "h", .min = 1, .max = 100}, cells);
    v.names({.name = "plots", .help = "h"}, plots, curves);
  }
};

Value value_of(Thing& t, const std::string& path) {
  for (const Parameter& p : parameters_of(t))
    if (p.path == path) return p.value;
  ADD_FAILURE() << path;
  return false;
}

TEST(Parameters, AreListedWithPathKindAndValueInTheOrderOfDescription) {
  Thing t;
  const auto all = parameters_of(t);
  const std::vector<std::pair<std::string, Kind>> expected{{"on", Kind::flag},
                                                           {"part.ratio", Kind::real},
                                                           {"part.count", Kind::integer},
                                                           {"part.deep.colour", Kind::choice},
                                                           {"label", Kind::text},
                                                           {"range", Kind::reals},
                                                           {"cells", Kind::integers},
                                                           {"plots", Kind::names}};
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].path, expected[i].first);
    EXPECT_EQ(all[i].kind, expected[i].second);
  }
  EXPECT_EQ(all[1].unit, "m");
  EXPECT_EQ(all[1].max, 1);
  EXPECT_EQ(all[3].options, (std::vector<std::string>{"red", "green"}));
  EXPECT_EQ(all[3].option_help, (std::vector<std::string>{"warm", "cool"}));
}

TEST(Parameters, TakeAValueOfTheirKind) {
  Thing t;
  const std::vector<std::pair<std::string, Value>> cases{
      {"on", true},
      {"part.ratio", 0.25},
      {"part.count", 7.0},
      {"part.deep.colour", std::string("green")},
      {"label", std::string("b \"c\"")},
      {"range", std::vector<double>{-2, 2.5}},
      {"cells", std::vector<double>{1, 2, 3}},
      {"plots", std::vector<std::string>{"momentum", "energy"}},
  };
  for (const auto& [path, value] : cases) {
    EXPECT_EQ(set_parameter(t, path, value).message, "") << path;
    EXPECT_EQ(value_of(t, path), value) << path;
  }
  EXPECT_EQ(t.colour, Colour::green);
}

TEST(Parameters, ForgiveCaseOfNamesAndASingleNameForAList) {
  Thing t;
  EXPECT_EQ(set_parameter(t, "part.deep.colour", std::string("GREEN")).message, "");
  EXPECT_EQ(t.colour, Colour::green);
  EXPECT_EQ(set_parameter(t, "plots", std::string("Momentum")).message, "");
  EXPECT_EQ(t.plots, std::vector<std::string>{"momentum"});
  EXPECT_EQ(set_parameter(t, "plots", std::vector<double>{}).message, "") << "an empty list has no type";
  EXPECT_TRUE(t.plots.empty());
}

TEST(Parameters, AListForThreeAxesMayLeaveOutTheThird) {
  Thing t;
  EXPECT_EQ(set_parameter(t, "cells", std::vector<double>{4, 5}).message, "");
  EXPECT_EQ(t.cells, (std::array<int, 3>{4, 5, 10}));
  EXPECT_NE(set_parameter(t, "cells", std::vector<double>{4}).message, "");
  EXPECT_NE(set_parameter(t, "range", std::vector<double>{4}).message, "");
}

struct Refused {
  std::string path;
  Value value;
  std::string message, nearest;
};

TEST(Parameters, RefuseWithOneSentenceAndChangeNothing) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const std::vector<Refused> cases{
      {"on", 1.0, "on must be true or false, not 1", ""},
      {"part.ratio", 1.5, "part.ratio must be a number from 0 to 1 (m), not 1.5", ""},
      {"part.ratio", nan, "part.ratio must be a number from 0 to 1 (m), not nan", ""},
      {"part.ratio", std::string("1 cm"), "part.ratio must be a number from 0 to 1 (m), not \"1 cm\"", ""},
      {"part.count", 2.5, "part.count must be a whole number of at least 1, not 2.5", ""},
      {"part.count", 1e10, "part.count must be a whole number of at least 1, not 10000000000", ""},
      {"part.count", 0.0, "part.count must be a whole number of at least 1, not 0", ""},
      {"part.deep.colour", std::string("gren"), "part.deep.colour must be one of \"red\", \"green\", not \"gren\"",
       "green"},
      {"part.deep.colour", 1.0, "part.deep.colour must be one of \"red\", \"green\", not 1", ""},
      {"label", 2.0, "label must be a text in quotes, not 2", ""},
      {"range", std::vector<double>{0, inf}, "range must be 2 numbers, not [0, inf]", ""},
      {"range", 3.0, "range must be 2 numbers, not 3", ""},
      {"cells", std::vector<double>{4, 0, 4}, "cells must be 2 or 3 whole numbers from 1 to 100, not [4, 0, 4]", ""},
      {"cells", std::vector<double>{4, 4.5}, "cells must be 2 or 3 whole numbers from 1 to 100, not [4, 4.5]", ""},
      {"plots", std::vector<std::string>{"energy", "momentun"},
       "\"momentun\" is not a name that plots knows: \"energy\", \"momentum\"", "momentum"},
      {"plots", true, "plots must be a list of names, not true", ""},
      {"part.rato", 0.5, "unknown parameter \"part.rato\"", "part.ratio"},
      {"ratio", 0.5, "unknown parameter \"ratio\"", "part.ratio"},
      {"wholly_different", 0.5, "unknown parameter \"wholly_different\"", ""},
  };
  for (const Refused& c : cases) {
    Thing t;
    const auto before = parameters_of(t);
    const Refusal r = set_parameter(t, c.path, c.value);
    EXPECT_EQ(r.message, c.message);
    EXPECT_EQ(r.nearest, c.nearest) << c.message;
    const auto after = parameters_of(t);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].value, after[i].value) << c.message;
  }
}

TEST(Values, AreWrittenAsTomlAndReadBack) {
  const std::vector<std::pair<Value, std::string>> cases{
      {true, "true"},
      {0.1, "0.1"},
      {128.0, "128"},
      {-1e6, "-1000000"},
      {1e15, "1e+15"},
      {1e-300, "1e-300"},
      {-0.0, "-0"},
      {1.0 / 3, "0.3333333333333333"},
      {std::string("apic"), "\"apic\""},
      {std::string("a\"b\\c\nd\te\x01"), R"("a\"b\\c\nd\te\u0001")"},
      {std::vector<double>{1, 2.5}, "[1, 2.5]"},
      {std::vector<std::string>{"a", "b, c"}, "[\"a\", \"b, c\"]"},
      {std::vector<std::string>{}, "[]"},
  };
  for (const auto& [value, text] : cases) {
    EXPECT_EQ(to_toml(value), text);
    EXPECT_EQ(parse_value(text), value) << text;
  }
}

TEST(Values, AreReadFromACommandLine) {
  EXPECT_EQ(parse_value(" 1.5 "), Value(1.5));
  EXPECT_EQ(parse_value("+2"), Value(2.0));
  EXPECT_EQ(parse_value("apic"), Value(std::string("apic")));
  EXPECT_EQ(parse_value("false"), Value(false));
  EXPECT_EQ(parse_value("128,64"), Value(std::vector<double>{128, 64}));
  EXPECT_EQ(parse_value("kinetic, total"), Value(std::vector<std::string>{"kinetic", "total"}));
  EXPECT_EQ(parse_value("'a,b'"), Value(std::string("a,b")));
  EXPECT_EQ(parse_value("[1, 2,]"), Value(std::vector<double>{1, 2}));
  EXPECT_EQ(parse_value(""), Value(std::string()));
  EXPECT_EQ(parse_value("1e5x"), Value(std::string("1e5x")));
  EXPECT_TRUE(std::isnan(std::get<double>(parse_value("nan")))) << "so that the parameter can refuse it";
}

TEST(Values, RefuseTextThatIsBroken) {
  for (const char* text : {"[1, 2", "\"abc", "1,,2", "1,two", "[1, \"a\"]", R"("\q")", R"("\u12")"})
    EXPECT_THROW((void)parse_value(text), UserError) << text;
}

TEST(Blend, MovesNumbersAndSwitchesTheRestAtTheEnd) {
  EXPECT_EQ(blend(Value(1.0), Value(3.0), 0.25), Value(1.5));
  EXPECT_EQ(blend(Value(0.1), Value(0.7), 1), Value(0.7)) << "the end is exact";
  EXPECT_EQ(blend(Value(0.1), Value(0.7), 0), Value(0.1));
  EXPECT_EQ(blend(Value(std::vector<double>{0, 2}), Value(std::vector<double>{1, 4}), 0.5),
            Value(std::vector<double>{0.5, 3}));
  EXPECT_EQ(blend(Value(std::string("pic")), Value(std::string("flip")), 0.99), Value(std::string("pic")));
  EXPECT_EQ(blend(Value(std::string("pic")), Value(std::string("flip")), 1), Value(std::string("flip")));
  EXPECT_EQ(blend(Value(std::vector<double>{0, 2}), Value(std::vector<double>{1}), 0.5),
            Value(std::vector<double>{0, 2}));
}

TEST(NearestName, FindsSlipsAndNothingElse) {
  const std::vector<std::string> names{"pic", "flip", "rpic", "apic", "transfer.flip_ratio", "grid.cells"};
  EXPECT_EQ(nearest_name("fliip", names), "flip");
  EXPECT_EQ(nearest_name("FLIP", names), "flip");
  EXPECT_EQ(nearest_name("apci", names), "apic") << "two neighbours swapped";
  EXPECT_EQ(nearest_name("flip_ratoi", names), "transfer.flip_ratio");
  EXPECT_EQ(nearest_name("grid.cell", names), "grid.cells");
  EXPECT_EQ(nearest_name("xyz", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name(std::string(1000000, 'x'), names), "");
}

TEST(Errors, SayWhereAndWhatIsNearest) {
  EXPECT_STREQ(UserError("wrong").what(), "wrong");
  EXPECT_STREQ(UserError("wrong", {"a.toml", 3, 7}).what(), "a.toml:3:7: wrong");
  EXPECT_STREQ(UserError("wrong", {"a.toml"}, "right").what(), "a.toml: wrong; did you mean \"right\"?");
  const NonFiniteError e("FLIP 1", 120, 0.25, 17);
  EXPECT_STREQ(e.what(), "FLIP 1: particle 17 is no longer finite after step 120 (t = 0.25 s)");
  EXPECT_EQ(e.step, 120U);
  EXPECT_EQ(e.particle, 17U);
}

TEST(Errors, OfOneTextComeTogetherAndOnce) {
  Mistakes m;
  EXPECT_NO_THROW(m.raise());
  m.add("first", {"a", 1, 1});
  m.add("second", {"a", 2, 1}, "seconds");
  m.add("first", {"a", 1, 1});
  try {
    m.raise();
    FAIL();
  } catch (const UserError& e) {
    EXPECT_STREQ(e.what(), "a:1:1: first\na:2:1: second; did you mean \"seconds\"?");
  }
}

} // namespace
} // namespace flipbook
