// SPDX-License-Identifier: MIT
// The rules that a compiler does not enforce, read from the sources: which folder may include which, how long a file
// may be, and that every file says its licence.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = FLIPBOOK_SOURCE_DIR;

struct Source {
  std::string path; ///< relative to the root, with forward slashes
  std::vector<std::string> lines;
};

std::vector<Source> sources(const std::vector<std::string>& folders) {
  std::vector<Source> found;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (!entry.is_regular_file() || (extension != ".h" && extension != ".cpp")) continue;
      Source s{fs::relative(entry.path(), root).generic_string(), {}};
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) s.lines.push_back(line);
      found.push_back(std::move(s));
    }
  std::sort(found.begin(), found.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
  return found;
}

/// "sim/transfer/pic.h" -> "sim/transfer"; "render/renderer.h" -> "render"; "sim/simulation.h" -> "sim".
std::string layer_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().generic_string();
  for (const char* top : {"render", "app"})
    if (folder == top || folder.starts_with(std::string(top) + "/")) return top;
  return folder;
}

/// What each layer may include besides itself. An edge that is not here is an error; so is a layer that is not here.
const std::map<std::string, std::vector<std::string>> allowed = {
    {"sim/frame", {}},
    {"sim/core", {"sim/frame"}},
    {"sim/kernels", {"sim/frame", "sim/core"}},
    {"sim/transfer", {"sim/frame", "sim/core", "sim/kernels"}},
    {"sim/files", {"sim/frame"}},
    {"sim/boundary", {"sim/frame", "sim/core", "sim/files"}},
    {"sim/materials", {"sim/frame", "sim/core"}},
    {"sim/scene",
     {"sim/frame", "sim/core", "sim/kernels", "sim/transfer", "sim/files", "sim/boundary", "sim/materials"}},
    {"sim/diagnostics", {"sim/frame", "sim/core", "sim/kernels", "sim/transfer"}},
    {"sim/fluid",
     {"sim/frame", "sim/core", "sim/kernels", "sim/transfer", "sim/boundary", "sim/scene", "sim/diagnostics",
      "sim/files", "sim"}},
    {"sim/mpm",
     {"sim/frame", "sim/core", "sim/kernels", "sim/transfer", "sim/boundary", "sim/materials", "sim/scene",
      "sim/diagnostics", "sim/files", "sim/fluid", "sim"}},
    {"sim/transfer_only",
     {"sim/frame", "sim/core", "sim/kernels", "sim/transfer", "sim/scene", "sim/diagnostics", "sim/files", "sim/fluid",
      "sim"}},
    {"sim/museum", // only the program leads there, never a solver
     {"sim/frame", "sim/core", "sim/kernels", "sim/transfer", "sim/scene", "sim/diagnostics", "sim/fluid", "sim"}},
    {"sim/tutorial", {"sim/frame", "sim/core", "sim/transfer", "sim/boundary", "sim/scene", "sim/files", "sim"}},
    {"sim",
     {"sim/frame", "sim/core", "sim/kernels", "sim/transfer", "sim/boundary", "sim/scene", "sim/diagnostics",
      "sim/files", "sim/fluid", "sim/mpm", "sim/transfer_only", "sim/tutorial"}},
    {"render", {"sim/frame"}},
    {"app",
     {"sim/frame", "sim/core", "sim/kernels", "sim/transfer", "sim/boundary", "sim/scene", "sim/diagnostics", "sim",
      "sim/files", "render", "sim/museum", "sim/materials", "sim/mpm"}},
};

TEST(Architecture, IncludesFollowTheLayers) {
  const std::regex include(R"re(^\s*#include "((?:sim|render|app|tests)/[^"]+)")re");
  for (const Source& s : sources({"sim", "render", "app"})) {
    const std::string from = layer_of(s.path);
    ASSERT_TRUE(allowed.contains(from)) << s.path << ": a layer without a rule; add it to the table";
    for (std::size_t i = 0; i < s.lines.size(); ++i) {
      std::smatch m;
      if (!std::regex_search(s.lines[i], m, include)) continue;
      EXPECT_TRUE(fs::exists(root / m[1].str())) << s.path << ":" << i + 1 << ": " << m[1];
      const std::string to = layer_of(m[1].str());
      const auto& ok = allowed.at(from);
      EXPECT_TRUE(to == from || std::find(ok.begin(), ok.end(), to) != ok.end())
          << s.path << ":" << i + 1 << ": " << from << " may not include " << to;
    }
  }
}

TEST(Architecture, TheFramePartIsStandardCppOnly) {
  const std::regex system_header(R"re(^\s*#include <([a-z_0-9]+)>)re");
  const std::regex any(R"re(^\s*#include)re");
  const std::regex own(R"re(^\s*#include "sim/frame/)re");
  for (const Source& s : sources({"sim/frame"}))
    for (std::size_t i = 0; i < s.lines.size(); ++i)
      if (std::regex_search(s.lines[i], any)) {
        EXPECT_TRUE(std::regex_search(s.lines[i], system_header) || std::regex_search(s.lines[i], own))
            << s.path << ":" << i + 1 << ": " << s.lines[i];
      }
}

TEST(Architecture, FilesAreShortAndLicensed) {
  for (const Source& s : sources({"sim", "render", "app", "tests"})) {
    ASSERT_FALSE(s.lines.empty()) << s.path;
    EXPECT_EQ(s.lines.front(), "// SPDX-License-Identifier: MIT") << s.path;
    EXPECT_LE(s.lines.size(), 400u) << s.path << " is long: split it by concept";
    for (std::size_t i = 0; i < s.lines.size(); ++i) {
      EXPECT_EQ(s.lines[i].find('\t'), std::string::npos) << s.path << ":" << i + 1 << ": a tab";
      EXPECT_EQ(s.lines[i].find("TO"
                                "DO"),
                std::string::npos)
          << s.path << ":" << i + 1 << ": unfinished";
    }
  }
}

TEST(Architecture, NothingIsTwinnedByDimension) {
  // A file that exists once for 2D and once for 3D is the field's commonest flaw.
  const std::regex twin(R"re((.*)[_-]?2[dD]?\.(h|cpp)$)re");
  for (const Source& s : sources({"sim", "render", "app"})) {
    std::smatch m;
    if (!std::regex_match(s.path, m, twin)) continue;
    for (const char* three : {"3", "3d", "3D", "_3d", "_3"})
      EXPECT_FALSE(fs::exists(root / (m[1].str() + three + "." + m[2].str()))) << s.path;
  }
}

TEST(Architecture, EverySchemeAndKernelHeaderSaysItsFormula) {
  for (const Source& s : sources({"sim/kernels", "sim/transfer"})) {
    if (!s.path.ends_with(".h")) continue;
    const bool comment = s.lines.size() > 1 && s.lines[1].starts_with("//");
    EXPECT_TRUE(comment) << s.path << ": the second line must say what it is";
  }
}

} // namespace
