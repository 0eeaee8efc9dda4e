// SPDX-License-Identifier: MIT
// What was measured, for people, for programs, and against an earlier run.
#pragma once

#include "app/bench/workload.h"

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace flipbook::app {

/// A line of the CSV file: a measurement of a run, with its median and extremes.
struct BenchRow {
  std::string machine, build;
  int threads = 1;
  std::string workload, name, part, quantity, unit;
  int repeats = 0;
  double median = 0, least = 0, most = 0;
};

/// One row for each measurement.
[[nodiscard]] std::vector<BenchRow> rows_of(const CaseResult& result, int threads);
/// The limits of the machine, as the workload "machine".
[[nodiscard]] CaseResult limits_case(const Limits& limits);
/// For every wall time of `one` its ratio to that of `more`: what more threads gain.
[[nodiscard]] CaseResult scaling(const CaseResult& one, const CaseResult& more);

/// A case as a table: a line for each part, a column for each quantity that most parts have, the rest below.
[[nodiscard]] std::string table_of(const CaseResult& result);

[[nodiscard]] std::string to_csv(const std::vector<BenchRow>& rows);
[[nodiscard]] std::string to_json(const std::vector<BenchRow>& rows);
/// Throws UserError with the line for a file that is not one of ours.
[[nodiscard]] std::vector<BenchRow> read_csv_rows(const std::filesystem::path& file);

/// The rows that both have, with the ratio after / before of their medians; those of one alone are counted.
[[nodiscard]] std::string comparison(const std::vector<BenchRow>& before, const std::vector<BenchRow>& after);

} // namespace flipbook::app
