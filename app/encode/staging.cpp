// SPDX-License-Identifier: MIT
#include "app/encode/staging.h"

#include "sim/frame/errors.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <system_error>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, int error) {
  throw MachineError("cannot write " + file.string() + ": " + std::generic_category().message(error));
}

} // namespace

Staging::Staging(const fs::path& folder) : folder_(folder.empty() ? fs::path(".") : folder) {
  std::error_code e;
  for (fs::path p = folder_; !p.empty() && !fs::exists(p, e); p = p.parent_path()) {
    made_.insert(made_.begin(), p);
    if (!p.has_relative_path()) break;
  }
  fs::create_directories(folder_, e);
  if (e) fail(folder_, e.value());
  std::string pattern = (folder_ / ".flipbook-XXXXXX").string();
  if (!mkdtemp(pattern.data())) fail(folder_, errno);
  hidden_ = pattern;
}

Staging::~Staging() {
  std::error_code ignored;
  fs::remove_all(hidden_, ignored);
  for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, ignored); // only where empty
}

void Staging::write(const std::string& name, std::span<const std::uint8_t> bytes, const char* mode) const {
  const auto close = [](std::FILE* f) { std::fclose(f); };
  std::unique_ptr<std::FILE, decltype(close)> f(std::fopen(file(name).c_str(), mode), close);
  if (!f) fail(folder_ / name, errno);
  if (std::fwrite(bytes.data(), 1, bytes.size(), f.get()) != bytes.size()) fail(folder_ / name, errno);
  if (std::fclose(f.release()) != 0) fail(folder_ / name, errno);
}

static std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void Staging::write(const std::string& name, std::span<const std::uint8_t> bytes) const {
  write(name, bytes, "wb");
}

void Staging::write(const std::string& name, std::string_view text) const {
  write(name, bytes_of(text), "wb");
}

void Staging::append(const std::string& name, std::string_view text) const {
  write(name, bytes_of(text), "ab");
}

void Staging::commit() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(hidden_)) files.push_back(entry.path().filename());
  std::sort(files.begin(), files.end());
  for (const fs::path& name : files) {
    std::error_code e;
    fs::rename(hidden_ / name, folder_ / name, e);
    if (e) fail(folder_ / name, e.value());
  }
  made_.clear();
}

void write_file(const fs::path& file, std::string_view text) {
  if (!file.has_filename()) fail(file, EISDIR);
  Staging staging(file.parent_path());
  staging.write(file.filename().string(), text);
  staging.commit();
}

} // namespace flipbook::app
