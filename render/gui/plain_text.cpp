// SPDX-License-Identifier: MIT
#include "render/gui/plain_text.h"

#include <array>
#include <cstdint>
#include <optional>

namespace flipbook::render::gui {
namespace {

struct Spelling {
  char32_t code;
  const char* text;
};

constexpr std::array spellings{
    Spelling{U'−', "-"},      Spelling{U'–', "-"},       Spelling{U'—', "-"},      Spelling{U'…', "..."},
    Spelling{U'·', "."},      Spelling{U'×', "x"},       Spelling{U'≤', "<="},     Spelling{U'≥', ">="},
    Spelling{U'≈', "~"},      Spelling{U'±', "+-"},      Spelling{U'√', "sqrt "},  Spelling{U'∂', "d"},
    Spelling{U'∇', "grad "},  Spelling{U'∞', "inf"},     Spelling{U'→', "->"},     Spelling{U'←', "<-"},
    Spelling{U'°', " deg"},   Spelling{U'µ', "u"},       Spelling{U'’', "'"},      Spelling{U'‘', "'"},
    Spelling{U'“', "\""},     Spelling{U'”', "\""},      Spelling{U'✓', "yes"},    Spelling{U'✗', "no"},
    Spelling{U'Δ', "d"},      Spelling{U'α', "alpha"},   Spelling{U'β', "beta"},   Spelling{U'γ', "gamma"},
    Spelling{U'δ', "delta"},  Spelling{U'ε', "epsilon"}, Spelling{U'ζ', "zeta"},   Spelling{U'η', "eta"},
    Spelling{U'θ', "theta"},  Spelling{U'κ', "kappa"},   Spelling{U'λ', "lambda"}, Spelling{U'μ', "mu"},
    Spelling{U'ν', "nu"},     Spelling{U'ξ', "xi"},      Spelling{U'π', "pi"},     Spelling{U'ρ', "rho"},
    Spelling{U'σ', "sigma"},  Spelling{U'τ', "tau"},     Spelling{U'φ', "phi"},    Spelling{U'χ', "chi"},
    Spelling{U'ψ', "psi"},    Spelling{U'ω', "omega"},   Spelling{U'Γ', "Gamma"},  Spelling{U'Θ', "Theta"},
    Spelling{U'Λ', "Lambda"}, Spelling{U'Π', "Pi"},      Spelling{U'Σ', "sum "},   Spelling{U'Φ', "Phi"},
    Spelling{U'Ψ', "Psi"},    Spelling{U'Ω', "Omega"},
};

constexpr std::u32string_view raised = U"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", lowered = U"₀₁₂₃₄₅₆₇₈₉₊₋";
constexpr std::string_view digits = "0123456789+-";

/// The code point at p, which moves behind it; nothing where the bytes are none.
std::optional<char32_t> next_code(std::string_view text, std::size_t& p) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0U; };
  const std::uint32_t first = byte(p);
  const std::size_t more = first < 0x80 ? 0 : first >> 5U == 6 ? 1 : first >> 4U == 14 ? 2 : first >> 3U == 30 ? 3 : 4;
  char32_t code = more == 0 ? first : first & (0x3FU >> more);
  ++p;
  if (more == 4) return std::nullopt;
  for (std::size_t i = 0; i < more; ++i, ++p) {
    if (byte(p) >> 6U != 2) return std::nullopt;
    code = code << 6U | (byte(p) & 0x3FU);
  }
  return code;
}

} // namespace

std::string plain_text(std::string_view utf8, const std::function<bool(char32_t)>& has) {
  std::string out;
  char level = 0; // '^' or '_' while digits are raised or lowered
  for (std::size_t p = 0; p < utf8.size();) {
    const std::size_t begin = p;
    const auto code = next_code(utf8, p);
    const std::size_t up = code ? raised.find(*code) : raised.npos, down = code ? lowered.find(*code) : lowered.npos;
    if (up != raised.npos || down != lowered.npos) {
      const char here = up != raised.npos ? '^' : '_';
      if (level != here) out += here;
      level = here;
      out += digits[up != raised.npos ? up : down];
      continue;
    }
    level = 0;
    if (code && has(*code)) {
      out += utf8.substr(begin, p - begin);
      continue;
    }
    if (code == U'∇' && utf8.substr(p).starts_with("·")) { // a divergence
      out += "div ";
      p += std::string_view("·").size();
      continue;
    }
    const char* text = "?";
    for (const Spelling& s : spellings)
      if (code == s.code) text = s.text;
    out += text;
  }
  return out;
}

} // namespace flipbook::render::gui
