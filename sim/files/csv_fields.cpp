// SPDX-License-Identifier: MIT
#include "sim/files/csv_fields.h"

#include "sim/files/numbers.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace flipbook {

std::string_view CsvFields::next() {
  while (p_ != end_ && *p_ == ' ') ++p_;
  return p_ != end_ && *p_ == '"' ? quoted() : plain();
}

std::string_view CsvFields::plain() {
  const void* stop = p_ == end_ ? nullptr : std::memchr(p_, separator_, static_cast<std::size_t>(end_ - p_));
  return ends(p_, stop ? static_cast<const char*>(stop) : end_);
}

std::string_view CsvFields::quoted() {
  const char* first = ++p_;
  const auto quote = [&] { return std::find(p_, end_, '"'); };
  for (p_ = quote(); p_ != end_ && p_ + 1 != end_ && p_[1] == '"'; p_ = quote()) p_ += 2;
  if (p_ == end_) file_.refuse("a quote is not closed in this line");
  const char* last = p_++;
  while (p_ != end_ && *p_ == ' ') ++p_;
  if (p_ != end_ && *p_ != separator_) file_.refuse("text after a closing quote");
  (void)ends(p_, p_);
  return {first, static_cast<std::size_t>(last - first)};
}

std::string_view CsvFields::ends(const char* first, const char* last) {
  done_ = last == end_;
  p_ = done_ ? end_ : last + 1;
  return {first, static_cast<std::size_t>(last - first)};
}

char csv_separator(std::string_view header) {
  std::array<std::size_t, 3> count{};
  constexpr std::string_view known = ",;\t";
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    if (const std::size_t i = known.find(c); !quoted && i != std::string_view::npos) ++count[i];
  }
  return known[static_cast<std::size_t>(std::max_element(count.begin(), count.end()) - count.begin())];
}

double csv_number(std::string_view field, const std::string& column, const ByteSource& file) {
  const std::string_view text = trimmed(field);
  const char *p = text.data(), *end = p + text.size();
  double value = 0;
  if (text.empty() || !read_number(p, end, value) || p != end)
    file.refuse("column " + shown(column) + ": expected a number, not " + shown(text));
  return value;
}

} // namespace flipbook
