// SPDX-License-Identifier: MIT
// A program that we feed through its standard input. Started with an argument vector; no shell reads it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace flipbook::app {

class Process {
public:
  /// Throws MachineError when the program cannot be started.
  Process(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  ~Process(); ///< ends it if it still runs
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// False: it no longer reads.
  [[nodiscard]] bool write(std::span<const std::uint8_t> bytes);
  /// Closes its input and waits. Empty: it succeeded; otherwise how it ended and the last lines of its error output.
  [[nodiscard]] std::string finish();

  /// Where PATH finds the program.
  [[nodiscard]] static std::optional<std::filesystem::path> find(std::string_view name);

private:
  [[nodiscard]] std::string last_errors() const;
  void close_input();

  pid_t pid_ = -1;
  int input_ = -1;  ///< our end of a socket pair
  int errors_ = -1; ///< what it wrote to standard error
};

} // namespace flipbook::app
