// SPDX-License-Identifier: MIT
#include "sim/scene/expression.h"

#include "tests/unit/message.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <thread>

namespace flipbook {
namespace {

double at(const std::string& text, double x, double y) {
  return Expression(text, {"x", "y"}, {})(std::array{x, y});
}

TEST(Expression, IsTheFormula) {
  EXPECT_DOUBLE_EQ(at("sin(2*pi*x)*cos(2*pi*y)", 0.1, 0.2), std::sin(0.2 * M_PI) * std::cos(0.4 * M_PI));
  EXPECT_DOUBLE_EQ(at("x < 0.2 ? 5*x : x < 0.4 ? 2 - 5*x : 0", 0.3, 0), 0.5);
  EXPECT_DOUBLE_EQ(at("sqrt(x^2 + y^2) + exp(0) + abs(-1) + min(1, 2)", 3, 4), 8);
  EXPECT_DOUBLE_EQ(at("ln(e) + -x", 2, 0), -1);
}

struct Broken {
  std::string text, message;
};

TEST(Expression, SaysWhatIsWrongWithAFormula) {
  const std::vector<Broken> cases{
      {"sqr(x)", "s.toml:4:2: the formula \"sqr(x)\" uses the unknown name \"sqr\"; did you mean \"sqrt\"?"},
      {"2*q", "s.toml:4:2: the formula \"2*q\" uses the unknown name \"q\""},
      {"x = 2", "s.toml:4:2: the formula \"x = 2\" must be one expression, without \"=\" and without commas"},
      {"x, y", "s.toml:4:2: the formula \"x, y\" must be one expression, without \"=\" and without commas"},
  };
  for (const Broken& c : cases)
    EXPECT_EQ(message_of([&] { Expression(c.text, {"x", "y"}, {"s.toml", 4, 2}); }), c.message);
}

TEST(Expression, RefusesEveryBrokenText) {
  for (const std::string& text : {std::string(), std::string("("), std::string("1 +"), std::string("sin"),
                                  std::string("\"a\""), std::string(5000, '('), std::string(5000, '1')})
    EXPECT_NE(message_of([&] {
                Expression(text, {"x"}, {"s.toml", 1, 1});
              }).find("s.toml:1:1: "),
              std::string::npos)
        << text.substr(0, 20);
}

TEST(Expression, RefusesAResultThatIsNotFinite) {
  const Expression e("1/x", {"x"}, {"s.toml", 1, 1});
  EXPECT_DOUBLE_EQ(e(std::array{4.0}), 0.25);
  EXPECT_EQ(message_of([&] { (void)e(std::array{0.0}); }),
            "s.toml:1:1: the formula \"1/x\" is not a finite number at (0.000000)");
}

TEST(Expression, MayBeUsedFromSeveralThreads) {
  const Expression e("x*x", {"x"}, {});
  std::array<bool, 4> right{true, true, true, true};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < right.size(); ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 2000; ++i) {
        const double x = static_cast<double>(t) * 10000 + i;
        right[t] = right[t] && e(std::array{x}) == x * x;
      }
    });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(right, (std::array{true, true, true, true}));
}

} // namespace
} // namespace flipbook
