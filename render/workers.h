// SPDX-License-Identifier: MIT
// How drawing borrows the program's threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace flipbook::render {

/// Calls body(0), ..., body(chunks - 1), each once, on any threads and in any order, and returns when all are done.
/// Empty: the calling thread does it. What is drawn never depends on it.
using Workers = std::function<void(int chunks, const std::function<void(int)>& body)>;

/// body(begin, end) over [0, count) in pieces of `grain`, whose limits depend on nothing else.
template <class Body> void in_pieces(const Workers& workers, std::size_t count, std::size_t grain, Body&& body) {
  const auto piece = [&](int i) {
    const std::size_t begin = static_cast<std::size_t>(i) * grain;
    body(begin, std::min(begin + grain, count));
  };
  const int pieces = static_cast<int>((count + grain - 1) / grain);
  if (workers && pieces > 1)
    workers(pieces, piece);
  else
    for (int i = 0; i < pieces; ++i) piece(i);
}

} // namespace flipbook::render
