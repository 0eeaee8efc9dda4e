// SPDX-License-Identifier: MIT
// What the readers of particles share: the six numbers of a row, the names that columns have for them, and the rows
// that were read so far.
#pragma once

#include "sim/files/byte_source.h"
#include "sim/files/particle_rows.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace flipbook {

using Row = std::array<double, 7>; ///< x y z vx vy vz, and the id

inline constexpr std::uint64_t most_rows = 1ULL << 28U; // as many as a simulation may have

/// Which column holds which number of a row; -1: none.
struct RowColumns {
  std::array<int, 7> at{-1, -1, -1, -1, -1, -1, -1};

  [[nodiscard]] bool planar() const { return at[2] < 0; }
  [[nodiscard]] bool ids() const { return at[6] >= 0; }
  /// The other way round, of so many columns: which number of a row each holds; -1: none.
  [[nodiscard]] std::vector<int> slots(std::size_t count) const;
};

/// Finds them by name, in any case and order. `u v w` mean a velocity only where `letters` says so and no other column
/// is one, and `id` only where `ids` does. Refuses two columns for one number, and a missing x or y; `what` names the
/// list of columns in messages.
[[nodiscard]] RowColumns find_columns(const std::vector<std::string>& names, bool letters, bool ids,
                                      const std::string& what, const ByteSource& file);

class RowStore {
public:
  explicit RowStore(const ByteSource& file) : file_(file) {}

  /// Refuses what the file says about the number of its rows if what is left of it cannot hold them, of `bytes` each,
  /// or if they are too many.
  void promised(std::uint64_t rows, std::uint64_t bytes) const;
  void keep_ids() { ids_ = true; } ///< called before the first row
  void reserve(std::uint64_t rows);
  /// Refuses numbers that are not finite, an id that is none, and a row too many.
  void add(const Row& row);
  [[nodiscard]] std::uint64_t size() const { return rows_.x.size(); }
  /// Refuses a file without a row.
  [[nodiscard]] ParticleRows take(bool planar);

private:
  void add_id(double id);

  const ByteSource& file_;
  ParticleRows rows_;
  bool ids_ = false;
};

} // namespace flipbook
