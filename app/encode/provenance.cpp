// SPDX-License-Identifier: MIT
#include "app/encode/provenance.h"

#include "sim/frame/parameters.h"

namespace flipbook::app {

std::string version() {
  return FLIPBOOK_VERSION;
}

TextEntries text_entries(const Provenance& p) {
  TextEntries entries{{"flipbook:version", version()},           {"flipbook:frame", std::to_string(p.frame)},
                      {"flipbook:time", to_toml(Value(p.time))}, {"flipbook:seed", p.run->seeds},
                      {"flipbook:variants", p.variants},         {"flipbook:study", p.run->study}};
  if (!p.run->mistake.empty()) entries.insert(entries.begin(), {"flipbook:mistake", p.run->mistake});
  return entries;
}

} // namespace flipbook::app
