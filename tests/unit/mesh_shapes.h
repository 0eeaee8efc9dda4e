// SPDX-License-Identifier: MIT
// Meshes of known solids, for tests. All of them turn outwards.
#pragma once

#include "sim/files/mesh.h"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <string>

namespace flipbook {

inline void append(Mesh& mesh, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

inline Mesh turned_inside_out(Mesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline Mesh box_mesh(const std::array<double, 3>& lo, const std::array<double, 3>& hi) {
  Mesh mesh;
  for (unsigned v = 0; v < 8; ++v)
    mesh.vertices.push_back({(v & 1U) ? hi[0] : lo[0], (v & 2U) ? hi[1] : lo[1], (v & 4U) ? hi[2] : lo[2]});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

inline Mesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// n x m quadrilaterals that close in both directions, around the z axis.
inline Mesh torus_mesh(double R, double r, std::uint32_t n, std::uint32_t m) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m, s = R + r * std::cos(b);
      mesh.vertices.push_back({s * std::cos(a), s * std::sin(a), r * std::sin(b)});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % n * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// A grid of n x m places on the unit sphere, with a fan at each pole.
inline Mesh sphere_mesh(std::uint32_t n, std::uint32_t m) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t i = 1; i < m; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const double a = std::numbers::pi * i / m, b = 2 * std::numbers::pi * j / n;
      mesh.vertices.push_back({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return 2 + (i - 1) * n + j % n; };
  for (std::uint32_t j = 0; j < n; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    mesh.triangles.push_back({1, at(m - 1, j + 1), at(m - 1, j)});
    for (std::uint32_t i = 1; i + 1 < m; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

inline std::string obj_text(const Mesh& mesh) {
  std::string text;
  for (const auto& x : mesh.vertices)
    text += "v " + std::to_string(x[0]) + " " + std::to_string(x[1]) + " " + std::to_string(x[2]) + "\n";
  for (const auto& t : mesh.triangles)
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
  return text;
}

} // namespace flipbook
