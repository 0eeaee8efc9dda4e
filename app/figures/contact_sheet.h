// SPDX-License-Identifier: MIT
// All figures on one picture, small, in rows: what there is to choose from.
#pragma once

#include "app/figures/page.h"

#include <vector>

namespace flipbook::app {

class ContactSheet {
public:
  /// Draws it without its caption, as wide as a text.
  void add(const FigureSpec& spec, const FigureBody& body, ParticlePictures& pictures);
  [[nodiscard]] render::Image image() const;

private:
  struct Entry {
    std::string name;
    render::Image picture;
  };
  std::vector<Entry> entries_;
};

} // namespace flipbook::app
