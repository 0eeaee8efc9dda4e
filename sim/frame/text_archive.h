// SPDX-License-Identifier: MIT
// Named fields written to text and read back, by the same sequence of calls. Reading trusts nothing: every length is
// checked against what is left of the text before memory is taken for it.
#pragma once

#include "sim/frame/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace flipbook {

class TextWriter {
public:
  std::string text;

  template <class T> void field(std::string_view name, const T& x) {
    begin(name);
    put(x);
    text += '\n';
  }
  template <class E> void enumeration(std::string_view name, const E& x, int /*last*/) {
    field(name, static_cast<int>(x));
  }
  void value(std::string_view name, const Value& x, Kind /*kind*/) { field(name, to_toml(x)); }
  template <class T> void length(std::string_view name, const std::vector<T>& x) { field(name, x.size()); }
  /// A block that may be missing: its name alone begins it.
  void optional(std::string_view name, bool there) {
    if (there) text.append(name).append("\n");
  }

private:
  static constexpr std::size_t per_line = 16;

  void begin(std::string_view name) { text.append(name); }
  void put(bool x) { text += x ? " 1" : " 0"; }
  void put(const std::string& x) { text.append(" ").append(to_toml(x)); }
  template <class T> void put(T x) requires std::is_arithmetic_v<T> {
    std::array<char, 32> digits{};
    text.append(" ").append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
  }
  template <class T, std::size_t N> void put(const std::array<T, N>& list) {
    for (const T& x : list) put(x);
  }
  template <class T> void put(const std::vector<T>& list) {
    put(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i % per_line == 0 && list.size() > per_line) text += '\n';
      put(list[i]);
    }
  }
};

class TextReader {
public:
  TextReader(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {}

  template <class T> void field(std::string_view name, T& x) {
    begin(name);
    get(x);
  }
  template <class E> void enumeration(std::string_view name, E& x, int last) {
    int index = 0;
    field(name, index);
    if (index < 0 || index > last) refuse(std::string(name) + " is out of range");
    x = static_cast<E>(index);
  }
  void value(std::string_view name, Value& x, Kind kind);
  template <class T> void length(std::string_view name, std::vector<T>& x) {
    begin(name);
    constexpr std::size_t least = 24; // characters that the fields of the smallest entry take
    x.resize(count(least));
  }
  void optional(std::string_view name, bool& there) {
    const TextReader before = *this;
    there = token() == name;
    if (!there) *this = before;
  }
  /// Nothing may follow the last field.
  void end() {
    if (!token().empty()) refuse("text follows the last field");
  }

private:
  [[noreturn]] void refuse(const std::string& message) const { throw UserError(message, Location{file_, line_}); }
  void begin(std::string_view name) {
    if (token() != name) refuse("expected \"" + std::string(name) + "\"");
  }
  std::string_view token(); ///< up to white space; a quoted text is one token, quotes included
  /// A length; refused where what is left of the text cannot hold as many entries of `least` characters each.
  [[nodiscard]] std::size_t count(std::size_t least = 2);

  void get(bool& x) {
    const std::string_view t = token();
    if (t != "0" && t != "1") refuse("expected 0 or 1");
    x = t == "1";
  }
  void get(std::string& x);
  template <class T> void get(T& x) requires std::is_arithmetic_v<T> {
    const std::string_view t = token();
    const auto [last, error] = std::from_chars(t.data(), t.data() + t.size(), x);
    if (error != std::errc() || last != t.data() + t.size()) refuse("expected a number");
  }
  template <class T, std::size_t N> void get(std::array<T, N>& list) {
    for (T& x : list) get(x);
  }
  template <class T> void get(std::vector<T>& list) {
    list.resize(count());
    for (T& x : list) get(x);
  }

  std::string_view rest_;
  std::string file_;
  int line_ = 1;
};

} // namespace flipbook
