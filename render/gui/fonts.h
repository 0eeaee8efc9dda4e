// SPDX-License-Identifier: MIT
// The type faces of a picture, drawn by FreeType at exactly the sizes in use, so that text is crisp in any picture
// size.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct ImFont;
struct ImFontAtlas;

namespace flipbook::render::gui {

/// The few sizes that everything is set in, small to large.
enum class Type { small, body, strong, title };

class Fonts {
public:
  /// Sizes for a picture where one point is `scale` pixels.
  explicit Fonts(float scale);
  ~Fonts();
  Fonts(const Fonts&) = delete;
  Fonts& operator=(const Fonts&) = delete;

  [[nodiscard]] ImFont* font(Type t) const { return fonts_[static_cast<std::size_t>(t)]; }
  [[nodiscard]] float size(Type t) const; ///< pixels
  [[nodiscard]] float width(Type t, std::string_view text) const;
  [[nodiscard]] bool has(Type t, char32_t sign) const; ///< can it be drawn?
  /// The text as this font can draw it: unchanged but for signs that a built-in font lacks.
  [[nodiscard]] std::string drawable(std::string_view text) const;
  /// The text, or as much of it as fits followed by an ellipsis.
  [[nodiscard]] std::string fit(Type t, std::string_view text, float max_width) const;
  /// The text in lines that are no wider, parted at blanks; at most `most` lines, the last of which then ends with an
  /// ellipsis.
  [[nodiscard]] std::vector<std::string> wrap(Type t, std::string_view text, float max_width, std::size_t most) const;
  [[nodiscard]] float scale() const { return scale_; }
  [[nodiscard]] ImFontAtlas& atlas() const { return *atlas_; }
  /// Empty, or what a user should know: which font file was found nowhere.
  [[nodiscard]] const std::string& note() const { return note_; }

private:
  float scale_;
  std::unique_ptr<ImFontAtlas> atlas_;
  std::array<ImFont*, 4> fonts_{};
  bool plain_ = false; ///< one of them is Dear ImGui's own, which knows Latin only
  std::string note_;

  [[nodiscard]] float plain_width(Type t, std::string_view text) const;
};

} // namespace flipbook::render::gui
