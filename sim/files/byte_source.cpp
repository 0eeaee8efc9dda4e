// SPDX-License-Identifier: MIT
#include "sim/files/byte_source.h"

#include "sim/frame/errors.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sys/stat.h>
#include <unistd.h>

namespace flipbook {

ByteSource::ByteSource(const std::string& path) : path_(path) {
  struct stat about {};
  // Looked at before it is opened: to open a pipe waits for its other end.
  if (::stat(path.c_str(), &about) != 0) throw UserError("cannot read \"" + path + "\": " + std::strerror(errno));
  if (!S_ISREG(about.st_mode)) throw UserError("cannot read \"" + path + "\": it is not a regular file");
  file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file_ < 0) throw UserError("cannot read \"" + path + "\": " + std::strerror(errno));
  size_ = static_cast<std::uint64_t>(about.st_size);
  buffer_ = std::make_unique_for_overwrite<char[]>(block);
}

ByteSource::~ByteSource() {
  ::close(file_);
}

void ByteSource::fill() {
  std::memmove(buffer_.get(), buffer_.get() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  while (end_ < block && !at_end_) {
    const ssize_t got = ::read(file_, buffer_.get() + end_, block - end_);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw UserError("cannot read \"" + path_ + "\": " + std::strerror(errno));
    at_end_ = got == 0;
    end_ += static_cast<std::size_t>(got);
  }
}

std::string_view ByteSource::peek(std::size_t n) {
  if (end_ - begin_ < n) fill();
  return {buffer_.get() + begin_, std::min(n, end_ - begin_)};
}

std::string_view ByteSource::take(std::size_t n) {
  const std::string_view bytes = peek(n);
  begin_ += bytes.size();
  taken_ += bytes.size();
  return bytes;
}

bool ByteSource::skip(std::uint64_t n) {
  while (n > 0) {
    const std::size_t got = take(static_cast<std::size_t>(std::min<std::uint64_t>(n, block))).size();
    if (got == 0) return false;
    n -= got;
  }
  return true;
}

bool ByteSource::line(std::string_view& text) {
  const auto find_end = [&] { return std::memchr(buffer_.get() + begin_, '\n', end_ - begin_); };
  const void* stop = begin_ < end_ ? find_end() : nullptr;
  if (!stop) {
    fill();
    if (begin_ == end_) return false;
    stop = find_end();
  }
  ++line_;
  const char* first = buffer_.get() + begin_;
  const std::size_t length = stop ? static_cast<std::size_t>(static_cast<const char*>(stop) - first) : end_ - begin_;
  if (length > longest_line) refuse("the line is longer than " + std::to_string(longest_line) + " bytes");
  text = {first, length > 0 && first[length - 1] == '\r' ? length - 1 : length};
  begin_ += length + (stop ? 1 : 0);
  taken_ += length + (stop ? 1 : 0);
  return true;
}

bool ByteSource::content_line(std::string_view& text) {
  while (line(text)) {
    const std::string_view content = trimmed(text);
    if (!content.empty() && content.front() != '#') return true;
  }
  return false;
}

void ByteSource::refuse(const std::string& message) const {
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<int>::max());
  throw UserError(message, Location{path_, static_cast<int>(std::min(line_, most)), 0});
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string all;
  for (const char c : text.substr(0, longest)) all += c >= ' ' && c <= '~' ? c : '?';
  return all + (text.size() > longest ? "..." : "");
}

std::string shown(std::string_view text, std::size_t longest) {
  return "\"" + printable(text, longest) + "\"";
}

} // namespace flipbook
