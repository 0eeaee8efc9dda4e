// SPDX-License-Identifier: MIT
// TOML as a tree of plain values that remember where they were written.
#pragma once

#include "sim/frame/errors.h"
#include "sim/frame/parameters.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook {

/// `path = value` with the place it was written at.
struct Assignment {
  std::string path;
  Value value;
  Location where;
};

/// A value in a TOML text. The entries of a table are in the order of the text.
struct Node {
  enum class Type { table, list, text, number, flag, date };
  Type type = Type::table;
  std::string key; ///< of an entry of a table
  Location where;  ///< of the key, or of the value where there is none
  std::string text;
  double number = 0;
  bool flag = false;
  std::vector<Node> items; ///< of a table or a list

  [[nodiscard]] const Node* find(std::string_view name) const;
};

/// Throws a UserError with line and column for a text that is not TOML 1.0.
[[nodiscard]] Node parse_toml(std::string_view text, const std::string& file);

/// The content of a text file; throws a UserError that says why it cannot be read.
[[nodiscard]] std::string read_text_file(const std::string& path);

/// The value of a parameter; nothing (and a mistake) for tables, dates and mixed lists.
[[nodiscard]] std::optional<Value> value_of(const Node& node, Mistakes& mistakes);

/// Every leaf below `node` as an assignment: tables become dotted paths.
void flatten(const Node& node, const std::string& path, std::vector<Assignment>& into, Mistakes& mistakes);

/// The node as an inline value: `{ shape = "ball", radius = 0.1 }`.
[[nodiscard]] std::string to_toml(const Node& node);
/// A key as TOML writes it: bare where possible, else quoted.
[[nodiscard]] std::string toml_key(const std::string& key);

/// Reads the entries of one table by name, and at the end refuses those that nobody asked for.
class TableReader {
public:
  /// `what` names the table in messages: "a ball", "the scene".
  TableReader(const Node& table, std::string what, Mistakes& mistakes);

  [[nodiscard]] const Node* optional(std::string_view key);
  [[nodiscard]] const Node* required(std::string_view key); ///< null and a mistake if it is missing
  [[nodiscard]] std::string text(std::string_view key, std::string fallback);
  /// A finite number between lo and hi.
  [[nodiscard]] double number(std::string_view key, double lo, double hi, std::optional<double> fallback);
  /// `least` to `most` finite numbers.
  [[nodiscard]] std::vector<double> numbers(std::string_view key, std::size_t least, std::size_t most,
                                            std::optional<std::vector<double>> fallback);
  void done();

  void mistake(const std::string& message, const Node& at, std::string_view nearest = {});

private:
  const Node& table_;
  std::string what_;
  Mistakes& mistakes_;
  std::vector<std::string> known_;
};

} // namespace flipbook
