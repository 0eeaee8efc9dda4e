// SPDX-License-Identifier: MIT
#include "sim/files/particle_formats.h"
#include "sim/files/ply_header.h"
#include "sim/files/row_store.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace flipbook {
namespace {

/// One number of a binary file, whose bytes may be in the other order than ours.
template <class T> double number(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> own{};
  std::memcpy(own.data(), bytes, own.size());
  if (swap) std::reverse(own.begin(), own.end());
  return static_cast<double>(std::bit_cast<T>(own));
}

double number(const char* bytes, PlyType type, bool swap) {
  switch (type) {
  case PlyType::i8: return number<std::int8_t>(bytes, swap);
  case PlyType::u8: return number<std::uint8_t>(bytes, swap);
  case PlyType::i16: return number<std::int16_t>(bytes, swap);
  case PlyType::u16: return number<std::uint16_t>(bytes, swap);
  case PlyType::i32: return number<std::int32_t>(bytes, swap);
  case PlyType::u32: return number<std::uint32_t>(bytes, swap);
  case PlyType::f32: return number<float>(bytes, swap);
  case PlyType::f64: return number<double>(bytes, swap);
  }
  return 0;
}

/// The rows of one element. The vertices go to a store; all others are passed over.
class ElementReader {
public:
  ElementReader(ByteSource& file, const PlyElement& element, PlyHeader::Format format, RowStore* store, bool ids)
      : file_(file), element_(element), store_(store), ascii_(format == PlyHeader::Format::ascii),
        swap_((format == PlyHeader::Format::big) != (std::endian::native == std::endian::big)) {
    if (store) find_slots(ids);
  }

  void read() {
    if (element_.properties.empty()) return; // there is nothing in its rows
    refuse_impossible_count();
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
    slot_.assign(names.size(), -1);
    for (std::size_t i = 0; i < columns_.at.size(); ++i)
      if (columns_.at[i] >= 0) slot_[static_cast<std::size_t>(columns_.at[i])] = static_cast<int>(i);
  }

  void refuse_impossible_count() const {
    const std::uint64_t bytes = element_.least_bytes(ascii_);
    if (store_) store_->promised(element_.rows, bytes);
    if (element_.rows > (file_.left() + 1) / bytes)
      file_.refuse("the element " + shown(element_.name) + " promises " + std::to_string(element_.rows) +
                   " rows, which the rest of the file cannot hold");
  }

  [[noreturn]] void ends_early(std::uint64_t row) const {
    file_.refuse("the file ends in row " + std::to_string(row + 1) + " of the " + std::to_string(element_.rows) +
                 " of its element " + shown(element_.name));
  }

  [[nodiscard]] int slot(std::size_t property) const { return store_ ? slot_[property] : -1; }

  /// n items of so many bytes.
  void pass(std::uint64_t n, std::uint64_t bytes, std::uint64_t row) {
    if (n > file_.left() / bytes || !file_.skip(n * bytes)) ends_early(row);
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
          row[to[i]] = number(bytes.data() + at + wanted[i].first, wanted[i].second, swap_);
        store_->add(row);
      }
      if (bytes.size() < n * size) ends_early(done);
    }
  }

  double next(PlyType type, std::uint64_t row) {
    const std::string_view bytes = file_.take(bytes_of(type));
    if (bytes.size() < bytes_of(type)) ends_early(row);
    return number(bytes.data(), type, swap_);
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
    std::string_view line;
    for (std::uint64_t r = 0; r < element_.rows; ++r) {
      do
        if (!file_.line(line)) ends_early(r);
      while (trimmed(line).empty());
      read_line(line, row);
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
    const auto blank = [](char c) { return c == ' ' || c == '\t'; };
    while (p != end && blank(*p)) ++p;
    if (p == end) file_.refuse("fewer numbers in a row than the element " + shown(element_.name) + " has properties");
    const char* word = p;
    double value = 0;
    if (!read_number(p, end, value) || (p != end && !blank(*p))) {
      while (p != end && !blank(*p)) ++p;
      file_.refuse("expected a number, not " + shown({word, static_cast<std::size_t>(p - word)}));
    }
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
  const bool ascii = header.format == PlyHeader::Format::ascii;
  if (!ascii) file.leave_text();
  RowStore rows(file);
  bool planar = false;
  for (const PlyElement& e : header.elements) {
    ElementReader reader(file, e, header.format, vertices(e) ? &rows : nullptr, ids);
    reader.read();
    if (vertices(e)) planar = reader.planar();
  }
  refuse_more(file, ascii);
  return rows.take(planar);
}

} // namespace flipbook
