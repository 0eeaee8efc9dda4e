// SPDX-License-Identifier: MIT
#include "render/compose/titles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace flipbook::render {
namespace {

using Parts = std::vector<std::string>;

Parts split(const std::string& title) {
  Parts parts;
  for (std::size_t at = 0;;) {
    const std::size_t comma = title.find(", ", at);
    parts.push_back(title.substr(at, comma - at));
    if (comma == std::string::npos) return parts;
    at = comma + 2;
  }
}

std::string join(const Parts& parts) {
  std::string title;
  for (const std::string& p : parts) title += (title.empty() ? "" : ", ") + p;
  return title;
}

bool has(const Parts& parts, const std::string& part) {
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

/// Without the parts that all have; a title that would be left empty keeps what it has.
std::vector<Parts> without_shared(const std::vector<Parts>& titles) {
  std::vector<Parts> out = titles;
  for (Parts& parts : out) {
    std::erase_if(parts, [&](const std::string& part) {
      return std::all_of(titles.begin(), titles.end(), [&](const Parts& t) { return has(t, part); });
    });
  }
  const bool some_left = std::none_of(out.begin(), out.end(), [](const Parts& p) { return p.empty(); });
  return some_left ? out : titles;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr std::string_view ellipsis = "…";

/// How far a part may be cut: at first only words without digits, since numbers are what differs most often.
struct Limit {
  std::size_t letters; ///< that stay of a part without digits
  bool words, digits;  ///< whether the words before a number, and numbers, may be cut
};
constexpr std::array<Limit, 4> limits{{{3, false, false}, {1, false, false}, {1, true, false}, {1, true, true}}};

/// One character less before the ellipsis; false: no more can go.
bool shorten(std::string& part, const Limit& limit) {
  const bool number = std::any_of(part.begin(), part.end(), is_digit);
  if (number && !limit.words) return false;
  std::size_t tail = part.size(); // what stays behind the ellipsis begins here
  if (const std::size_t space = part.rfind(' '); number && !limit.digits)
    tail = space == std::string::npos                                                ? 0
           : std::any_of(part.begin() + std::ptrdiff_t(space), part.end(), is_digit) ? space + 1
                                                                                     : tail;
  const std::size_t old = part.find(ellipsis), end = old == std::string::npos ? tail : old + ellipsis.size();
  std::size_t cut = std::min(old, tail);
  const auto goes_too = [&](std::size_t i) {
    return part[i] == ' ' || (static_cast<unsigned char>(part[i]) & 0xC0U) == 0x80U;
  };
  // The first ellipsis takes the place of two characters, or nothing would be won.
  for (int n = old == std::string::npos ? 2 : 1; n > 0 && cut > 0; --n) {
    --cut;
    while (cut > 0 && goes_too(cut)) --cut;
  }
  while (cut > 0 && part[cut - 1] == ' ') --cut;
  if (cut < (number ? 1 : limit.letters)) return false;
  part.replace(cut, end - cut, ellipsis);
  return true;
}

/// Cuts the widest part until the title fits, or nothing more can go.
std::string shortened(const gui::Fonts& fonts, gui::Type type, Parts parts, float width) {
  for (const Limit& limit : limits)
    for (bool more = true; more;) {
      std::string title = join(parts);
      if (fonts.width(type, title) <= width) return title;
      more = false;
      std::vector<std::string*> widest;
      for (std::string& p : parts) widest.push_back(&p);
      std::stable_sort(widest.begin(), widest.end(),
                       [&](auto* a, auto* b) { return fonts.width(type, *a) > fonts.width(type, *b); });
      for (std::string* p : widest)
        if ((more = shorten(*p, limit))) break;
    }
  return fonts.fit(type, join(parts), width);
}

} // namespace

std::vector<std::string> without_shared_parts(const std::vector<std::string>& titles) {
  std::vector<Parts> parts;
  for (const std::string& t : titles) parts.push_back(split(t));
  if (titles.size() > 1) parts = without_shared(parts);
  std::vector<std::string> out;
  for (const Parts& p : parts) out.push_back(join(p));
  return out;
}

FittedTitles fit_titles(const gui::Fonts& fonts, gui::Type wanted, std::vector<std::string> titles,
                        std::span<const float> widths) {
  const auto all_fit = [&](gui::Type type, const std::vector<std::string>& text) {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (fonts.width(type, text[i]) > widths[i]) return false;
    return true;
  };
  for (const gui::Type type : {wanted, gui::Type::small})
    if (all_fit(type, titles)) return {type, std::move(titles)};
  titles = without_shared_parts(titles);
  for (const gui::Type type : {wanted, gui::Type::small})
    if (all_fit(type, titles)) return {type, std::move(titles)};
  for (std::size_t i = 0; i < titles.size(); ++i)
    titles[i] = shortened(fonts, gui::Type::small, split(titles[i]), widths[i]);
  return {gui::Type::small, std::move(titles)};
}

} // namespace flipbook::render
