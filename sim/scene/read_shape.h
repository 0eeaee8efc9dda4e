// SPDX-License-Identifier: MIT
// A shape by name, as bodies, obstacles and shapes of shapes write it: { shape = "ball", centre = [..], radius = .. }.
#pragma once

#include "sim/boundary/shape.h"
#include "sim/scene/scene_files.h"
#include "sim/scene/toml_reader.h"

#include <span>
#include <string_view>
#include <vector>

namespace flipbook {

/// Null where a mistake was made. `also`: keys of the same table that belong to whoever asks.
[[nodiscard]] ShapePtr read_shape(const Node& table, std::span<const std::string_view> also, SceneFiles& files,
                                  Mistakes& mistakes);

/// Two or three coordinates as a scene lists them.
[[nodiscard]] Listed listed(const std::vector<double>& numbers);

/// One shape that a scene can name.
struct ShapeInfo {
  std::string_view name, keys, help;
};
[[nodiscard]] std::vector<ShapeInfo> list_shapes();

} // namespace flipbook
