// SPDX-License-Identifier: MIT
// A command of the program: a name, a line of help, its options, and what it does. Each has a file of its own; the
// table of all of them is in main.cpp.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace flipbook::app {

/// Receives the options of a command, once each. An empty value afterwards means that the option was not given.
class OptionVisitor {
public:
  virtual ~OptionVisitor() = default;
  virtual void positional(const std::string& name, std::string& x, const std::string& help, bool required = true) = 0;
  /// `names` as in "-o,--output"; `value` is how the help calls the value.
  virtual void text(const std::string& names, std::string& x, const std::string& value, const std::string& help) = 0;
  /// May be given several times.
  virtual void texts(const std::string& names, std::vector<std::string>& x, const std::string& value,
                     const std::string& help) = 0;
  virtual void flag(const std::string& names, bool& x, const std::string& help) = 0;
};

class Command {
public:
  virtual ~Command() = default;
  virtual void options(OptionVisitor& v) = 0;
  virtual int run() = 0; ///< 0, or 1 when a check failed; everything else is an exception
};

struct CommandEntry {
  std::string name, summary;
  std::string examples; ///< shown below the help, one a line
  std::unique_ptr<Command> (*make)();
};

/// All commands, in the order in which the help lists them.
[[nodiscard]] std::span<const CommandEntry> commands();

/// Reads the arguments behind the command's name into its options. False: help was asked for and printed. Throws
/// UserError for an option that does not exist or lacks its value.
[[nodiscard]] bool parse_arguments(const CommandEntry& entry, Command& command, std::vector<std::string> arguments);

std::unique_ptr<Command> make_render();
std::unique_ptr<Command> make_compare();
std::unique_ptr<Command> make_still();
std::unique_ptr<Command> make_verify();
std::unique_ptr<Command> make_list();
std::unique_ptr<Command> make_info();

} // namespace flipbook::app
