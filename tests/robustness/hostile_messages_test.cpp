// SPDX-License-Identifier: MIT
// Whatever a network says to the server is a message with numbers in their ranges, or is refused with a reason. Seeds
// are fixed: a failure can be run again.
#include "app/serve/messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace flipbook::app::serve {
namespace {

const std::vector<std::string> good{
    R"({"type":"pointer","seq":17,"x":0.25,"y":0.5,"buttons":5,"wheel":-2,"shift":true,"tool":"push","radius":0.1})",
    R"({"type":"orbit","seq":1,"dx":0.1,"dy":-0.1})",
    R"({"type":"key","seq":2,"key":"ArrowLeft","down":true,"ctrl":false})",
    R"({"type":"text","seq":3,"text":"0.5"})",
    R"({"type":"ack","picture":12})",
    R"({"type":"view","width":1280,"height":720})",
    R"({"type":"do","action":"set","path":"transfer.flip_ratio","value":0.5,"pane":2})",
    R"({"type":"do","action":"set","path":"fluid.gravity","value":[0,-9.81,0]})",
    R"({"type":"do","action":"open","kind":"scene","name":"drop"})",
    R"({"type":"do","action":"record","kind":"video"})"};

void expect_within(const Value& value) {
  const auto* x = std::get_if<double>(&value);
  EXPECT_TRUE(!x || std::isfinite(*x));
  if (const auto* list = std::get_if<std::vector<double>>(&value)) {
    EXPECT_LE(list->size(), 64U);
    for (const double number : *list) EXPECT_TRUE(std::isfinite(number));
  }
  const auto* text = std::get_if<std::string>(&value);
  EXPECT_TRUE(!text || text->size() <= 256);
}

struct Within {
  void operator()(const PointerMessage& m) const {
    EXPECT_TRUE(m.x >= -1 && m.x <= 2 && m.y >= -1 && m.y <= 2);
    EXPECT_LE(m.buttons, 7U);
    EXPECT_LE(std::abs(m.wheel), 10);
    EXPECT_TRUE(m.radius >= 0.01 && m.radius <= 0.5);
    EXPECT_LE(static_cast<int>(m.tool), 4);
  }
  void operator()(const OrbitMessage& m) const { EXPECT_TRUE(std::abs(m.dx) <= 1 && std::abs(m.dy) <= 1); }
  void operator()(const KeyMessage& m) const { EXPECT_LE(m.key.size(), 64U); }
  void operator()(const TextMessage& m) const { EXPECT_LE(m.text.size(), 64U); }
  void operator()(const AckMessage&) const {}
  void operator()(const ViewMessage& m) const {
    EXPECT_TRUE(m.width >= 1 && m.width <= 16384 && m.height >= 1 && m.height <= 16384);
  }
  void operator()(const DoMessage& m) const {
    EXPECT_TRUE(m.pane >= 0 && m.pane <= 12);
    EXPECT_LE(m.path.size(), 256U);
    EXPECT_LE(m.name.size(), 256U);
    EXPECT_EQ(m.value.has_value(), m.action == Action::set);
    if (m.value) expect_within(*m.value);
  }
};

/// One of them is a message?
bool read(const std::string& text) {
  std::string why;
  const auto m = parse_message(text, why);
  if (m)
    std::visit(Within{}, *m);
  else
    EXPECT_FALSE(why.empty()) << text;
  return m.has_value();
}

TEST(HostileMessages, DamagedOnesAreReadWithinTheirRangesOrRefused) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::vector<std::string> pieces{"\"",
                                        "{",
                                        "}",
                                        "[",
                                        "]",
                                        ",",
                                        ":",
                                        "null",
                                        "1e308",
                                        "-1e308",
                                        "1e-400",
                                        "NaN",
                                        "\\u0000",
                                        "\xc3\x28",
                                        "true",
                                        "-0",
                                        "99999999999999999999",
                                        "\"type\":\"do\","};
  int taken = 0, refused = 0;
  for (int trial = 0; trial < 60'000; ++trial) {
    std::string text = good[below(good.size())];
    for (std::size_t change = 1 + below(4); change > 0; --change) {
      const std::size_t at = below(text.size() + 1);
      switch (below(5)) {
      case 0: text.insert(at, pieces[below(pieces.size())]); break;
      case 1: text.erase(at, 1 + below(8)); break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(random() & 255U);
        break;
      case 3: text.replace(at, std::min<std::size_t>(text.size() - at, below(6)), pieces[below(pieces.size())]); break;
      case 4: text += good[below(good.size())].substr(below(20)); break;
      }
      if (text.empty()) text = " ";
    }
    (read(text) ? taken : refused) += 1;
  }
  EXPECT_GT(taken, 1000);     // the damage is not always deadly,
  EXPECT_GT(refused, 20'000); // but often
}

TEST(HostileMessages, NoiseIsRefused) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 20'000; ++trial) {
    std::string text(random() % 300, ' ');
    for (char& c : text) c = static_cast<char>(random() & 255U);
    EXPECT_FALSE(read(text));
  }
}

TEST(HostileMessages, EveryPrefixOfAMessageIsRefused) {
  for (const std::string& text : good)
    for (std::size_t n = 0; n < text.size(); ++n) EXPECT_FALSE(read(text.substr(0, n))) << text.substr(0, n);
}

} // namespace
} // namespace flipbook::app::serve
