// SPDX-License-Identifier: MIT
#include "app/validate/reference_data.h"

#include "sim/scene/assets.h"
#include "sim/scene/toml_reader.h"

#include <sstream>
#include <utility>

namespace flipbook::app {

ReferenceData reference_data(const std::string& name) {
  const auto path = find_asset_file("reference", name + ".csv");
  if (!path) throw MachineError("reference/" + name + ".csv is missing where the scenes are");
  std::istringstream in(read_text_file(*path));
  ReferenceData data;
  bool heading = true;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (std::exchange(heading, false)) continue;
    std::istringstream row(line);
    double x = 0, y = 0;
    char comma = 0;
    if (!(row >> x >> comma >> y) || comma != ',') throw UserError("two numbers were expected", {*path, number, 1});
    data.x.push_back(x);
    data.y.push_back(y);
  }
  if (data.x.size() < 2) throw UserError("a table of numbers was expected", {*path, 1, 1});
  return data;
}

} // namespace flipbook::app
