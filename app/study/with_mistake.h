// SPDX-License-Identifier: MIT
// A study with an exhibit of the bug museum: every pane that the mistake can act in gets a twin beside it that makes
// it. The others stay as they are, to the last bit what they would be without: a twin takes its own steps.
//
// A study as a text cannot say this. What is written of such a run is the study without the twins, below a comment with
// the option that brings them back.
#pragma once

#include "app/study/study.h"
#include "sim/museum/museum.h"

#include <string>

namespace flipbook::app {

/// Throws UserError where no pane has what the mistake needs, or where there would be too many.
[[nodiscard]] Study with_mistake(Study study, const museum::Choice& choice);

/// The comment for the head of the study's text.
[[nodiscard]] std::string mistake_header(const museum::Choice& choice);

} // namespace flipbook::app
