// SPDX-License-Identifier: MIT
// A file read from its beginning to its end through one small buffer, so that its size costs no memory and nothing that
// it says about itself is believed before it is there. Every message names the file, and the line in a text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace flipbook {

class ByteSource {
public:
  static constexpr std::size_t block = 1U << 20U;        ///< bytes in the buffer
  static constexpr std::size_t longest_line = 1U << 16U; ///< bytes; a longer one is refused

  /// Throws UserError where the file cannot be read or is not a regular one (a pipe, a folder, a device).
  explicit ByteSource(const std::string& path);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Bytes that were not taken yet, by the size that the file had when it was opened.
  [[nodiscard]] std::uint64_t left() const { return size_ > taken_ ? size_ - taken_ : 0; }

  // Views into the buffer: valid until the next call.
  /// The next n <= block bytes, fewer at the end of the file.
  [[nodiscard]] std::string_view peek(std::size_t n);
  [[nodiscard]] std::string_view take(std::size_t n);
  /// Passes over n bytes; false if the file ends before.
  [[nodiscard]] bool skip(std::uint64_t n);
  /// The next line without its end (\n or \r\n); false at the end of the file.
  [[nodiscard]] bool line(std::string_view& text);
  /// The same for the next line that is neither blank nor a comment (#).
  [[nodiscard]] bool content_line(std::string_view& text);

  /// From here on messages name no line.
  void leave_text() { line_ = 0; }
  /// Throws UserError "path:line: message" about the line read last.
  [[noreturn]] void refuse(const std::string& message) const;

private:
  void fill();

  std::string path_;
  int file_ = -1;
  std::uint64_t size_ = 0, taken_ = 0, line_ = 0;
  std::unique_ptr<char[]> buffer_;
  std::size_t begin_ = 0, end_ = 0; ///< what the buffer holds
  bool at_end_ = false;
};

/// Without blanks at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// Text from a file as a message may hold it: short, printable, on one line.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);
/// The same in quotes.
[[nodiscard]] std::string shown(std::string_view text, std::size_t longest = 32);

} // namespace flipbook
