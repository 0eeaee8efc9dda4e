// SPDX-License-Identifier: MIT
#include "sim/boundary/mesh_shape.h"

#include "sim/boundary/mesh_tree.h"
#include "sim/boundary/sign_cells.h"

#include <utility>

namespace flipbook {
namespace {

using Vector = Vec<3, double>;

Vector vector(const Point& p) {
  return {p[0], p[1], p[2]};
}

Eigen::AlignedBox3d box_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& x : mesh.vertices) box.extend(vector(x));
  return box;
}

/// Around the centre of the mesh, so that far from the world's origin nothing is lost to rounding.
std::vector<MeshTree::Triangle> centred(const Mesh& mesh, const Vector& centre) {
  std::vector<MeshTree::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  const auto at = [&](std::uint32_t v) -> Vector { return vector(mesh.vertices[v]) - centre; };
  for (const auto& t : mesh.triangles) triangles.push_back({at(t[0]), at(t[1]), at(t[2])});
  return triangles;
}

class MeshShape final : public Shape {
public:
  MeshShape(Mesh solid, bool middle)
      : mesh_(std::move(solid)), middle_(middle), box_(box_of(mesh_)), tree_(centred(mesh_, box_.center())),
        cells_(tree_) {}

  double distance(const Point& p, const Domain& domain) const override {
    const Vector x = in_tree(p, domain);
    const double d = tree_.distance(x);
    return inside(x) ? -d : d;
  }
  bool contains(const Point& p, const Domain& domain) const override { return inside(in_tree(p, domain)); }

  Bounds bounds(const Domain& domain) const override {
    Bounds b = Bounds::infinite();
    const Vector lo = box_.min() - to_mesh(domain), hi = box_.max() - to_mesh(domain);
    for (std::size_t d = 0; d < static_cast<std::size_t>(domain.dim); ++d) {
      b.lo[d] = lo[static_cast<Eigen::Index>(d)];
      b.hi[d] = hi[static_cast<Eigen::Index>(d)];
    }
    return b;
  }

  std::shared_ptr<const TriangleMesh> surface(const Domain& domain) const override {
    if (domain.dim == 2) return nullptr;
    auto drawn = std::make_shared<TriangleMesh>();
    for (const auto& x : mesh_.vertices) {
      const Vector p = vector(x) - to_mesh(domain);
      for (const double c : p) drawn->vertices.push_back(static_cast<float>(c));
    }
    for (const auto& t : mesh_.triangles) drawn->triangles.insert(drawn->triangles.end(), t.begin(), t.end());
    return drawn;
  }

private:
  [[nodiscard]] bool inside(const Vector& x) const {
    const SignCells::Side side = cells_.at(x);
    return side == SignCells::Side::passed ? tree_.winding(x) > 0.5 : side == SignCells::Side::inside;
  }

  [[nodiscard]] Vector in_tree(const Point& p, const Domain& domain) const {
    const Vector x(p[0], p[1], domain.dim == 2 ? domain.size[2] / 2 : p[2]);
    return x + to_mesh(domain) - box_.center();
  }

  /// What takes a point of the domain to the coordinates of the mesh.
  [[nodiscard]] Vector to_mesh(const Domain& domain) const {
    Vector shift = vector(domain.origin);
    if (middle_) shift[2] = -domain.size[2] / 2;
    return shift;
  }

  Mesh mesh_;
  bool middle_;
  Eigen::AlignedBox3d box_;
  MeshTree tree_; ///< its triangles are relative to the centre of the box
  SignCells cells_;
};

} // namespace

ShapePtr make_mesh_shape(Mesh solid, bool middle) {
  return std::make_shared<MeshShape>(std::move(solid), middle);
}

} // namespace flipbook
