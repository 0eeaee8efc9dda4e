// SPDX-License-Identifier: MIT
#include "app/study/with_mistake.h"

#include "app/study/resolve.h"
#include "sim/frame/errors.h"

#include <algorithm>

namespace flipbook::app {
namespace {

/// The first candidate that can act in some pane.
std::size_t settle(const museum::Choice& choice, const Resolved& resolved) {
  for (const std::size_t exhibit : choice.candidates)
    for (const ResolvedVariant& v : resolved.variants)
      if (museum::needs(exhibit, v.scene.settings).empty()) return exhibit;
  throw UserError("--with-mistake " + choice.option() + " needs " +
                  museum::needs(choice.candidates.front(), resolved.variants.front().scene.settings));
}

Variant twin_of(Variant v, const museum::Hung& hung) {
  if (!v.label.empty()) v.label += ", " + hung.label;
  v.mistake = hung;
  return v;
}

} // namespace

Study with_mistake(Study study, const museum::Choice& choice) {
  pin_keys(study);
  const Resolved resolved = resolve_unarranged(study);
  const museum::Hung hung = museum::hang(choice, settle(choice, resolved));
  std::vector<Variant> panes;
  std::vector<std::vector<int>> became; // numbers, from 1, of each pane and its twin
  for (std::size_t i = 0; i < study.variants.size(); ++i) {
    const Variant& v = study.variants[i];
    panes.push_back(v);
    became.push_back({static_cast<int>(panes.size())});
    if (!museum::needs(hung.exhibit, resolved.variants[i].scene.settings).empty()) continue;
    panes.push_back(twin_of(v, hung));
    became.back().push_back(static_cast<int>(panes.size()));
  }
  if (resolved.view.is_sheet())
    throw UserError("--with-mistake: the rows and columns of a sheet have no place for mistaken panes");
  if (panes.size() > render::most_panes)
    throw UserError("--with-mistake: " + std::to_string(panes.size()) + " panes with the mistaken ones; a frame has " +
                    "at most " + std::to_string(render::most_panes));
  study.variants = std::move(panes);
  for (Key& key : study.keys) {
    std::vector<int> numbers;
    for (const int pane : key.panes)
      for (const int n : became[static_cast<std::size_t>(pane - 1)]) numbers.push_back(n);
    key.panes = std::move(numbers);
  }
  const std::string suffix = choice.mystery_n > 0 ? choice.label() : "with a mistake";
  study.title = resolved.title + (resolved.title.empty() ? "" : ", ") + suffix;
  study.name += choice.mystery_n > 0 ? "_mystery" : "_mistake";
  return study;
}

std::string mistake_header(const museum::Choice& choice) {
  const std::string option = "--with-mistake " + choice.option();
  return "# NOT A NORMAL RUN: it was made with " + option + ", a mistake on purpose,\n" +
         "# which a study cannot say. This text alone runs right; for the same again: flipbook render FILE " + option +
         "\n";
}

} // namespace flipbook::app
