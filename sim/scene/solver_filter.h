// SPDX-License-Identifier: MIT
// What each value of `solver` means for the settings: most parameters belong to some of the solvers only.
#pragma once

#include "sim/frame/forwarding_visitor.h"
#include "sim/scene/settings.h"

namespace flipbook {

/// A setting that contradicts the chosen solver, or one that is for another one alone.
[[nodiscard]] Settings::Conflict solver_conflict(const Settings& settings);

/// Marks what the chosen solver does not have as not applying.
class SolverFilter final : public ForwardingVisitor {
public:
  SolverFilter(ParameterVisitor& to, const Settings& settings) : ForwardingVisitor(to), solver_(settings.solver) {}

private:
  bool change(const std::string& path, Spec& spec) override;
  Solver solver_;
};

} // namespace flipbook
