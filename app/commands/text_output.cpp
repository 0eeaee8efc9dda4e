// SPDX-License-Identifier: MIT
#include "app/commands/text_output.h"

#include "sim/frame/errors.h"

namespace flipbook::app {

namespace fs = std::filesystem;

fs::path toml_path(const std::string& output, const std::string& name) {
  const std::string file = name + ".toml";
  std::error_code none;
  if (output.empty()) return file;
  if (output.ends_with('/') || fs::is_directory(output, none)) return fs::path(output) / file;
  if (!output.ends_with(".toml")) throw UserError("-o " + output + ": a name ends in .toml, or in / for a folder");
  return output;
}

void refuse_to_replace(const fs::path& file, bool force) {
  std::error_code none;
  if (!force && fs::exists(fs::symlink_status(file, none)))
    throw UserError(file.string() + " exists; --force replaces it");
}

void replace_all(std::string& text, const std::string& mark, const std::string& by) {
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + by.size()))
    text.replace(at, mark.size(), by);
}

} // namespace flipbook::app
