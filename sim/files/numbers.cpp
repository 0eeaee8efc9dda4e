// SPDX-License-Identifier: MIT
#include "sim/files/numbers.h"

#include <cmath>

namespace flipbook {

Words words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  Words words;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;
       at = line.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

bool read_number(const char*& p, const char* end, double& value) {
  const bool plus = end - p > 1 && *p == '+' && p[1] != '-'; // which from_chars does not know
  const auto [stop, error] = std::from_chars(plus ? p + 1 : p, end, value);
  if (error != std::errc()) return false;
  p = stop;
  return true;
}

bool next_number(const char*& p, const char* end, double& value, bool comments, const ByteSource& file) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (p != end && blank(*p)) ++p;
  if (p == end || (comments && *p == '#')) return false;
  const char* word = p;
  if (!read_number(p, end, value) || (p != end && !blank(*p) && !(comments && *p == '#'))) {
    while (p != end && !blank(*p)) ++p;
    file.refuse("expected a number, not " + shown({word, static_cast<std::size_t>(p - word)}));
  }
  return true;
}

std::optional<std::string_view> finite_number(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  const bool tiny = error == std::errc::result_out_of_range &&
                    (word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos);
  const bool good = (error == std::errc() || tiny) && stop == end && std::isfinite(value);
  return good ? std::optional(word) : std::nullopt;
}

} // namespace flipbook
