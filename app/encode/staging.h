// SPDX-License-Identifier: MIT
// Files under construction. They are written into a hidden folder beside their final place (so that renaming is atomic)
// and get their names in commit(); otherwise the destructor removes them, and the folders that were made for them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook::app {

class Staging {
public:
  /// Makes `folder` (and those above it) where missing. Throws MachineError when nothing can be written there.
  explicit Staging(const std::filesystem::path& folder);
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  /// Where to write the file that will become folder/name.
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return hidden_ / name; }
  /// Writes that file whole. Throws MachineError (full disk) that names the final file.
  void write(const std::string& name, std::span<const std::uint8_t> bytes) const;
  void write(const std::string& name, std::string_view text) const;
  /// Adds to the end of that file, which need not be there yet.
  void append(const std::string& name, std::string_view text) const;
  /// Moves every file to its final name, replacing what was there.
  void commit();

private:
  void write(const std::string& name, std::span<const std::uint8_t> bytes, const char* mode) const;

  std::filesystem::path folder_, hidden_;
  std::vector<std::filesystem::path> made_; ///< folders that did not exist, outermost first
};

/// Writes one file whole or not at all.
void write_file(const std::filesystem::path& file, std::string_view text);

} // namespace flipbook::app
