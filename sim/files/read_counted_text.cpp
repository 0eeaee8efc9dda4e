// SPDX-License-Identifier: MIT
#include "sim/files/numbers.h"
#include "sim/files/particle_formats.h"
#include "sim/files/row_store.h"

namespace flipbook {
namespace {

std::uint64_t read_count(ByteSource& file, const RowStore& rows) {
  std::string_view line;
  if (!file.content_line(line)) file.refuse("the file is empty");
  line = trimmed(line);
  std::uint64_t count = 0;
  const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), count);
  const std::string_view rest = trimmed(line.substr(static_cast<std::size_t>(stop - line.data())));
  if (error == std::errc::invalid_argument || (!rest.empty() && rest.front() != '#'))
    file.refuse("the first line must be the number of particles, or name the columns, not " + shown(line));
  if (error != std::errc()) file.refuse(shown(line) + " particles are promised, which no file can hold");
  constexpr std::uint64_t shortest = 4; // "0 0\n"
  rows.promised(count, shortest);
  return count;
}

/// The numbers of a line; more than six count as seven.
std::size_t read_row(std::string_view line, std::array<double, 7>& numbers, const ByteSource& file) {
  const char *p = line.data(), *end = p + line.size();
  std::size_t count = 0;
  while (count < numbers.size() && next_number(p, end, numbers[count], true, file)) ++count;
  return count;
}

/// x y, x y z, x y vx vy or x y z vx vy vz, by how many there are.
Row arranged(const std::array<double, 7>& n, std::size_t columns) {
  switch (columns) {
  case 2: return {n[0], n[1], 0, 0, 0, 0};
  case 3: return {n[0], n[1], n[2], 0, 0, 0};
  case 4: return {n[0], n[1], 0, n[2], n[3], 0};
  default: return {n[0], n[1], n[2], n[3], n[4], n[5]};
  }
}

std::string counted(std::size_t n) {
  return (n == 7 ? "more than 6" : std::to_string(n)) + (n == 1 ? " number" : " numbers");
}

} // namespace

ParticleRows read_counted_text(ByteSource& file) {
  RowStore rows(file);
  const std::uint64_t count = read_count(file, rows);
  const std::string promise = std::to_string(count) + (count == 1 ? " particle" : " particles");
  std::string_view line;
  std::array<double, 7> numbers{};
  std::size_t columns = 0;
  while (file.content_line(line)) {
    if (rows.size() == count) file.refuse("a row after the " + promise + " that the first line promises");
    const std::size_t n = read_row(line, numbers, file);
    if (columns == 0) {
      if (n < 2 || n == 5 || n > 6)
        file.refuse(counted(n) + " in a row; it is x y, x y z, x y vx vy or x y z vx vy vz");
      columns = n;
      rows.reserve(std::min(count, file.left() / (2 * n) + 1));
    }
    if (n != columns) file.refuse(counted(n) + " in a row, and " + std::to_string(columns) + " in the first");
    rows.add(arranged(numbers, columns));
  }
  if (rows.size() < count)
    file.refuse("the file ends after " + std::to_string(rows.size()) + " of the " + promise +
                " that the first line promises");
  return rows.take(columns == 2 || columns == 4);
}

} // namespace flipbook
