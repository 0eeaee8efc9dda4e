// SPDX-License-Identifier: MIT
// What a benchmark finds out: numbers with names, one value for each repeat. README.md in this folder says what each
// number means.
#pragma once

#include <string>
#include <vector>

namespace flipbook::app {

struct Measurement {
  std::string part, quantity, unit; ///< "P2G", "wall", "ms/step"
  std::vector<double> values;       ///< one for each repeat, in their order
};

/// Half of the values lie below it.
[[nodiscard]] double median(std::vector<double> values);

/// One case of a workload.
struct CaseResult {
  std::string workload, name; ///< "W3-64", "APIC linear single"
  std::string about;          ///< its size: "671,046 particles, 64x64x64 cells, 11 steps"
  std::vector<Measurement> measurements;

  /// Adds the value of one more repeat.
  void add(const std::string& part, const std::string& quantity, const std::string& unit, double value);
  /// Null where it was not measured.
  [[nodiscard]] const Measurement* find(const std::string& part, const std::string& quantity) const;
};

} // namespace flipbook::app
