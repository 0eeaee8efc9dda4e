// SPDX-License-Identifier: MIT
// The files that a scene names (particles, meshes), each read once and shared by all variants that are made from it.
#pragma once

#include "sim/frame/errors.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace flipbook {

class SceneFiles {
public:
  /// A path as a scene writes it, relative to the file that says so.
  [[nodiscard]] static std::string resolve(const std::string& path, const Location& where) {
    const std::filesystem::path p(path);
    return p.is_absolute() ? path : (std::filesystem::path(where.file).parent_path() / p).string();
  }

  /// The content of the file, by `load(path)` the first time that `kind` of it is asked for.
  template <class T, class Load>
  std::shared_ptr<const T> get(const std::string& kind, const std::string& path, Load&& load) {
    std::shared_ptr<const void>& slot = contents_[kind + ":" + path];
    if (!slot) slot = std::make_shared<const T>(load(path));
    return std::static_pointer_cast<const T>(slot);
  }

private:
  std::map<std::string, std::shared_ptr<const void>> contents_;
};

} // namespace flipbook
