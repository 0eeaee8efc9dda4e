// SPDX-License-Identifier: MIT
// Starts the real program, as a user's shell would, and keeps what it said.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace flipbook::test {

struct Outcome {
  int code = -1; ///< exit code; 1000 + signal when a signal ended it
  std::string out, err;
};

struct Setting {
  std::map<std::string, std::string> environment{}; ///< added to ours
  std::vector<std::string> before{};                ///< a program and arguments that start the program ("unshare", ...)
  long file_size_limit = -1;                        ///< bytes; stands for a disk that is full
  int interrupt_after_ms = -1;                      ///< sends SIGINT then
};

/// Runs the program in the folder `where`.
[[nodiscard]] Outcome run(const std::vector<std::string>& arguments, const std::filesystem::path& where,
                          const Setting& setting = {});
/// Runs any other program found in PATH.
[[nodiscard]] Outcome run_other(const std::vector<std::string>& words, const std::filesystem::path& where);

/// An empty folder, removed at the end.
class Folder {
public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& text) const;
  /// Every file and folder below it, hidden ones too, sorted.
  [[nodiscard]] std::vector<std::string> files() const;

private:
  std::filesystem::path path_;
};

/// One line on standard error that has all of `says`, nothing on standard output, and that exit code.
void expect_refusal(const Outcome& o, int code, const std::vector<std::string>& says);

[[nodiscard]] std::string read_file(const std::filesystem::path& file);

} // namespace flipbook::test
