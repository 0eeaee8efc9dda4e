// SPDX-License-Identifier: MIT
// No pane with a mistake can be taken for a normal one: not small, not cropped.
#include "render/renderer.h"
#include "tests/golden/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace flipbook::test {
namespace {

/// The last pane makes a mistake.
render::Frame marked(std::size_t panes) {
  render::Frame f = dam_frame(panes);
  auto s = std::make_shared<Snapshot>(*f.panes.back().snapshot);
  s->watermark = "WITH A MISTAKE: D of another kernel";
  f.panes.back().snapshot = s;
  return f;
}

std::vector<std::string> added(const std::vector<render::TextBox>& with, const std::vector<render::TextBox>& without) {
  std::vector<std::string> texts;
  for (const render::TextBox& t : with)
    if (std::none_of(without.begin(), without.end(), [&](const render::TextBox& o) { return o.text == t.text; }))
      texts.push_back(t.text);
  return texts;
}

TEST(Watermark, IsReadableInAnyPane) {
  const auto context = render::Context::create(render::Backend::automatic);
  const auto banner = [&](std::size_t panes, int width, int height) {
    render::Renderer renderer(*context, width, height, {});
    (void)renderer.draw(dam_frame(panes), {});
    const auto without = renderer.labels();
    (void)renderer.draw(marked(panes), {});
    return added(renderer.labels(), without);
  };
  EXPECT_EQ(banner(1, 1280, 720), std::vector<std::string>{"WITH A MISTAKE: D of another kernel"});
  EXPECT_EQ(banner(12, 1280, 720), std::vector<std::string>{"D of another kernel"}) << "the slanted words say the rest";
}

TEST(Watermark, CoversAllOfItsPaneAndNothingElse) {
  const auto context = render::Context::create(render::Backend::automatic);
  render::Renderer renderer(*context, 960, 540, {});
  const render::Image without = renderer.draw(dam_frame(2), {}), with = renderer.draw(marked(2), {});
  std::vector<std::pair<int, int>> changed;
  for (int y = 0; y < 540; ++y)
    for (int x = 0; x < 960; ++x) {
      const auto at = static_cast<std::size_t>(4 * (960 * y + x));
      if (!std::equal(with.rgba.begin() + static_cast<std::ptrdiff_t>(at),
                      with.rgba.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                      without.rgba.begin() + static_cast<std::ptrdiff_t>(at)))
        changed.emplace_back(x, y);
    }
  ASSERT_FALSE(changed.empty());
  const auto [left, right] = std::minmax_element(changed.begin(), changed.end());
  const auto by_row = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto [top, bottom] = std::minmax_element(changed.begin(), changed.end(), by_row);
  const int width = right->first - left->first, height = bottom->second - top->second;
  EXPECT_GT(width, 150);
  EXPECT_LT(width, 480) << "one pane of two";
  // Every quarter of the pane has some of it, so that no part can be cut out without any.
  for (int i = 0; i < 4; ++i) {
    const auto in_band = [&, i](const std::pair<int, int>& p) {
      return (p.second - top->second) * 4 / (height + 1) == i;
    };
    EXPECT_GT(std::count_if(changed.begin(), changed.end(), in_band), 100) << i;
  }
}

} // namespace
} // namespace flipbook::test
