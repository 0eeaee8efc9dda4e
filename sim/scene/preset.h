// SPDX-License-Identifier: MIT
// What `preset = "tutorial"` means for the settings: which of them the fluid notes' program has, and which it has built
// in.
#pragma once

#include "sim/frame/forwarding_visitor.h"
#include "sim/scene/settings.h"

namespace flipbook {

/// Gravity in the fluid notes' program (m/s^2).
inline constexpr std::array<double, 3> notes_gravity{0, 0, -9.80665};

/// Does the fluid notes' own algorithm run these settings? Under its preset it does for the schemes that the notes
/// have, PIC and FLIP; any other runs on Flipbook's method.
[[nodiscard]] bool runs_notes(const Settings& settings);

/// What stands above a pane that runs these settings: "FLIP 0.95", "APIC (not in the notes)".
[[nodiscard]] std::string title_of(const Settings& settings);

/// A setting that contradicts what the preset has built in.
[[nodiscard]] Settings::Conflict preset_conflict(const Settings& settings);

/// Where the fluid notes' algorithm runs, marks what has no use there as not applying, and all but flip_ratio as fixed
/// for the run.
class PresetFilter final : public ForwardingVisitor {
public:
  PresetFilter(ParameterVisitor& to, const Settings& settings);

private:
  bool change(const std::string& path, Spec& spec) override;
  bool preset_, notes_;
};

/// Steps of length dt from one frame to the next, `interval` seconds apart if frames were not bound to steps: the first
/// n with (interval - 0.0001) - n dt < 0, the notes' rule, which has 1/30 s there.
[[nodiscard]] double notes_steps_per_frame(double interval, double dt);

} // namespace flipbook
