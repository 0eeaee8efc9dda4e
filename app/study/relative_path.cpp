// SPDX-License-Identifier: MIT
#include "app/study/relative_path.h"

#include <system_error>

namespace flipbook::app {

namespace fs = std::filesystem;

std::string relative_path(const fs::path& file, const fs::path& folder) {
  std::error_code failed;
  const fs::path target = fs::weakly_canonical(fs::absolute(file), failed);
  const fs::path relative = target.lexically_relative(fs::weakly_canonical(fs::absolute(folder), failed));
  return (relative.empty() ? target : relative).generic_string();
}

} // namespace flipbook::app
