// SPDX-License-Identifier: MIT
// Values as text: what TOML writes, and what a command line is given.
#include "sim/frame/parameters.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace flipbook {
namespace {

std::string number_text(double d) {
  if (std::isnan(d)) return "nan";
  if (std::isinf(d)) return d < 0 ? "-inf" : "inf";
  std::array<char, 32> text{};
  // Whole numbers without an exponent, as long as they are exact: the shortest form of a million would be 1e+06.
  const bool plain = d == std::floor(d) && std::abs(d) < 1e15;
  const auto end = plain ? std::to_chars(text.data(), text.data() + text.size(), d, std::chars_format::fixed)
                         : std::to_chars(text.data(), text.data() + text.size(), d);
  return {text.data(), end.ptr};
}

std::string quoted(std::string_view text) {
  std::string q = "\"";
  for (const char c : text) {
    const auto u = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      q += '\\', q += c;
    else if (c == '\n')
      q += "\\n";
    else if (c == '\t')
      q += "\\t";
    else if (u < 0x20 || u == 0x7f) {
      constexpr std::string_view hex = "0123456789abcdef";
      q.append("\\u00").append(1, hex[u >> 4U]).append(1, hex[u & 15U]);
    } else
      q += c;
  }
  return q + "\"";
}

template <class List, class Write> std::string list_text(const List& list, Write write) {
  std::string text = "[";
  for (const auto& x : list) text.append(text.size() > 1 ? ", " : "").append(write(x));
  return text + "]";
}

std::string_view trim(std::string_view s) {
  const auto first = s.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return s.substr(first, s.find_last_not_of(" \t\r\n") - first + 1);
}

std::optional<double> number(std::string_view s) {
  if (s.starts_with('+')) s.remove_prefix(1);
  double d = 0;
  const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), d);
  if (error != std::errc() || end != s.data() + s.size()) return std::nullopt;
  return d;
}

[[noreturn]] void refuse(std::string_view text, const char* why) {
  throw UserError(std::string(why) + " in the value " + std::string(text));
}

unsigned hex_digits(std::string_view digits, std::string_view whole) {
  unsigned code = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
  if (error != std::errc() || end != digits.data() + digits.size() || code > 0x7f) refuse(whole, "unsupported escape");
  return code;
}

/// The text of a quoted string: `s` starts and ends with the same quote.
std::string unquote(std::string_view s, std::string_view whole) {
  if (s.front() == '\'') return std::string(s.substr(1, s.size() - 2));
  std::string text;
  for (std::size_t i = 1; i + 1 < s.size(); ++i) {
    if (s[i] != '\\') {
      text += s[i];
      continue;
    }
    const char e = s[++i];
    if (e == 'n')
      text += '\n';
    else if (e == 't')
      text += '\t';
    else if (e == '"' || e == '\\')
      text += e;
    else if (e == 'u' && i + 5 < s.size()) {
      text += static_cast<char>(hex_digits(s.substr(i + 1, 4), whole));
      i += 4;
    } else
      refuse(whole, "unsupported escape");
  }
  return text;
}

/// Splits at commas outside quotes; a trailing comma adds nothing.
std::vector<std::string_view> split(std::string_view s, std::string_view whole) {
  std::vector<std::string_view> parts;
  char quote = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const char c = s[i];
    if (quote != 0) {
      if (c == '\\' && quote == '"')
        ++i;
      else if (c == quote)
        quote = 0;
    } else if (c == '"' || c == '\'')
      quote = c;
    else if (c == ',') {
      parts.push_back(trim(s.substr(begin, i - begin)));
      begin = i + 1;
    }
  }
  if (quote != 0) refuse(whole, "a quote is not closed");
  if (!trim(s.substr(begin)).empty()) parts.push_back(trim(s.substr(begin)));
  for (const auto p : parts)
    if (p.empty()) refuse(whole, "an entry is missing");
  return parts;
}

bool is_quoted(std::string_view s) {
  return s.size() >= 2 && (s.front() == '"' || s.front() == '\'') && s.back() == s.front();
}

std::string word(std::string_view s, std::string_view whole) {
  return is_quoted(s) ? unquote(s, whole) : std::string(s);
}

Value list(std::string_view s, std::string_view whole) {
  const auto parts = split(s, whole);
  std::vector<double> numbers;
  std::vector<std::string> words;
  for (const auto p : parts) {
    if (const auto d = number(p))
      numbers.push_back(*d);
    else
      words.push_back(word(p, whole));
  }
  if (words.empty() && !numbers.empty()) return numbers;
  if (!numbers.empty()) refuse(whole, "numbers and words are mixed");
  return words;
}

} // namespace

std::string to_toml(const Value& value) {
  struct Write {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(double d) const { return number_text(d); }
    std::string operator()(const std::string& s) const { return quoted(s); }
    std::string operator()(const std::vector<double>& v) const { return list_text(v, number_text); }
    std::string operator()(const std::vector<std::string>& v) const { return list_text(v, quoted); }
  };
  return std::visit(Write{}, value);
}

Value parse_value(std::string_view text) {
  const std::string_view s = trim(text);
  if (s == "true") return true;
  if (s == "false") return false;
  if (const auto d = number(s)) return *d;
  if (s.starts_with('[')) {
    if (!s.ends_with(']')) refuse(s, "the bracket [ is not closed");
    return list(s.substr(1, s.size() - 2), s);
  }
  const auto parts = split(s, s);
  if (parts.size() > 1) return list(s, s);
  return parts.empty() ? std::string() : word(parts.front(), s);
}

} // namespace flipbook
