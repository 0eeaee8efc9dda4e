// SPDX-License-Identifier: MIT
#include "sim/scene/expression.h"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <numbers>

namespace flipbook {
namespace {

constexpr std::size_t longest = 2000; // no formula that a person writes

/// The first letter in lower case and no full stop, so that it can follow a colon.
std::string clause(std::string message) {
  while (!message.empty() && (message.back() == '.' || message.back() == ' ' || message.back() == '\n'))
    message.pop_back();
  if (!message.empty() && message[0] >= 'A' && message[0] <= 'Z')
    message[0] = static_cast<char>(message[0] - 'A' + 'a');
  return message;
}

} // namespace

/// The parser reads its variables from `values`; the mutex makes a formula usable from several threads.
struct Expression::Parser {
  mu::Parser mu;
  std::vector<double> values;
  std::mutex mutex;

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& [name, address] : mu.GetVar()) all.push_back(name);
    for (const auto& [name, value] : mu.GetConst()) all.push_back(name);
    for (const auto& [name, function] : mu.GetFunDef()) all.push_back(name);
    return all;
  }
};

Expression::Expression(const std::string& text, const std::vector<std::string>& variables, const Location& where)
    : parser_(std::make_shared<Parser>()), text_(text), where_(where) {
  if (text.size() > longest) throw UserError("a formula may have at most 2000 characters", where);
  Parser& p = *parser_;
  p.values.assign(variables.size(), 0.5);
  try {
    p.mu.ClearConst();
    p.mu.DefineConst("pi", std::numbers::pi);
    p.mu.DefineConst("e", std::numbers::e);
    for (std::size_t i = 0; i < variables.size(); ++i) p.mu.DefineVar(variables[i], &p.values[i]);
    p.mu.SetExpr(text);
    p.mu.Eval();
  } catch (const mu::ParserError& error) {
    if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN)
      throw UserError("the formula \"" + text + "\" uses the unknown name \"" + error.GetToken() + "\"", where,
                      nearest_name(error.GetToken(), p.names()));
    throw UserError("the formula \"" + text + "\" cannot be read: " + clause(error.GetMsg()), where);
  }
  // "x = 2" would be an assignment.
  if (p.values != std::vector<double>(variables.size(), 0.5) || p.mu.GetNumResults() != 1)
    throw UserError("the formula \"" + text + "\" must be one expression, without \"=\" and without commas", where);
}

double Expression::operator()(std::span<const double> values) const {
  const std::scoped_lock lock(parser_->mutex);
  std::copy(values.begin(), values.end(), parser_->values.begin());
  double result = 0;
  try {
    result = parser_->mu.Eval();
  } catch (const mu::ParserError& error) {
    throw UserError("the formula \"" + text_ + "\" fails: " + clause(error.GetMsg()), where_);
  }
  if (std::isfinite(result)) return result;
  std::string at;
  for (const double v : values) at.append(at.empty() ? "" : ", ").append(std::to_string(v));
  throw UserError("the formula \"" + text_ + "\" is not a finite number" + (at.empty() ? "" : " at (" + at + ")"),
                  where_);
}

} // namespace flipbook
