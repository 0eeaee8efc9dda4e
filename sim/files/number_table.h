// SPDX-License-Identifier: MIT
// A small table of numbers from a CSV file: a line of names, then rows; comments begin with #. Measured data of others
// comes so.
#pragma once

#include <string>
#include <vector>

namespace flipbook {

struct NumberTable {
  static constexpr std::size_t most_columns = 64, most_rows = 10000;
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns; ///< one for each name, all of one length
};

/// Throws UserError with file and line where it is damaged, has no row, or is larger than that.
[[nodiscard]] NumberTable read_number_table(const std::string& path);

} // namespace flipbook
