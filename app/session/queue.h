// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace flipbook::app {

/// What an item counts for in a queue of `limit` bytes: being more than eight items ahead serves nobody, however small
/// they are.
[[nodiscard]] constexpr std::size_t queue_charge(std::size_t bytes, std::size_t limit) {
  return bytes > limit / 8 ? bytes : limit / 8;
}

} // namespace flipbook::app
