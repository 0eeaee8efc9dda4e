// SPDX-License-Identifier: MIT
#include "sim/files/numbers.h"
#include "sim/files/particle_formats.h"
#include "sim/files/ply_header.h"
#include "sim/files/row_store.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipbook {
namespace {

/// The rows of one element. The vertices go to a store; all others are passed over.
class ElementReader {
public:
  ElementReader(ByteSource& file, const PlyElement& element, const PlyHeader& header, RowStore* store, bool ids)
      : file_(file), element_(element), store_(store), ascii_(header.ascii()), swap_(header.swapped()) {
    if (store) find_slots(ids);
  }

  void read() {
    if (element_.properties.empty()) return; // there is nothing in its rows
    if (store_) store_->promised(element_.rows, element_.least_bytes(ascii_));
    check_ply_rows(element_, ascii_, file_);
    if (store_) store_->reserve(element_.rows);
    if (ascii_)
      read_lines();
    else if (element_.has_lists())
      read_rows_with_lists();
    else if (store_)
      read_blocks();
    else
      pass(element_.rows, element_.least_bytes(false), 0);
  }

  [[nodiscard]] bool planar() const { return columns_.planar(); }

private:
  void find_slots(bool ids) {
    std::vector<std::string> names;
    for (const PlyProperty& p : element_.properties) names.push_back(p.count ? "" : p.name); // a list is no coordinate
    columns_ = find_columns(names, false, ids, "the element \"vertex\"", file_);
    if (columns_.ids()) store_->keep_ids();
    slot_ = columns_.slots(names.size());
  }

  [[nodiscard]] int slot(std::size_t property) const { return store_ ? slot_[property] : -1; }

  /// n items of so many bytes.
  void pass(std::uint64_t n, std::uint64_t bytes, std::uint64_t row) {
    if (n > file_.left() / bytes || !file_.skip(n * bytes)) refuse_ply_end(element_, row, file_);
  }

  void read_blocks() {
    const auto size = static_cast<std::size_t>(element_.least_bytes(false));
    std::vector<std::pair<std::size_t, PlyType>> wanted; // offset and type
    std::vector<std::size_t> to;
    for (std::size_t p = 0, offset = 0; p < element_.properties.size(); ++p) {
      const PlyType type = element_.properties[p].type;
      if (slot(p) >= 0) wanted.emplace_back(offset, type), to.push_back(static_cast<std::size_t>(slot(p)));
      offset += bytes_of(type);
    }
    const std::uint64_t in_block = ByteSource::block / size;
    Row row{};
    for (std::uint64_t done = 0; done < element_.rows;) {
      const std::uint64_t n = std::min(in_block, element_.rows - done);
      const std::string_view bytes = file_.take(static_cast<std::size_t>(n) * size);
      for (std::size_t at = 0; at + size <= bytes.size(); at += size, ++done) {
        for (std::size_t i = 0; i < to.size(); ++i)
          row[to[i]] = ply_number(bytes.data() + at + wanted[i].first, wanted[i].second, swap_);
        store_->add(row);
      }
      if (bytes.size() < n * size) refuse_ply_end(element_, done, file_);
    }
  }

  double next(PlyType type, std::uint64_t row) {
    const std::string_view bytes = file_.take(bytes_of(type));
    if (bytes.size() < bytes_of(type)) refuse_ply_end(element_, row, file_);
    return ply_number(bytes.data(), type, swap_);
  }

  void read_rows_with_lists() {
    Row row{};
    for (std::uint64_t r = 0; r < element_.rows; ++r) {
      for (std::size_t p = 0; p < element_.properties.size(); ++p) {
        const PlyProperty& property = element_.properties[p];
        const double value = next(property.count.value_or(property.type), r);
        if (property.count) {
          if (value < 0)
            file_.refuse("a list of negative length in row " + std::to_string(r + 1) + " of " + shown(element_.name));
          pass(static_cast<std::uint64_t>(value), bytes_of(property.type), r);
        } else if (slot(p) >= 0) {
          row[static_cast<std::size_t>(slot(p))] = value;
        }
      }
      if (store_) store_->add(row);
    }
  }

  // === In ascii a row is a line.
  void read_lines() {
    Row row{};
    for (std::uint64_t r = 0; r < element_.rows; ++r) {
      read_line(next_ply_row(file_, element_, r), row);
      if (store_) store_->add(row);
    }
  }

  void read_line(std::string_view line, Row& row) {
    const char *p = line.data(), *end = p + line.size();
    for (std::size_t i = 0; i < element_.properties.size(); ++i) {
      const PlyProperty& property = element_.properties[i];
      const double value = next(p, end);
      if (property.count) {
        if (!(value >= 0 && value <= static_cast<double>(line.size()) && value == std::floor(value)))
          file_.refuse("a list of impossible length");
        for (auto n = static_cast<std::size_t>(value); n > 0; --n) (void)next(p, end);
      } else if (slot(i) >= 0) {
        row[static_cast<std::size_t>(slot(i))] = value;
      }
    }
    if (!trimmed({p, static_cast<std::size_t>(end - p)}).empty())
      file_.refuse("more numbers in a row than the element " + shown(element_.name) + " has properties");
  }

  double next(const char*& p, const char* end) const {
    double value = 0;
    if (!next_number(p, end, value, false, file_))
      file_.refuse("fewer numbers in a row than the element " + shown(element_.name) + " has properties");
    return value;
  }

  ByteSource& file_;
  const PlyElement& element_;
  RowStore* store_;
  bool ascii_, swap_;
  RowColumns columns_;
  std::vector<int> slot_; ///< of each property: which number of a row it is; -1: none
};

/// Nothing may follow the last row but, in a text, blank lines.
void refuse_more(ByteSource& file, bool ascii) {
  std::string_view line;
  while (ascii && file.line(line))
    if (!trimmed(line).empty()) file.refuse("the file goes on after the last row of its last element");
  if (!file.peek(1).empty())
    file.refuse("the file goes on for " + std::to_string(file.left()) +
                " bytes after the last row of its last element");
}

} // namespace

ParticleRows read_ply(ByteSource& file, bool ids) {
  const PlyHeader header = read_ply_header(file);
  const auto vertices = [](const PlyElement& e) { return e.name == "vertex"; };
  const auto n = std::count_if(header.elements.begin(), header.elements.end(), vertices);
  if (n != 1) file.refuse(n == 0 ? "there is no element \"vertex\"" : "there are two elements \"vertex\"");
  if (!header.ascii()) file.leave_text();
  RowStore rows(file);
  bool planar = false;
  for (const PlyElement& e : header.elements) {
    ElementReader reader(file, e, header, vertices(e) ? &rows : nullptr, ids);
    reader.read();
    if (vertices(e)) planar = reader.planar();
  }
  refuse_more(file, header.ascii());
  return rows.take(planar);
}

} // namespace flipbook
