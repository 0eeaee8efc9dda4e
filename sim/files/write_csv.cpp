// SPDX-License-Identifier: MIT
#include "sim/files/particle_writers.h"

#include <algorithm>
#include <charconv>

namespace flipbook {
namespace {

constexpr std::size_t longest_id = 10, longest_number = 24; // characters: 4294967295, -2.2250738585072014e-308

template <class T> char* write(char* p, T x) {
  return std::to_chars(p, p + longest_number, x).ptr;
}

} // namespace

std::string write_csv(const ParticleTable& table) {
  std::string text = "id";
  for (const ParticleTable::Column& c : table.columns) text.append(",").append(c.name);
  text += '\n';
  const std::size_t rows = table.id.size();
  const std::size_t longest_row = longest_id + table.columns.size() * (1 + longest_number) + 1;
  constexpr std::size_t block = 1024; // rows, so that little room is left over
  for (std::size_t first = 0; first < rows; first += block) {
    const std::size_t last = std::min(first + block, rows), begin = text.size();
    text.resize(begin + (last - first) * longest_row);
    char* p = text.data() + begin;
    for (std::size_t r = first; r < last; ++r) {
      p = write(p, table.id[r]);
      for (const ParticleTable::Column& c : table.columns) {
        *p++ = ',';
        p = table.is_single(c) ? write(p, static_cast<float>(c.values[r])) : write(p, c.values[r]);
      }
      *p++ = '\n';
    }
    text.resize(static_cast<std::size_t>(p - text.data()));
  }
  return text;
}

} // namespace flipbook
