// SPDX-License-Identifier: MIT
// One mesh in all the formats that are read.
#pragma once

#include "sim/files/mesh.h"
#include "tests/unit/mesh_shapes.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace flipbook {

template <class T> std::string bytes_of_number(T value, bool big = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

inline std::string stl_text(const Mesh& mesh) {
  std::string text = "solid facet of a mesh\n";
  for (const auto& t : mesh.triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const auto v : t) {
      text += "      vertex";
      for (const double c : mesh.vertices[v]) text += " " + std::to_string(c) + (c == 0.25 ? "e0" : "");
      text += "\r\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid\n";
}

inline std::string stl_binary(const Mesh& mesh) {
  std::string bytes = "solid but binary";
  bytes.resize(80, ' ');
  bytes += bytes_of_number(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    bytes += std::string(12, '\0');
    for (const auto v : t)
      for (const double c : mesh.vertices[v]) bytes += bytes_of_number(static_cast<float>(c));
    bytes += "\x7f\x80";
  }
  return bytes;
}

inline std::string ply_text(const Mesh& mesh) {
  std::string text =
      "ply\nformat ascii 1.0\ncomment made by hand\nelement material 1\nproperty list uchar float stuff\n"
      "element vertex " +
      std::to_string(mesh.vertices.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement face " +
      std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n2 0.5 1\n";
  for (const auto& x : mesh.vertices)
    text += std::to_string(x[0]) + " " + std::to_string(x[1]) + " " + std::to_string(x[2]) + " 255\n";
  for (const auto& t : mesh.triangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  return text;
}

inline std::string ply_binary(const Mesh& mesh, bool big) {
  std::string bytes =
      std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\nelement vertex " +
      std::to_string(mesh.vertices.size()) +
      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
      std::to_string(mesh.triangles.size()) +
      "\nproperty list uchar uint vertex_index\nproperty short flags\nelement edge 1\nproperty int a\nend_header\n";
  for (const auto& x : mesh.vertices)
    for (const double c : x) bytes += bytes_of_number(c, big);
  for (const auto& t : mesh.triangles) {
    bytes += '\3';
    for (const auto v : t) bytes += bytes_of_number(v, big);
    bytes += bytes_of_number(std::int16_t{-7}, big);
  }
  return bytes + bytes_of_number(std::int32_t{3}, big);
}

/// Name and content.
inline std::vector<std::pair<std::string, std::string>> mesh_files(const Mesh& mesh) {
  return {{"m.obj", obj_text(mesh)},    {"text.stl", stl_text(mesh)},        {"binary.stl", stl_binary(mesh)},
          {"text.ply", ply_text(mesh)}, {"big.ply", ply_binary(mesh, true)}, {"little.ply", ply_binary(mesh, false)}};
}

} // namespace flipbook
