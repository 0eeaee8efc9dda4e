// SPDX-License-Identifier: MIT
// The bug museum: runs one classic mistake on purpose, so that a class sees which line of the ledger turns red. Nothing
// but the option --with-mistake leads here: no parameter, no scene and no study can ask for it.
//
// The mistakes themselves are in mistakes.cpp. A run with one says so in its title, its notes and its watermark. It
// does not disturb the runs beside it: it has no say in how long their common steps are, divides those that are too
// long for it, and where it flies apart it stands still from there on.
#pragma once

#include "sim/scene/scene.h"
#include "sim/simulation.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook::museum {

/// One mistake, for people. An index into exhibits() names it.
struct Exhibit {
  std::string_view name;  ///< as in the option: "reversed_offset"
  std::string_view label; ///< as in pictures: "reversed offset"
  std::string_view wrong; ///< what the program does, in one sentence
  std::string_view shows; ///< where the ledger or the curves show it
  bool anywhere = false;  ///< it can act whatever the scheme, the kernel and the walls
};
[[nodiscard]] const std::vector<Exhibit>& exhibits();

/// Empty where the mistake can act in a run with these settings; else what it needs: "a scheme with a share of FLIP".
[[nodiscard]] std::string needs(std::size_t exhibit, const Settings& settings);

/// What --with-mistake asked for: an exhibit, or a number that stands for one which is not told.
struct Choice {
  std::vector<std::size_t> candidates;      ///< indices; the first that can act does
  int mystery_n = 0;                        ///< N of mystery:N; 0: the exhibit is named
  [[nodiscard]] std::string option() const; ///< as it was written: "mystery:3"
  [[nodiscard]] std::string label() const;  ///< "mistake", "mystery 3"
};
/// Reads "reversed_offset" or "mystery:3". Throws UserError with the nearest name.
[[nodiscard]] Choice parse_choice(std::string_view text);
/// All exhibits, in the order that N gives them.
[[nodiscard]] std::vector<std::size_t> mystery_order(int n);

/// A choice settled: which exhibit hangs in a pane, and what is said about it.
struct Hung {
  std::size_t exhibit = 0;
  std::string label;     ///< of the choice: joins the title
  std::string watermark; ///< "WITH A MISTAKE: reversed offset"
  std::string note;      ///< a sentence for the foot of the picture
};
[[nodiscard]] Hung hang(const Choice& choice, std::size_t exhibit);

/// make_simulation, with the mistake. Throws UserError where it cannot act.
[[nodiscard]] std::unique_ptr<Simulation> make_mistaken(const Scene& scene, const Hung& hung, Pool& pool);

} // namespace flipbook::museum
