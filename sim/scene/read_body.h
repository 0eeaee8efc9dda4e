// SPDX-License-Identifier: MIT
// A [[body]] of a scene: a shape by name and the velocity that the fluid inside starts with.
#pragma once

#include "sim/scene/scene.h"

#include <span>
#include <string_view>

namespace flipbook {

/// The shape is null where a mistake was made.
[[nodiscard]] Body read_body(const Node& table, Mistakes& mistakes);

/// One shape that a scene can name.
struct ShapeInfo {
  std::string_view name, keys, help;
};
[[nodiscard]] std::vector<ShapeInfo> list_shapes();

} // namespace flipbook
