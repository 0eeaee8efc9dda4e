// SPDX-License-Identifier: MIT
#include "render/gui/fonts.h"

#include "render/font_file.h"
#include "render/gui/plain_text.h"

#include <imgui.h>
#include <imgui_freetype.h>

#include <cmath>

namespace flipbook::render::gui {
namespace {

struct Face {
  const char* file;
  float points;
};
// In the order of Type.
constexpr std::array<Face, 4> faces{{
    {"DejaVuSans.ttf", 11},
    {"DejaVuSans.ttf", 13},
    {"DejaVuSans-Bold.ttf", 13},
    {"DejaVuSans-Bold.ttf", 19},
}};

// Latin, Greek, superscripts and subscripts, dashes, arrows and the signs of vector calculus.
constexpr std::array<ImWchar, 17> glyphs{0x20,   0x17F,  0x370,  0x3FF,  0x2010, 0x2027, 0x2030, 0x203A, 0x2070,
                                         0x209C, 0x2190, 0x2199, 0x2200, 0x222B, 0x2248, 0x2265, 0};

} // namespace

Fonts::Fonts(float scale) : scale_(scale), atlas_(std::make_unique<ImFontAtlas>()) {
  atlas_->Flags |= ImFontAtlasFlags_NoMouseCursors;
  atlas_->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas_->TexDesiredWidth = scale > 1.5F ? 4096 : 2048;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const float pixels = std::round(faces[i].points * scale);
    if (const std::string path = find_font(faces[i].file); !path.empty()) {
      ImFontConfig config;
      config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
      config.OversampleH = config.OversampleV = 1;
      fonts_[i] = atlas_->AddFontFromFileTTF(path.c_str(), pixels, &config, glyphs.data());
    }
    if (fonts_[i] == nullptr) {
      ImFontConfig config;
      config.SizePixels = pixels;
      fonts_[i] = atlas_->AddFontDefault(&config);
      plain_ = true;
      if (note_.empty()) note_ = no_font(faces[i].file) + ": text is drawn with a plain built-in font";
    }
  }
  atlas_->Build();
}

Fonts::~Fonts() = default;

float Fonts::size(Type t) const {
  return font(t)->FontSize;
}

bool Fonts::has(Type t, char32_t sign) const {
  return sign <= IM_UNICODE_CODEPOINT_MAX && font(t)->FindGlyphNoFallback(static_cast<ImWchar>(sign)) != nullptr;
}

std::string Fonts::drawable(std::string_view text) const {
  if (!plain_) return std::string(text);
  return plain_text(text, [&](char32_t code) { return has(Type::small, code); });
}

float Fonts::width(Type t, std::string_view text) const {
  return plain_ ? plain_width(t, drawable(text)) : plain_width(t, text);
}

float Fonts::plain_width(Type t, std::string_view text) const {
  return font(t)->CalcTextSizeA(size(t), 1e9F, 0, text.data(), text.data() + text.size()).x;
}

std::string Fonts::fit(Type t, std::string_view text, float max_width) const {
  if (width(t, text) <= max_width) return drawable(text);
  std::string_view head = text;
  while (!head.empty()) {
    head.remove_suffix(1);
    const bool inside_character = (static_cast<unsigned char>(text[head.size()]) & 0xC0U) == 0x80U;
    if (inside_character || (!head.empty() && head.back() == ' ')) continue;
    const std::string candidate = std::string(head) + "…";
    if (width(t, candidate) <= max_width) return head.empty() ? "" : drawable(candidate);
  }
  return {};
}

std::vector<std::string> Fonts::wrap(Type t, std::string_view text, float max_width, std::size_t most) const {
  std::vector<std::string> lines;
  while (!text.empty() && lines.size() < most) {
    std::size_t end = text.size();
    if (lines.size() + 1 < most)
      while (end != std::string_view::npos && width(t, text.substr(0, end)) > max_width)
        end = end == 0 ? std::string_view::npos : text.rfind(' ', end - 1);
    if (end == std::string_view::npos) end = std::min(text.find(' '), text.size()); // one long word
    lines.push_back(fit(t, text.substr(0, end), max_width));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

} // namespace flipbook::render::gui
