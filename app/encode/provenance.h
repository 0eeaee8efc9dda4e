// SPDX-License-Identifier: MIT
// What a picture says about itself: enough to make the same picture again, and nothing else (no path, no clock, no
// number of threads, no GL context, no instruction set), so that equal runs give equal bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace flipbook::app {

/// The part that all pictures of a run share.
struct RunProvenance {
  std::string study;        ///< the full study as TOML
  std::string seeds;        ///< "1", or the seed of each pane where they differ: "1, 2, 3"
  std::string mistake = {}; ///< made on purpose: "WITH A MISTAKE: ..."; empty in a normal run
};

struct Provenance {
  std::shared_ptr<const RunProvenance> run;
  std::uint64_t frame = 0;
  double time = 0;      ///< seconds simulated
  std::string variants; ///< pane titles in this picture, one a line
};

using TextEntries = std::vector<std::pair<std::string, std::string>>;

/// Keyword and text, in a fixed order: flipbook:version, flipbook:frame, flipbook:time, ...
[[nodiscard]] TextEntries text_entries(const Provenance& p);

[[nodiscard]] std::string version(); ///< "0.1.0"

} // namespace flipbook::app
