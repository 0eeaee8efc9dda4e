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

std::string relative_to(const fs::path& from, const fs::path& file) {
  std::error_code failed; // of what exists the real places are compared: ".." of a link is not where the link is
  const fs::path folder = fs::weakly_canonical(fs::absolute(from).parent_path(), failed);
  const fs::path target = fs::weakly_canonical(fs::absolute(file), failed);
  const fs::path relative = target.lexically_relative(folder);
  return relative.empty() ? target.string() : relative.string();
}

} // namespace flipbook::app
