// SPDX-License-Identifier: MIT
// A validation case: a flow whose exact solution or experiment is known, run for schemes, resolutions and seeds, and
// what was measured of it beside what should have come out.
#pragma once

#include "app/validate/statistics.h"
#include "render/chart/chart.h"
#include "sim/core/parallel.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

/// What the user wants of a case. What is empty is the case's own choice.
struct ValidationRequest {
  std::vector<std::string> schemes; ///< "flip:0.99"
  std::vector<int> cells;           ///< along x, ascending
  int seeds = 5;
  bool fast = false; ///< few cells and a short time, for tests and for a first look
};

/// Bounds that a correct solver keeps; every seed must.
struct Gate {
  double lo, hi;
};

/// One measured number.
struct ValidationRow {
  std::string scheme;  ///< its title: "FLIP 0.99"
  std::string setting; ///< what else was chosen: "quadratic kernel"; may be empty
  int cells = 0;       ///< along x; 0: from several resolutions
  double cfl = 0;      ///< 0: from several, or bounded otherwise
  std::string quantity, unit;
  Spread value; ///< over the seeds
  std::optional<double> reference;
  std::optional<Gate> gate;

  [[nodiscard]] bool passed() const { return !gate || (value.min >= gate->lo && value.max <= gate->hi); }
};

struct ValidationReport {
  std::string ran; ///< what was run, in sentences
  std::vector<ValidationRow> rows;
  render::Chart chart;
  /// The row to complete.
  ValidationRow& add(ValidationRow row) { return rows.emplace_back(std::move(row)); }
};

/// What a case computes with.
struct Lab {
  Pool& pool;
  std::function<void(std::size_t done, std::size_t of)> progress = [](std::size_t, std::size_t) {};
};

class ValidationCase {
public:
  virtual ~ValidationCase() = default;
  [[nodiscard]] virtual std::string name() const = 0;       ///< of files and on the command line
  [[nodiscard]] virtual std::string statement() const = 0;  ///< one sentence: what is exact, what is measured
  [[nodiscard]] virtual std::string references() const = 0; ///< where the set-up or the data are from
  [[nodiscard]] virtual ValidationReport run(const ValidationRequest& request, const Lab& lab) const = 0;
};

/// All cases, in the order in which they run.
[[nodiscard]] std::span<const std::unique_ptr<ValidationCase>> validation_cases();

} // namespace flipbook::app
