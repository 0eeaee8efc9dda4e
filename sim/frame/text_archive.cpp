// SPDX-License-Identifier: MIT
#include "sim/frame/text_archive.h"

namespace flipbook {

std::string_view TextReader::token() {
  std::size_t begin = 0;
  while (begin < rest_.size() && (rest_[begin] == ' ' || rest_[begin] == '\n'))
    if (rest_[begin++] == '\n') ++line_;
  std::size_t end = begin;
  if (begin < rest_.size() && rest_[begin] == '"') {
    for (++end; end < rest_.size() && rest_[end] != '"' && rest_[end] != '\n'; ++end)
      if (rest_[end] == '\\') ++end;
    if (end >= rest_.size() || rest_[end] != '"') refuse("a quote is not closed");
    ++end;
  } else {
    while (end < rest_.size() && rest_[end] != ' ' && rest_[end] != '\n') ++end;
  }
  const std::string_view found = rest_.substr(begin, end - begin);
  rest_.remove_prefix(end);
  return found;
}

std::size_t TextReader::count(std::size_t least) {
  std::size_t n = 0;
  get(n);
  if (n > rest_.size() / least) refuse("a length of " + std::to_string(n) + " is more than the file holds");
  return n;
}

void TextReader::get(std::string& x) {
  const std::string_view t = token();
  if (!t.starts_with('"')) refuse("expected a quoted text");
  try {
    x = std::get<std::string>(parse_value(t));
  } catch (const UserError& e) {
    refuse(e.what());
  }
}

void TextReader::value(std::string_view name, Value& x, Kind kind) {
  std::string text;
  field(name, text);
  x = parse_value(text);
  // An empty list does not say what it is a list of.
  if (const auto* words = std::get_if<std::vector<std::string>>(&x); words && words->empty() && kind != Kind::names)
    x = std::vector<double>();
  struct Check {
    Kind kind;
    bool operator()(bool) const { return kind == Kind::flag; }
    bool operator()(double) const { return kind == Kind::real || kind == Kind::integer; }
    bool operator()(const std::string&) const { return kind == Kind::choice || kind == Kind::text; }
    bool operator()(const std::vector<double>&) const { return kind == Kind::reals || kind == Kind::integers; }
    bool operator()(const std::vector<std::string>&) const { return kind == Kind::names; }
  };
  if (!std::visit(Check{kind}, x)) refuse("the value " + text + " is not of the parameter's kind");
}

} // namespace flipbook
