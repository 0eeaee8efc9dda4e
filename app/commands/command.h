// SPDX-License-Identifier: MIT
// A command of the program: a name, a line of help, its options, and what it does. Each has a file of its own; the
// table of all of them is in main.cpp.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace flipbook::app {

/// The value of an option, or an argument by its place: how the help calls it, and what a shell may offer for it.
struct Argument {
  enum class Kind {
    other,      ///< a number, a list of times, ...: nothing to offer
    choice,     ///< one of `choices`
    file,       ///< a file or a folder
    folder,     ///< a folder
    scene,      ///< name or path of a scene
    study,      ///< name or path of a study or a scene
    assignment, ///< path=value
    variation,  ///< path=value,value,... of what may differ between panes
    schemes,    ///< name[:number],...
    mistake,    ///< of the bug museum
  };
  std::string name;
  Kind kind;
  std::vector<std::string> choices;

  Argument(const char* text) : Argument(std::string(text)) {}
  Argument(std::string text, Kind what = Kind::other, std::vector<std::string> all = {})
      : name(std::move(text)), kind(what), choices(std::move(all)) {}
};

/// One of these, called "a|b|c".
[[nodiscard]] Argument one_of(std::vector<std::string> choices);

/// Receives the options of a command, once each. An empty value afterwards means that the option was not given.
class OptionVisitor {
public:
  virtual ~OptionVisitor() = default;
  virtual void positional(const Argument& what, std::string& x, const std::string& help, bool required = true) = 0;
  /// Any number of them.
  virtual void positionals(const Argument& what, std::vector<std::string>& x, const std::string& help) = 0;
  /// `names` as in "-o,--output".
  virtual void text(const std::string& names, std::string& x, const Argument& value, const std::string& help) = 0;
  /// May be given several times.
  virtual void texts(const std::string& names, std::vector<std::string>& x, const Argument& value,
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

/// What the program is, in one sentence.
inline constexpr const char* program_summary =
    "Comparison videos of particle-grid simulations, from one text file, without a display";

/// All commands, in the order in which the help lists them.
[[nodiscard]] std::span<const CommandEntry> commands();

/// Reads the arguments behind the command's name into its options. False: help was asked for and printed. Throws
/// UserError for an option that does not exist or lacks its value.
[[nodiscard]] bool parse_arguments(const CommandEntry& entry, Command& command, std::vector<std::string> arguments);

std::unique_ptr<Command> make_render();
std::unique_ptr<Command> make_compare();
std::unique_ptr<Command> make_serve();
std::unique_ptr<Command> make_still();
std::unique_ptr<Command> make_stages();
std::unique_ptr<Command> make_figure();
std::unique_ptr<Command> make_gallery();
std::unique_ptr<Command> make_verify();
std::unique_ptr<Command> make_validate();
std::unique_ptr<Command> make_list();
std::unique_ptr<Command> make_info();
std::unique_ptr<Command> make_import();
std::unique_ptr<Command> make_bench();
std::unique_ptr<Command> make_new();
std::unique_ptr<Command> make_completion();
std::unique_ptr<Command> make_man();

} // namespace flipbook::app
