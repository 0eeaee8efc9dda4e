// SPDX-License-Identifier: MIT
// Fonts come from a file that is looked for; where there is none, what the built-in one lacks is spelt.
#include "render/font_file.h"
#include "render/gui/fonts.h"
#include "render/gui/plain_text.h"
#include "tests/golden/curves.h"
#include "tests/golden/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

namespace flipbook::test {
namespace {

using render::gui::plain_text;
using testing::HasSubstr;

/// FLIPBOOK_FONTS for one test.
class OtherFonts {
public:
  explicit OtherFonts(const char* folder) {
    if (const char* before = std::getenv("FLIPBOOK_FONTS"); before != nullptr) before_ = before;
    setenv("FLIPBOOK_FONTS", folder, 1);
  }
  ~OtherFonts() {
    if (before_)
      setenv("FLIPBOOK_FONTS", before_->c_str(), 1);
    else
      unsetenv("FLIPBOOK_FONTS");
  }
  OtherFonts(const OtherFonts&) = delete;
  OtherFonts& operator=(const OtherFonts&) = delete;

private:
  std::optional<std::string> before_;
};

std::string ascii(std::string_view text) {
  return plain_text(text, [](char32_t code) { return code < 128; });
}

TEST(PlainText, SpellsWhatAFontLacks) {
  EXPECT_EQ(ascii("plain"), "plain");
  EXPECT_EQ(ascii("Δt 6.87 ms · 105 steps"), "dt 6.87 ms . 105 steps");
  EXPECT_EQ(ascii("10⁻³ kg m²/s"), "10^-3 kg m^2/s");
  EXPECT_EQ(ascii("E / E₀, v₁₂"), "E / E_0, v_12");
  EXPECT_EQ(ascii("largest divergence |∇·u| Δt"), "largest divergence |div u| dt");
  EXPECT_EQ(ascii("256 × 256, −9.81, ≤ 0 …"), "256 x 256, -9.81, <= 0 ...");
  EXPECT_EQ(ascii("ω, Ω, π"), "omega, Omega, pi");
  EXPECT_EQ(ascii("漢"), "?");
  EXPECT_EQ(ascii("\xff\xc3"), "??") << "bytes that are no text";
  EXPECT_EQ(plain_text("m²", [](char32_t) { return true; }), "m^2") << "raised digits are always spelt alike";
}

TEST(Fonts, AreDejaVuWithGreekAndIndices) {
  const render::gui::Fonts fonts(1);
  ASSERT_EQ(fonts.note(), "") << "package fonts-dejavu-core";
  EXPECT_EQ(fonts.drawable("Δt 10⁻³ E₀ ∇·u"), "Δt 10⁻³ E₀ ∇·u");
  for (const char32_t sign : {U'Δ', U'ω', U'μ', U'∇', U'⁻', U'³', U'⁹', U'₀', U'√', U'≤', U'−', U'·', U'…'})
    for (const auto type : {render::gui::Type::small, render::gui::Type::body, render::gui::Type::title})
      EXPECT_TRUE(fonts.has(type, sign)) << static_cast<std::uint32_t>(sign);
  EXPECT_FALSE(fonts.has(render::gui::Type::small, U'漢'));
}

TEST(Fonts, SayWhereTheyWereLookedFor) {
  {
    const OtherFonts none("/nowhere/at/all");
    EXPECT_EQ(render::find_font("DejaVuSans.ttf"), "") << "a folder that is named is the only one";
    const render::gui::Fonts fonts(1);
    EXPECT_EQ(
        fonts.note(),
        "there is no DejaVuSans.ttf in /nowhere/at/all (package fonts-dejavu-core, or FLIPBOOK_FONTS=folder): text "
        "is drawn with a plain built-in font");
    EXPECT_EQ(fonts.drawable("Δt 10⁻³"), "dt 10^-3");
    EXPECT_EQ(fonts.width(render::gui::Type::small, "Δt"), fonts.width(render::gui::Type::small, "dt"));
    EXPECT_EQ(fonts.fit(render::gui::Type::small, "Δt 6.87 ms and much more", 60).substr(0, 3), "dt ");
  }
  EXPECT_THAT(render::no_font("a.ttf"), HasSubstr("/usr/share/fonts/truetype/dejavu, "));
}

/// Without any font file pictures stay whole: nothing covers anything, and no sign is missing.
TEST(Fonts, BuiltInOnesMakeWholePictures) {
  const OtherFonts none("/nowhere/at/all");
  const auto context = render::Context::create(render::Backend::automatic);
  for (const int height : {360, 720, 1080}) {
    render::Renderer renderer(*context, height * 16 / 9, height, {});
    EXPECT_NE(renderer.note(), "");
    const auto& labels = renderer.measure(curves_frame(4, energies()), view_with({"view.arrows=true"}));
    for (std::size_t i = 0; i < labels.size(); ++i) {
      EXPECT_EQ(renderer.fonts().drawable(labels[i].text), labels[i].text) << "a sign is missing";
      EXPECT_EQ(labels[i].text.find('?'), std::string::npos) << labels[i].text;
      for (std::size_t k = i + 1; k < labels.size(); ++k)
        EXPECT_FALSE(labels[i].box.overlaps(labels[k].box)) << labels[i].text << " covers " << labels[k].text;
    }
  }
}

} // namespace
} // namespace flipbook::test
