// SPDX-License-Identifier: MIT
#include "render/gui/fonts.h"

#include <imgui.h>
#include <imgui_freetype.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

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

/// The folders where distributions keep DejaVu; FLIPBOOK_FONTS comes first.
std::string find_font(const char* file) {
  std::array<std::string, 7> folders{"",
                                     "/usr/share/fonts/truetype/dejavu",
                                     "/usr/share/fonts/dejavu-sans-fonts",
                                     "/usr/share/fonts/dejavu",
                                     "/usr/share/fonts/TTF",
                                     "/usr/local/share/fonts",
                                     "/opt/homebrew/share/fonts"};
  if (const char* own = std::getenv("FLIPBOOK_FONTS"); own != nullptr) folders[0] = own;
  for (const std::string& folder : folders) {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::path(folder) / file;
    if (!folder.empty() && std::filesystem::is_regular_file(path, error)) return path.string();
  }
  return {};
}

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
      note_ = "no DejaVu fonts found (package fonts-dejavu-core, or FLIPBOOK_FONTS=folder): text is drawn with a plain "
              "built-in font";
    }
  }
  atlas_->Build();
}

Fonts::~Fonts() = default;

float Fonts::size(Type t) const {
  return font(t)->FontSize;
}

float Fonts::width(Type t, std::string_view text) const {
  return font(t)->CalcTextSizeA(size(t), 1e9F, 0, text.data(), text.data() + text.size()).x;
}

std::string Fonts::fit(Type t, std::string_view text, float max_width) const {
  if (width(t, text) <= max_width) return std::string(text);
  std::string_view head = text;
  while (!head.empty()) {
    head.remove_suffix(1);
    const bool inside_character = (static_cast<unsigned char>(text[head.size()]) & 0xC0U) == 0x80U;
    if (inside_character || (!head.empty() && head.back() == ' ')) continue;
    const std::string candidate = std::string(head) + "…";
    if (width(t, candidate) <= max_width) return head.empty() ? "" : candidate;
  }
  return {};
}

} // namespace flipbook::render::gui
