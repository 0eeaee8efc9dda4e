// SPDX-License-Identifier: MIT
// What a particle remembers of its material's past, as far as its deformation does not say it.
#pragma once

#include <array>
#include <cstddef>

namespace flipbook {

/// Most numbers that any material remembers.
inline constexpr std::size_t most_memory = 2;
template <class T> using Memory = std::array<T, most_memory>;

} // namespace flipbook
