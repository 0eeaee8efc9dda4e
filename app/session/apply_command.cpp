// SPDX-License-Identifier: MIT
#include "app/session/apply_command.h"

#include "sim/frame/errors.h"

#include <algorithm>

namespace flipbook::app {
namespace {

bool uses(const Simulation& s, const std::string& path) {
  const std::vector<Parameter> all = s.parameters();
  return std::any_of(all.begin(), all.end(), [&](const Parameter& p) { return p.path == path && p.applies; });
}

} // namespace

std::vector<int> panes_of(const Command& command, Stepper& variants) {
  if (command.variant >= 0) return {command.variant};
  const auto* change = std::get_if<SetParameter>(&command.action);
  std::vector<int> panes;
  for (std::size_t i = 0; i < variants.size(); ++i)
    if (!change || uses(variants[i], change->path)) panes.push_back(static_cast<int>(i));
  return panes;
}

Refusal apply_command(const Command& command, Stepper& variants) {
  const auto* change = std::get_if<SetParameter>(&command.action);
  const std::vector<int> panes = panes_of(command, variants);
  if (panes.empty()) return {"no pane uses " + change->path + " now", ""};
  for (const int pane : panes) {
    Simulation& s = variants[static_cast<std::size_t>(pane)];
    Refusal r = change ? s.set(change->path, change->value) : s.interact(std::get<Interaction>(command.action));
    if (!r.message.empty()) return r;
  }
  return {};
}

void must_apply(const Command& command, Stepper& variants, const char* who) {
  const Refusal refusal = apply_command(command, variants);
  if (refusal.message.empty()) return;
  const auto* change = std::get_if<SetParameter>(&command.action);
  throw UserError(who + (change ? change->path + ": " : std::string()) + refusal.message, {}, refusal.nearest);
}

} // namespace flipbook::app
