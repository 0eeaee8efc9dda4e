// SPDX-License-Identifier: MIT
// What comes from a study becomes text in a page, and never anything else.
#include "app/gallery/html.h"
#include "sim/frame/errors.h"
#include "tests/unit/temporary_file.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace flipbook::app::gallery {
namespace {

TEST(Html, EscapesWhatHasAMeaning) {
  EXPECT_EQ(escape("<script>alert('1' & \"2\")</script>"),
            "&lt;script&gt;alert(&#39;1&#39; &amp; &quot;2&quot;)&lt;/script&gt;");
  EXPECT_EQ(escape("&lt;"), "&amp;lt;") << "text is not taken for an entity";
  EXPECT_EQ(escape(""), "");
}

TEST(Html, KeepsOtherWritingAndRepairsWhatIsNone) {
  EXPECT_EQ(escape("v \u2190 \u03a3 w u"), "v \u2190 \u03a3 w u");
  EXPECT_EQ(escape("a\nb\tc"), "a\nb\tc");
  EXPECT_EQ(escape(std::string("a\0b\x1b[0m", 7)), "a b [0m");
  EXPECT_EQ(escape("\xff"), "\uFFFD");
  EXPECT_EQ(escape("a\xe2\x82"), "a\uFFFD\uFFFD") << "cut off";
  EXPECT_EQ(escape("\xc0\xbc"), "\uFFFD\uFFFD") << "< in a form that is too long";
  EXPECT_EQ(escape("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD") << "half of a surrogate pair";
  EXPECT_EQ(escape("\xf4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond the last character";
}

TEST(Html, FillsMarksOnce) {
  EXPECT_EQ(fill("<p>@A@ and @B@</p>", {{"A", "@B@"}, {"B", "x"}}), "<p>@B@ and x</p>") << "what came in is no mark";
  EXPECT_EQ(fill("a@b.org @media (x) @", {}), "a@b.org @media (x) @");
  EXPECT_EQ(fill("@A@@A@", {{"A", "1"}}), "11");
  EXPECT_THROW((void)fill("@C@", {{"A", ""}}), std::logic_error);
}

TEST(Html, AddressesAreRelativeAndPlain) {
  EXPECT_EQ(address("media/dam_break-2.mp4"), "media/dam_break-2.mp4");
  EXPECT_EQ(address("media/50 % \"x\".png"), "media/50%20%25%20%22x%22.png");
}

TEST(Html, ShellsReadWordsBack) {
  EXPECT_EQ(shell_command({"flipbook", "render", "dam_break", "-o", "x.mp4"}), "flipbook render dam_break -o x.mp4");
  EXPECT_EQ(shell_word("grid.cells=[64, 64]"), "'grid.cells=[64, 64]'");
  EXPECT_EQ(shell_word("it's; rm -rf $HOME"), "'it'\\''s; rm -rf $HOME'");
  EXPECT_EQ(shell_word(""), "''");
}

/// RFC 4648, section 10.
TEST(Html, DataAddressesHoldTheFile) {
  const std::pair<std::string, std::string> known[]{{"f", "Zg=="},
                                                    {"fo", "Zm8="},
                                                    {"foo", "Zm9v"},
                                                    {"foob", "Zm9vYg=="},
                                                    {"fooba", "Zm9vYmE="},
                                                    {"foobar", "Zm9vYmFy"},
                                                    {std::string("\xff\xfe\0", 3), "//4A"}};
  for (const auto& [bytes, digits] : known) {
    const TemporaryFile file("data.png", bytes);
    EXPECT_EQ(data_uri(file.path()), "data:image/png;base64," + digits);
  }
  EXPECT_THROW((void)data_uri("/nowhere/x.png"), UserError);
}

} // namespace
} // namespace flipbook::app::gallery
