// SPDX-License-Identifier: MIT
// What `solver = "transfer"` means for the settings: nothing flows, so most of what a fluid needs has no use.
#pragma once

#include "sim/frame/forwarding_visitor.h"
#include "sim/scene/settings.h"

namespace flipbook {

/// A setting that contradicts round trips without a flow, or one that is for them alone.
[[nodiscard]] Settings::Conflict round_trip_conflict(const Settings& settings);

/// Under `solver = "transfer"` marks what only a flow has as not applying; otherwise what only round trips have.
class RoundTripFilter final : public ForwardingVisitor {
public:
  RoundTripFilter(ParameterVisitor& to, const Settings& settings)
      : ForwardingVisitor(to), round_trips_(settings.solver == Solver::transfer) {}

private:
  bool change(const std::string& path, Spec& spec) override;
  bool round_trips_;
};

} // namespace flipbook
