// SPDX-License-Identifier: MIT
// The options of a command as plain data, for what is generated from them: shell completion and the man page.
#pragma once

#include "app/commands/command.h"

#include <string>
#include <vector>

namespace flipbook::app {

/// The option that every command has.
inline constexpr const char* help_of_help = "Print this help and end";

struct OptionInfo {
  std::vector<std::string> names; ///< "-o", "--output"; none: an argument by its place
  Argument value;                 ///< of a flag: without a name
  std::string help;
  bool required = false; ///< of an argument by its place
  bool repeated = false; ///< may be given several times

  [[nodiscard]] bool by_place() const { return names.empty(); }
  [[nodiscard]] bool is_flag() const { return value.name.empty(); }
};

/// In the order in which the command describes them; --help, which all have, comes last.
[[nodiscard]] std::vector<OptionInfo> options_of(const CommandEntry& entry);

} // namespace flipbook::app
