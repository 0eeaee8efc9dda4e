// SPDX-License-Identifier: MIT
// The page as text: everything from outside is escaped, everything it names is relative, nothing is loaded from
// elsewhere.
#include "app/gallery/page.h"
#include "app/gallery/page_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace flipbook::app::gallery {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* hostile = "</script><script>alert(1)</script>\"'<img src=x onerror=alert(2)>&amp;@TITLE@";

Piece hostile_piece(Piece::Kind kind) {
  Piece p;
  p.kind = kind;
  p.id = "one";
  for (std::string* text : {&p.title, &p.text, &p.alt, &p.command, &p.study, &p.note}) *text = hostile;
  p.media = p.narrow = "media/one.svg";
  p.cues = {{1, 2, {hostile}}};
  p.parameters = {.caption = hostile, .head = {"", hostile}, .rows = {{hostile, hostile}}};
  p.downloads = {{hostile, "media/<b>.csv"}};
  p.scrubber = {.parameter = hostile,
                .help = hostile,
                .unit = hostile,
                .values = {hostile, "1"},
                .titles = {hostile, "1"},
                .times = {0, 1},
                .files = {"media/<i>.webp", "b", "c", "d"}};
  return p;
}

std::string page(const std::vector<Piece>& pieces, bool inlined = false, const fs::path& folder = ".") {
  return page_html({hostile, hostile, pieces}, folder, inlined);
}

/// The page without what are its own scripts and its style.
std::string own_parts_removed(std::string html) {
  for (const PageFile& f : page_files()) {
    if (f.name.ends_with(".html")) continue;
    const std::size_t at = html.find(f.text);
    EXPECT_NE(at, std::string::npos) << f.name << " is in the page";
    if (at != std::string::npos) html.erase(at, f.text.size());
  }
  return html;
}

TEST(Page, NothingFromOutsideBecomesMarkup) {
  for (const auto kind : {Piece::Kind::video, Piece::Kind::picture, Piece::Kind::figure, Piece::Kind::scrubber}) {
    const std::string html = own_parts_removed(page({hostile_piece(kind), hostile_piece(kind)}));
    EXPECT_THAT(html, Not(HasSubstr("<img src=x")));
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, Not(HasSubstr("</script><script>alert")));
    EXPECT_THAT(html, Not(HasSubstr("<b>.csv")));
    EXPECT_THAT(html, Not(HasSubstr("<i>.webp")));
    EXPECT_THAT(html, HasSubstr("&lt;img src=x onerror=alert(2)&gt;&amp;amp;@TITLE@")) << "and nothing is lost";
  }
}

TEST(Page, LoadsNothingFromElsewhere) {
  const std::string html = page({hostile_piece(Piece::Kind::video), hostile_piece(Piece::Kind::scrubber)});
  const std::regex loads(R"re((?:src|href|srcset|poster|url)\s*[=(]\s*["']?\s*((?:https?:)?//[^"') ]*))re");
  std::smatch found;
  EXPECT_FALSE(std::regex_search(html, found, loads)) << found[1];
  EXPECT_THAT(html, Not(HasSubstr("@import")));
}

TEST(Page, KnowsItself) {
  EXPECT_THAT(page({}), HasSubstr(page_mark));
  EXPECT_THAT(page({hostile_piece(Piece::Kind::figure)}), Not(HasSubstr("<nav"))) << "one piece needs no contents";
}

TEST(Page, InlineHoldsItsFiles) {
  const fs::path folder = fs::path(::testing::TempDir()) / "flipbook-inline";
  fs::create_directories(folder / "media");
  std::ofstream(folder / "media/one.svg") << "<svg/>";
  Piece p;
  p.kind = Piece::Kind::figure;
  p.id = "one";
  p.media = p.narrow = "media/one.svg";
  const std::string html = page({p}, true, folder);
  EXPECT_THAT(html, HasSubstr("data:image/svg+xml;base64,PHN2Zy8+"));
  EXPECT_THAT(html, Not(HasSubstr("media/one.svg")));
  fs::remove_all(folder);
}

} // namespace
} // namespace flipbook::app::gallery
