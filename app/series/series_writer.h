// SPDX-License-Identifier: MIT
// Writes the particles of a run as a series (see series.h) while it goes on: the files of a frame at a time, each into
// its place only when the whole series is there.
#pragma once

#include "app/encode/staging.h"
#include "app/series/series.h"
#include "app/session/schedule.h"
#include "app/study/resolve.h"
#include "sim/core/parallel.h"
#include "sim/simulation.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

class SeriesWriter {
public:
  /// Throws MachineError when nothing can be written in `folder`, UserError for more than a series can hold, and
  /// for files in the way that are not those of an earlier series.
  SeriesWriter(std::filesystem::path folder, const Resolved& resolved, std::string study);

  /// The variants at the next frame; `table(i)` gives the particles of one of them. Holds as many tables at a time as
  /// threads work on them.
  void write(const Stop& stop, std::span<const std::shared_ptr<const Snapshot>> variants,
             const std::function<ParticleTable(std::size_t)>& table, Pool& pool);
  /// The last frame was written: adds what describes the series.
  void finish();
  /// Gives all files their names; those of an earlier series in the folder that are not replaced are removed.
  void commit();
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
  void begin(std::span<const std::shared_ptr<const Snapshot>> variants);
  void note(const Snapshot& s, std::size_t variant);
  void note_solids(const Snapshot& s, std::size_t variant);
  void refuse_strangers() const;
  void refuse_strangers(const std::string& variant) const;
  [[nodiscard]] std::string collection(const SeriesVariant& v) const;

  std::filesystem::path folder_;
  const Resolved& resolved_;
  std::string study_;
  Series series_;
  std::set<std::filesystem::path> earlier_;        ///< files of the series that was there
  Staging staging_;                                ///< of the files beside the variants
  Staging index_;                                  ///< the index gets its name last
  std::vector<std::unique_ptr<Staging>> variants_; ///< last: their folders are inside
  std::vector<std::set<std::uint32_t>> surfaces_;  ///< ids of the solids of each variant that have their files
  std::vector<std::vector<Parameter>> last_;       ///< parameters of each variant at the frame before
};

} // namespace flipbook::app
