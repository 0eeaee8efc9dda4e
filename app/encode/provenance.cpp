// SPDX-License-Identifier: MIT
#include "app/encode/provenance.h"

#include "sim/frame/parameters.h"

namespace flipbook::app {

std::string version() {
  return FLIPBOOK_VERSION;
}

std::string build_level() {
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512VL__)
  return "x86-64-v4";
#elif defined(__AVX2__) && defined(__FMA__)
  return "x86-64-v3";
#elif defined(__SSE4_2__)
  return "x86-64-v2";
#elif defined(__x86_64__)
  return "x86-64";
#elif defined(__aarch64__)
  return "aarch64";
#else
  return "generic";
#endif
}

TextEntries text_entries(const Provenance& p) {
  // Bytes are promised for one instruction-set level, so the level belongs to the version.
  TextEntries entries{{"flipbook:version", version() + " " + build_level()},
                      {"flipbook:frame", std::to_string(p.frame)},
                      {"flipbook:time", to_toml(Value(p.time))},
                      {"flipbook:seed", p.run->seeds},
                      {"flipbook:variants", p.variants},
                      {"flipbook:study", p.run->study}};
  if (!p.run->mistake.empty()) entries.insert(entries.begin(), {"flipbook:mistake", p.run->mistake});
  return entries;
}

} // namespace flipbook::app
