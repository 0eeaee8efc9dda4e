// SPDX-License-Identifier: MIT
// Files that were cut, changed or made to do harm: each is refused with one of our errors, quickly and in little
// memory.
#include "app/study/resolve.h"
#include "sim/core/random.h"
#include "sim/frame/snapshot.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace flipbook {
namespace {

Snapshot small_snapshot() {
  Snapshot s;
  s.title = "FLIP";
  s.parameters = {{"a.b", Kind::real, 0.5, "h", "m", 0, 1, {"x"}, {"y"}, Level::teach, Effect::live, true, "lo", "hi"}};
  s.x = {0.1F, 0.2F, 0.3F, 0.4F};
  s.v = {0, 0, 0, 0};
  s.id = {0, 1};
  s.channels = {{"speed", "m/s", 0, 1, false, {0, 1}}};
  s.lattices = {{"u", {2, 1, 1}, {0, 0, 0}, 1, {0, 1}}};
  s.history = std::make_shared<History>(History{{0}, {{"kinetic", "J", {1}}}});
  return s;
}

std::string text_of(const Snapshot& s) {
  const TemporaryFile file("source.txt");
  save_snapshot(s, file.path());
  return file.content();
}

std::string load(const std::string& text) {
  const TemporaryFile file("hostile.txt", text);
  std::string message = message_of([&] { (void)load_snapshot(file.path()); });
  const std::size_t at = message.find(file.path());
  if (at != std::string::npos) message.replace(at, file.path().size(), "S");
  return message;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) ADD_FAILURE() << what;
  return text.replace(at, what.size(), by);
}

TEST(HostileSnapshot, IsRefusedWithItsLine) {
  const std::string good = text_of(small_snapshot());
  EXPECT_EQ(load(good), "no error");
  EXPECT_EQ(load("nonsense"), "S:1:1: is not a snapshot: its first line must be \"flipbook-snapshot 1\"");
  EXPECT_EQ(load(replaced(good, "\nx 4 ", "\nx 4000000000 ")),
            "S:36: a length of 4000000000 is more than the file holds");
  EXPECT_EQ(load(replaced(good, "\nparameters 1", "\nparameters 99")),
            "S:6: a length of 99 is more than the file holds");
  EXPECT_EQ(load(replaced(good, "\nx 4 ", "\nx -1 ")), "S:36: expected a number");
}

TEST(HostileSnapshot, MustBeConsistent) {
  const auto wrong = [](const std::function<void(Snapshot&)>& change) {
    Snapshot s = small_snapshot();
    change(s);
    return load(text_of(s));
  };
  EXPECT_EQ(wrong([](Snapshot& s) { s.dim = 4; }), "S: dim must be 2 or 3");
  EXPECT_EQ(wrong([](Snapshot& s) { s.dx = 0; }), "S: dx must be positive");
  EXPECT_EQ(wrong([](Snapshot& s) { s.hi[1] = s.lo[1]; }), "S: hi must be above lo on every axis");
  EXPECT_EQ(wrong([](Snapshot& s) { s.hi[0] = std::numeric_limits<double>::infinity(); }),
            "S: the domain must be finite");
  EXPECT_EQ(wrong([](Snapshot& s) { s.up = {0, 1, 1}; }), "S: up must point along one axis");
  const auto wrong_mesh = [&](const TriangleMesh& m) {
    return wrong([&](Snapshot& s) { s.solids = {{std::make_shared<TriangleMesh>(m), {}}}; });
  };
  EXPECT_EQ(wrong_mesh({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}, {2, 0}}), "no error");
  const std::string stray = "S: a solid's triangles and outline must name its vertices";
  EXPECT_EQ(wrong_mesh({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 3}, {}}), stray);
  EXPECT_EQ(wrong_mesh({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1}, {}}), stray);
  EXPECT_EQ(wrong_mesh({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {}, {7, 0}}), stray);
  const std::string numbers = "S: a solid must have three finite numbers for each vertex";
  EXPECT_EQ(wrong_mesh({{0, 0}, {}, {}}), numbers);
  EXPECT_EQ(wrong_mesh({{0, 0, std::numeric_limits<float>::quiet_NaN()}, {}, {}}), numbers);
  EXPECT_EQ(wrong([](Snapshot& s) {
              s.solids = {{std::make_shared<TriangleMesh>(), {}}};
              s.solids[0].pose.shift[2] = std::numeric_limits<double>::quiet_NaN();
            }),
            "S: the pose of a solid must be finite");
  EXPECT_EQ(wrong([](Snapshot& s) { s.x.pop_back(); }), "S: x must hold 4 numbers, one per particle and axis");
  EXPECT_EQ(wrong([](Snapshot& s) { s.v.push_back(0); }), "S: v must hold 4 numbers, one per particle and axis");
  EXPECT_EQ(wrong([](Snapshot& s) { s.channels[0].values.clear(); }),
            "S: channel \"speed\" must hold a number for each particle");
  EXPECT_EQ(wrong([](Snapshot& s) { s.lattices[0].n = {3, 1, 1}; }), "S: lattice \"u\" must hold 3 numbers");
  EXPECT_EQ(wrong([](Snapshot& s) { s.lattices[0].n = {-1, 1, 1}; }), "S: lattice \"u\" has an impossible size");
  EXPECT_EQ(wrong([](Snapshot& s) {
              s.history = std::make_shared<History>(History{{0, 1}, {{"k", "J", {1}}}});
            }),
            "S: curve \"k\" must be as long as its times");
}

/// Every prefix, and thousands of texts with a few bytes changed: an error or a snapshot, never anything else.
TEST(HostileSnapshot, CutOrChangedAnywhereIsHandled) {
  const std::string good = text_of(small_snapshot());
  for (std::size_t n = 0; n + 1 < good.size(); n += 3) EXPECT_NE(load(good.substr(0, n)), "no error") << n;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    std::string text = good;
    for (std::uint64_t k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(uniform(1, i, 2 * k) * static_cast<double>(text.size()));
      text[at] = static_cast<char>(32 + static_cast<int>(uniform(1, i, 2 * k + 1) * 95));
    }
    (void)load(text);
  }
}

TEST(HostileScene, CutOrChangedAnywhereIsHandled) {
  const std::string good = read_text_file(std::string(FLIPBOOK_SOURCE_DIR) + "/assets/scenes/annotated.toml");
  const auto read = [](const std::string& text) { return message_of([&] { (void)parse_scene(text, "s.toml"); }); };
  EXPECT_EQ(read(good), "no error");
  for (std::size_t n = 0; n < good.size(); n += 7) (void)read(good.substr(0, n));
  int refused = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    std::string text = good;
    for (std::uint64_t k = 0; k < 4; ++k) {
      const auto at = static_cast<std::size_t>(uniform(2, i, 2 * k) * static_cast<double>(text.size()));
      text[at] = static_cast<char>(static_cast<int>(uniform(2, i, 2 * k + 1) * 256) - 128);
    }
    refused += read(text) == "no error" ? 0 : 1;
  }
  EXPECT_GT(refused, 500);
}

TEST(HostileStudy, CutOrChangedAnywhereIsHandled) {
  const std::string good = app::to_toml(app::read_study("annotated"));
  const auto read = [](const std::string& text) {
    return message_of([&] { (void)app::resolve(app::parse_study(text, "s.toml")); });
  };
  EXPECT_EQ(read(good), "no error");
  for (std::size_t n = 0; n < good.size(); n += 5) (void)read(good.substr(0, n));
  for (std::uint64_t i = 0; i < 1000; ++i) {
    std::string text = good;
    const auto at = static_cast<std::size_t>(uniform(3, i, 0) * static_cast<double>(text.size()));
    text[at] = static_cast<char>(32 + static_cast<int>(uniform(3, i, 1) * 95));
    (void)read(text);
  }
}

TEST(HostileToml, ThatIsDeepOrLongIsRefused) {
  const auto read = [](const std::string& text) { return message_of([&] { (void)parse_toml(text, "s.toml"); }); };
  EXPECT_NE(read("a = " + std::string(100000, '[')).find("s.toml:1:"), std::string::npos);
  EXPECT_NE(read("a = " + std::string(100000, '[') + std::string(100000, ']')).find("s.toml:1:"), std::string::npos);
  EXPECT_EQ(read(std::string(9U << 20U, '#')), "s.toml: is too long for a scene or a study");
  EXPECT_EQ(read("a = \n").substr(0, 18), "s.toml:1:5: not TO");
  EXPECT_NE(read("a = 1\na = 2\n").find("s.toml:2:"), std::string::npos);
  EXPECT_NE(read("\xff\xfe"), "no error");
}

TEST(HostileScene, NestedShapesEnd) {
  std::string shape = "{ shape = \"ball\", centre = [0.5, 0.5], radius = 0.1 }";
  for (int i = 0; i < 40; ++i) shape = "{ shape = \"union\", of = [" + shape + "] }";
  const std::string message = message_of([&] { (void)parse_scene("body = [" + shape + "]\n", "s.toml"); });
  EXPECT_NE(message.find("shapes are nested too deeply"), std::string::npos) << message;
}

TEST(HostileScene, ThatIsAFolderOrEndlessIsRefused) {
  EXPECT_EQ(message_of([] { (void)read_scene("/tmp/"); }), "there is no scene file \"/tmp/\"");
  EXPECT_EQ(message_of([] { (void)read_scene("/dev/zero"); }),
            "cannot read \"/dev/zero\": it is too long for a scene or a study");
  EXPECT_EQ(message_of([] { (void)read_text_file("/nonexistent/a.toml"); }),
            "cannot read \"/nonexistent/a.toml\": No such file or directory");
}

} // namespace
} // namespace flipbook
