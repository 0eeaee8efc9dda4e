// SPDX-License-Identifier: MIT
#include "render/chart/text_check.h"

namespace flipbook::render {

std::vector<std::string> text_conflicts(std::span<const TextBox> texts, const Rect& frame) {
  constexpr float touch = 0.5F;
  std::vector<std::string> found;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Rect& a = texts[i].box;
    if (a.x < frame.x - touch || a.y < frame.y - touch || a.right() > frame.right() + touch ||
        a.bottom() > frame.bottom() + touch)
      found.push_back("\"" + texts[i].text + "\" leaves the frame");
    for (std::size_t j = 0; j < i; ++j)
      if (a.inset(touch).overlaps(texts[j].box.inset(touch)))
        found.push_back("\"" + texts[i].text + "\" covers \"" + texts[j].text + "\"");
  }
  return found;
}

} // namespace flipbook::render
