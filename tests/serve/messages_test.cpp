// SPDX-License-Identifier: MIT
// What the server takes for a message, and what it does not.
#include "app/serve/messages.h"

#include <gtest/gtest.h>

#include <string>

namespace flipbook::app::serve {
namespace {

template <class T> T parsed(const std::string& text) {
  std::string why;
  const auto m = parse_message(text, why);
  EXPECT_TRUE(m.has_value()) << text << ": " << why;
  if (!m || !std::holds_alternative<T>(*m)) {
    ADD_FAILURE() << text << " is another message";
    return T{};
  }
  return std::get<T>(*m);
}

bool refused(const std::string& text) {
  std::string why;
  const bool none = !parse_message(text, why).has_value();
  EXPECT_EQ(none, !why.empty()) << text;
  return none;
}

TEST(Messages, APointerHasAPlaceButtonsAndATool) {
  const auto m = parsed<PointerMessage>(
      R"({"type":"pointer","seq":17,"x":0.25,"y":0.5,"buttons":5,"wheel":-2,"shift":true,"tool":"push","radius":0.1})");
  EXPECT_EQ(m.seq, 17U);
  EXPECT_EQ(m.x, 0.25);
  EXPECT_EQ(m.y, 0.5);
  EXPECT_EQ(m.buttons, 5U);
  EXPECT_EQ(m.wheel, -2);
  EXPECT_TRUE(m.with.shift);
  EXPECT_FALSE(m.with.ctrl);
  EXPECT_EQ(m.tool, Tool::push);
  EXPECT_EQ(m.radius, 0.1);
}

TEST(Messages, NumbersOfAPointerStayWithinTheirRange) {
  const auto m = parsed<PointerMessage>(
      R"({"type":"pointer","seq":4294967295,"x":1e300,"y":-7,"buttons":255,"wheel":1e9,"radius":99})");
  EXPECT_EQ(m.seq, 4294967295U);
  EXPECT_EQ(m.x, 2);
  EXPECT_EQ(m.y, -1);
  EXPECT_EQ(m.buttons, 7U);
  EXPECT_EQ(m.wheel, 10);
  EXPECT_EQ(m.radius, 0.5);
}

TEST(Messages, AValueIsAFlagANumberATextOrAList) {
  const auto value = [](const std::string& json) {
    return *parsed<DoMessage>(R"({"type":"do","action":"set","path":"a.b","value":)" + json + "}").value;
  };
  EXPECT_EQ(value("true"), Value(true));
  EXPECT_EQ(value("0.5"), Value(0.5));
  EXPECT_EQ(value("\"apic\""), Value(std::string("apic")));
  EXPECT_EQ(value("[1,2]"), Value(std::vector<double>{1, 2}));
  EXPECT_EQ(value("[\"a\"]"), Value(std::vector<std::string>{"a"}));
  EXPECT_EQ(value("[]"), Value(std::vector<std::string>{}));
  for (const char* bad : {"null", "{}", "[1,\"a\"]", "[[1]]", "1e999", "[true]"})
    EXPECT_TRUE(refused(R"({"type":"do","action":"set","path":"a.b","value":)" + std::string(bad) + "}")) << bad;
}

TEST(Messages, EveryActionHasItsName) {
  EXPECT_EQ(parsed<DoMessage>(R"({"type":"do","action":"play"})").action, Action::play);
  EXPECT_EQ(parsed<DoMessage>(R"({"type":"do","action":"parameters","on":false})").on, false);
  EXPECT_EQ(parsed<DoMessage>(R"({"type":"do","action":"drive","take":false})").on, false);
  EXPECT_EQ(parsed<DoMessage>(R"({"type":"do","action":"record","kind":"png"})").kind, "png");
  EXPECT_EQ(parsed<DoMessage>(R"({"type":"do","action":"open","kind":"scene","name":"../x"})").name, "../x");
  EXPECT_TRUE(refused(R"({"type":"do","action":"record","kind":"/etc/passwd"})"));
  EXPECT_TRUE(refused(R"({"type":"do","action":"open","kind":"file","name":"x"})"));
  EXPECT_TRUE(refused(R"({"type":"do","action":"remove"})"));
  EXPECT_TRUE(refused(R"({"type":"do","action":"set","path":"a","value":1,"pane":13})"));
  EXPECT_TRUE(refused(R"({"type":"do","action":"set","path":"a"})"));
}

TEST(Messages, WhatIsNoMessageIsRefusedWithAReason) {
  for (const char* bad :
       {"", "{", "null", "[]", "1", "\"do\"", "{}", R"({"type":1})", R"({"type":"quit"})", R"({"type":"ack"})",
        R"({"type":"ack","picture":-1})", R"({"type":"ack","picture":0.5})", R"({"type":"ack","picture":4294967296})",
        R"({"type":"pointer","seq":1,"x":"0","y":0})", R"({"type":"pointer","seq":1,"x":0,"y":0,"tool":"axe"})",
        R"({"type":"key","seq":1})", R"({"type":"view","width":1e999,"height":1})", "{\"type\":\"\xff\"}",
        R"({"type":"ack","picture":1} )"
        "x"})
    EXPECT_TRUE(refused(bad)) << bad;
}

TEST(Messages, LongAndDeepOnesAreRefused) {
  const std::string head = R"({"type":"text","seq":1,"text":")";
  EXPECT_FALSE(refused(head + std::string(64, 'x') + "\"}"));
  EXPECT_TRUE(refused(head + std::string(65, 'x') + "\"}"));
  EXPECT_TRUE(refused(R"({"type":"ack","picture":1,"x":")" + std::string(longest_message, 'x') + "\"}"));
  EXPECT_TRUE(refused(R"({"type":"ack","picture":1,"x":)" + std::string(1000, '[') + std::string(1000, ']') + "}"));
  EXPECT_TRUE(refused(R"({"type":"ack","picture":1,"x":[[[[1]]]]})"));
}

} // namespace
} // namespace flipbook::app::serve
