// SPDX-License-Identifier: MIT
// The only file that includes CLI11.
#include "app/commands/command.h"
#include "app/commands/option_list.h"
#include "sim/frame/errors.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <iostream>

namespace flipbook::app {

namespace {

/// Builds the CLI11 side of a command's options.
class Builder final : public OptionVisitor {
public:
  explicit Builder(CLI::App& parser) : parser_(parser) {}

  void positional(const Argument& what, std::string& x, const std::string& help, bool required) override {
    parser_.add_option(what.name, x, help)->required(required)->type_name("");
  }
  void positionals(const Argument& what, std::vector<std::string>& x, const std::string& help) override {
    parser_.add_option(what.name, x, help)->type_name("...");
  }
  void text(const std::string& names, std::string& x, const Argument& value, const std::string& help) override {
    parser_.add_option(names, x, help)->type_name(value.name)->take_last();
  }
  void texts(const std::string& names, std::vector<std::string>& x, const Argument& value,
             const std::string& help) override {
    parser_.add_option(names, x, help)
        ->type_name(value.name)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  void flag(const std::string& names, bool& x, const std::string& help) override { parser_.add_flag(names, x, help); }

private:
  CLI::App& parser_;
};

std::vector<std::string> option_names(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const CLI::Option* o : parser.get_options())
    for (const std::string& name : o->get_lnames()) names.push_back("--" + name);
  return names;
}

void refuse_extras(const CLI::App& parser) {
  for (const std::string& word : parser.remaining()) {
    if (word.size() > 1 && word[0] == '-') {
      const std::string name = word.substr(0, word.find('='));
      throw UserError("unknown option " + name, {}, nearest_name(name, option_names(parser)));
    }
  }
  if (parser.remaining_size() > 0) throw UserError("unexpected argument \"" + parser.remaining().front() + "\"");
}

/// The option that takes a value and got none: none follows, or another option does.
void refuse_missing_values(const CLI::App& parser, const std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool ends = arguments[i].ends_with('='); // --option=
    const std::string name = arguments[i].substr(0, arguments[i].size() - (ends ? 1 : 0));
    const CLI::Option* o = name.starts_with("-") ? parser.get_option_no_throw(name) : nullptr;
    if (!o || o->get_expected_min() == 0) continue;
    const bool none = ends || i + 1 == arguments.size() || arguments[i + 1].empty() ||
                      (arguments[i + 1].starts_with("-") && parser.get_option_no_throw(arguments[i + 1]));
    if (none) throw UserError(name + " needs a value: " + o->get_type_name());
    ++i;
  }
}

void refuse_empty_values(const CLI::App& parser) {
  for (const CLI::Option* o : parser.get_options())
    for (const std::string& value : o->results())
      if (value.empty()) throw UserError(o->get_name() + " needs a value that is not empty");
}

} // namespace

bool parse_arguments(const CommandEntry& entry, Command& command, std::vector<std::string> arguments) {
  CLI::App parser(entry.summary + "\n", "flipbook " + entry.name);
  parser.allow_extras(); // to name the nearest option ourselves
  parser.set_help_flag("-h,--help", help_of_help);
  parser.get_formatter()->column_width(32);
  parser.footer(entry.examples);
  Builder builder(parser);
  command.options(builder);
  const auto is_help = [](const std::string& a) { return a == "--help" || a == "-h"; };
  if (std::none_of(arguments.begin(), arguments.end(), is_help)) refuse_missing_values(parser, arguments);
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend()); // the order that CLI11 takes
  try {
    parser.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    std::cout << parser.help();
    return false;
  } catch (const CLI::RequiredError& e) {
    refuse_extras(parser);
    throw UserError(std::string(e.what()) + " (flipbook " + entry.name + " --help)");
  } catch (const CLI::ParseError& e) {
    throw UserError(e.what());
  }
  refuse_extras(parser);
  refuse_empty_values(parser);
  return true;
}

} // namespace flipbook::app
