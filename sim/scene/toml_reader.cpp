// SPDX-License-Identifier: MIT
#include "sim/scene/toml_reader.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace flipbook {
namespace {

constexpr std::size_t largest_text = 8U << 20U; // bytes; a scene or study is a few thousand

Location location(const toml::source_region& at, const std::string& file) {
  return {file, static_cast<int>(at.begin.line), static_cast<int>(at.begin.column)};
}

bool before(const Node& a, const Node& b) {
  return a.where.line != b.where.line ? a.where.line < b.where.line : a.where.column < b.where.column;
}

Node convert(const toml::node& from, const std::string& file) {
  Node to;
  to.where = location(from.source(), file);
  if (const toml::table* table = from.as_table()) {
    for (const auto& [key, value] : *table) {
      to.items.push_back(convert(value, file));
      to.items.back().key = std::string(key.str());
      to.items.back().where = location(key.source(), file);
    }
    std::stable_sort(to.items.begin(), to.items.end(), before);
  } else if (const toml::array* list = from.as_array()) {
    to.type = Node::Type::list;
    for (const toml::node& value : *list) to.items.push_back(convert(value, file));
  } else if (const auto* text = from.as_string()) {
    to.type = Node::Type::text;
    to.text = text->get();
  } else if (const auto number = from.value<double>(); number && from.is_number()) {
    to.type = Node::Type::number;
    to.number = *number;
  } else if (const auto* flag = from.as_boolean()) {
    to.type = Node::Type::flag;
    to.flag = flag->get();
  } else {
    to.type = Node::Type::date;
  }
  return to;
}

std::string quoted(std::string_view key) {
  return std::string(1, '"').append(key).append(1, '"');
}

std::optional<std::vector<double>> finite_numbers(const Node& node) {
  std::vector<double> all;
  for (const Node& n : node.items) {
    if (n.type != Node::Type::number || !std::isfinite(n.number)) return std::nullopt;
    all.push_back(n.number);
  }
  return all;
}

} // namespace

const Node* Node::find(std::string_view name) const {
  const auto at = std::find_if(items.begin(), items.end(), [&](const Node& n) { return n.key == name; });
  return at == items.end() ? nullptr : &*at;
}

Node parse_toml(std::string_view text, const std::string& file) {
  if (text.size() > largest_text) throw UserError("is too long for a scene or a study", Location{file});
  try {
    return convert(toml::parse(text, file), file);
  } catch (const toml::parse_error& error) {
    std::string message(error.description());
    std::replace(message.begin(), message.end(), '\n', ' ');
    throw UserError("not TOML: " + message, location(error.source(), file));
  }
}

std::string read_text_file(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text(largest_text + 1, '\0');
  if (file) file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.eof()) {
    const std::string why = errno != 0 ? std::strerror(errno) : "it is too long for a scene or a study";
    throw UserError("cannot read \"" + path + "\": " + why);
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

std::optional<Value> value_of(const Node& node, Mistakes& mistakes) {
  switch (node.type) {
  case Node::Type::text: return node.text;
  case Node::Type::number: return node.number;
  case Node::Type::flag: return node.flag;
  case Node::Type::list: {
    const auto all = [&](Node::Type t) {
      return std::all_of(node.items.begin(), node.items.end(), [t](const Node& n) { return n.type == t; });
    };
    if (all(Node::Type::text)) {
      std::vector<std::string> words;
      for (const Node& n : node.items) words.push_back(n.text);
      return words;
    }
    if (all(Node::Type::number)) {
      std::vector<double> numbers;
      for (const Node& n : node.items) numbers.push_back(n.number);
      return numbers;
    }
    mistakes.add("a list holds either numbers or texts", node.where);
    return std::nullopt;
  }
  case Node::Type::table: mistakes.add("a value is expected here, not a table", node.where); return std::nullopt;
  case Node::Type::date: mistakes.add("dates and times have no use here", node.where); return std::nullopt;
  }
  return std::nullopt;
}

void flatten(const Node& node, const std::string& path, std::vector<Assignment>& into, Mistakes& mistakes) {
  if (node.type == Node::Type::table) {
    for (const Node& n : node.items) flatten(n, path.empty() ? n.key : path + "." + n.key, into, mistakes);
  } else if (auto value = value_of(node, mistakes)) {
    into.push_back({path, std::move(*value), node.where});
  }
}

std::string toml_key(const std::string& key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  return bare ? key : to_toml(Value(key));
}

std::string to_toml(const Node& node) {
  std::string text;
  switch (node.type) {
  case Node::Type::text: return to_toml(Value(node.text));
  case Node::Type::number: return to_toml(Value(node.number));
  case Node::Type::flag: return to_toml(Value(node.flag));
  case Node::Type::date: throw UserError("dates and times have no use here", node.where);
  case Node::Type::list:
    for (const Node& n : node.items) text.append(text.empty() ? "" : ", ").append(to_toml(n));
    return "[" + text + "]";
  case Node::Type::table:
    for (const Node& n : node.items) text.append(text.empty() ? "" : ", ").append(toml_key(n.key) + " = " + to_toml(n));
    return text.empty() ? "{}" : "{ " + text + " }";
  }
  return text;
}

TableReader::TableReader(const Node& table, std::string what, Mistakes& mistakes)
    : table_(table), what_(std::move(what)), mistakes_(mistakes) {}

void TableReader::mistake(const std::string& message, const Node& at, std::string_view nearest) {
  mistakes_.add(message, at.where, nearest);
}

const Node* TableReader::optional(std::string_view key) {
  known_.emplace_back(key);
  return table_.find(key);
}

const Node* TableReader::required(std::string_view key) {
  const Node* node = optional(key);
  if (!node) mistake(what_ + " needs " + quoted(key), table_);
  return node;
}

std::string TableReader::text(std::string_view key, std::string fallback) {
  const Node* node = optional(key);
  if (!node) return fallback;
  if (node->type != Node::Type::text) mistake(quoted(key) + " must be a text in quotes", *node);
  return node->text;
}

double TableReader::number(std::string_view key, double lo, double hi, std::optional<double> fallback) {
  const Node* node = fallback ? optional(key) : required(key);
  if (!node) return fallback.value_or(lo);
  if (node->type == Node::Type::number && node->number >= lo && node->number <= hi) return node->number;
  mistake(quoted(key) + " must be a number from " + to_toml(Value(lo)) + " to " + to_toml(Value(hi)) + ", not " +
              to_toml(*node),
          *node);
  return lo;
}

std::vector<double> TableReader::numbers(std::string_view key, std::size_t least, std::size_t most,
                                         std::optional<std::vector<double>> fallback) {
  const Node* node = fallback ? optional(key) : required(key);
  std::vector<double> placeholder(least, 0.0);
  if (!node) return fallback.value_or(placeholder);
  if (node->type == Node::Type::list && node->items.size() >= least && node->items.size() <= most)
    if (auto all = finite_numbers(*node)) return *all;
  const std::string count =
      least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
  mistake(quoted(key) + " must be a list of " + count + " numbers, not " + to_toml(*node), *node);
  return placeholder;
}

void TableReader::done() {
  for (const Node& n : table_.items)
    if (std::find(known_.begin(), known_.end(), n.key) == known_.end())
      mistake("unknown key " + quoted(n.key) + " in " + what_, n, nearest_name(n.key, known_));
}

} // namespace flipbook
