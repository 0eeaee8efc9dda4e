// SPDX-License-Identifier: MIT
#include "sim/scene/assets.h"

#include "sim/scene/scene_files.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace flipbook {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> roots() {
  std::vector<fs::path> all;
  if (const char* chosen = std::getenv("FLIPBOOK_ASSETS"); chosen && *chosen) all.emplace_back(chosen);
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  if (!none) all.push_back((program.parent_path() / FLIPBOOK_ASSETS_FROM_PROGRAM).lexically_normal());
  all.emplace_back(FLIPBOOK_SOURCE_ASSETS);
  return all;
}

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none) || fs::is_character_file(path, none) || fs::is_fifo(path, none);
}

} // namespace

bool is_path(const std::string& name_or_path) {
  return name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
}

std::optional<std::string> find_asset(std::string_view folder, const std::string& name_or_path,
                                      const std::string& base) {
  if (is_path(name_or_path)) {
    fs::path path(name_or_path);
    if (path.is_relative() && !base.empty()) path = fs::path(base) / path;
    return is_file(path) ? std::optional(path.string()) : std::nullopt;
  }
  return find_asset_file(folder, name_or_path + ".toml");
}

std::optional<std::string> find_asset_file(std::string_view folder, const std::string& name) {
  for (const fs::path& root : roots())
    if (const fs::path path = root / folder / name; is_file(path)) return path.string();
  return std::nullopt;
}

std::string find_input(std::string_view folder, const std::string& written, const Location& where) {
  if (written.empty()) throw UserError("\"file\" must name a file", where);
  const std::string first = SceneFiles::resolve(written, where);
  const fs::path name = fs::path(written).filename();
  std::vector<fs::path> tried{first}, all;
  const fs::path beside = fs::path(where.file).parent_path() / name;
  if (beside != tried.front() && !name.empty()) tried.push_back(beside);
  all = tried;
  for (const fs::path& root : roots())
    if (!name.empty()) all.push_back(root / folder / name);
  std::error_code none;
  for (const fs::path& path : all)
    if (fs::exists(path, none)) return path.string();
  std::string paths;
  for (const fs::path& path : tried) paths.append(paths.empty() ? "" : " and ").append(path.string());
  throw UserError("there is no file \"" + written + "\" (looked for " + paths +
                      "); put it beside the scene or study that names it",
                  where);
}

std::vector<std::string> list_assets(std::string_view folder) {
  std::vector<std::string> names;
  for (const fs::path& root : roots()) {
    std::error_code none;
    for (fs::directory_iterator at(root / folder, none), end; !none && at != end; at.increment(none))
      if (at->path().extension() == ".toml") names.push_back(at->path().stem().string());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string stem(const std::string& path) {
  return fs::path(path).stem().string();
}

} // namespace flipbook
