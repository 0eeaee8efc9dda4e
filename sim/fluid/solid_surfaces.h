// SPDX-License-Identifier: MIT
// The obstacles of a run as a snapshot has them: where each of those in the domain stands, and its surface, which is
// found once.
#pragma once

#include "sim/fluid/solids.h"
#include "sim/fluid/walls.h"
#include "sim/frame/mesh.h"

#include <memory>
#include <vector>

namespace flipbook {

class SolidSurfaces {
public:
  /// Always of the same obstacles.
  template <int Dim, class Real>
  [[nodiscard]] std::vector<Solid> standing(const Solids<Dim, Real>& solids, const Walls<Dim, Real>& walls,
                                            const Domain& domain);

private:
  std::vector<std::shared_ptr<const TriangleMesh>> surfaces_; ///< of each obstacle, once it has been asked for
};

} // namespace flipbook
