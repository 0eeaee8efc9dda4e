// SPDX-License-Identifier: MIT
#include "app/bench/measurement.h"

#include <algorithm>

namespace flipbook::app {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

void CaseResult::add(const std::string& part, const std::string& quantity, const std::string& unit, double value) {
  const auto at = std::find_if(measurements.begin(), measurements.end(),
                               [&](const Measurement& m) { return m.part == part && m.quantity == quantity; });
  if (at == measurements.end())
    measurements.push_back({part, quantity, unit, {value}});
  else
    at->values.push_back(value);
}

const Measurement* CaseResult::find(const std::string& part, const std::string& quantity) const {
  for (const Measurement& m : measurements)
    if (m.part == part && m.quantity == quantity) return &m;
  return nullptr;
}

} // namespace flipbook::app
