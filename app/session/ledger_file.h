// SPDX-License-Identifier: MIT
// The ledgers of a run as one long table, with one line of headings:
//
//   variant,frame,substep,t (s),stage,mass (kg/m),momentum_x (kg m/s/m),...,potential (J/m)
//   APIC,1,4,0.033333333333333333,particles,320,...
//   APIC,1,4,0.033333333333333333,p2g,0,...
//
// A row of the stage "particles" holds what the particles hold at t, each row below it what the stage changed of it
// since the row of particles before: held now = held before + the sum of the stages. With ledger.rows = "step" there is
// such a group for every step. `substep` counts the steps within their frame, up to the one at whose end the row
// stands. Numbers have 17 digits; one that means nothing (angular momentum with a periodic axis), or that the variant
// does not have, is left out. Units stand in the headings; in 2D everything is per metre of depth. Round trips have "t
// (trips)".
#pragma once

#include "app/encode/staging.h"
#include "app/session/schedule.h"
#include "app/study/resolve.h"
#include "sim/frame/snapshot.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

class LedgerFile {
public:
  /// Throws UserError for a name that does not end in .csv, for variants without a ledger, and for a file in the way
  /// that is no such table; MachineError when nothing can be written there. `said` names the option or key in messages.
  LedgerFile(std::filesystem::path file, const std::string& said, const Resolved& resolved);

  /// The accounts of all variants since the stop before. Throws MachineError (full disk).
  void write(const Stop& stop, std::span<const std::shared_ptr<const Snapshot>> variants);
  /// Gives the file its name, replacing an earlier table.
  void commit() { staging_.commit(); }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

private:
  void begin(std::span<const std::shared_ptr<const Snapshot>> variants);
  [[nodiscard]] const LedgerTable& table(const Snapshot& s, std::size_t variant) const;

  std::filesystem::path file_;
  std::string said_;
  const Resolved& resolved_;
  Staging staging_;
  std::vector<std::string> titles_;  ///< of the variants when the run began, quoted
  std::vector<std::string> columns_; ///< names of the quantities of any variant
  std::vector<std::uint64_t> steps_; ///< of each variant at the stop before
};

} // namespace flipbook::app
