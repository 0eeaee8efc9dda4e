// SPDX-License-Identifier: MIT
#include "app/validate/reference_data.h"

#include "sim/files/number_table.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

namespace flipbook::app {

ReferenceData reference_data(const std::string& name) {
  const auto path = find_asset_file("reference", name + ".csv");
  if (!path) throw MachineError("reference/" + name + ".csv is missing where the scenes are");
  NumberTable table = read_number_table(*path);
  if (table.names.size() != 2 || table.columns.front().size() < 2)
    throw UserError("a table of two columns was expected", {*path, 1, 1});
  return {std::move(table.columns[0]), std::move(table.columns[1])};
}

} // namespace flipbook::app
