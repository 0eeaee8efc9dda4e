// SPDX-License-Identifier: MIT
#include "sim/files/surface_ply.h"

#include "sim/files/numbers.h"
#include "sim/files/particle_writers.h"
#include "sim/files/ply_header.h"

#include <algorithm>
#include <vector>

namespace flipbook {
namespace {

constexpr std::size_t vertex_bytes = 12, face_bytes = 13, edge_bytes = 8;

/// Rows of one element of a file of ours, checked against what is left of it.
std::size_t rows_of(const PlyHeader& header, std::size_t element, const char* name, std::size_t properties,
                    const ByteSource& file) {
  if (header.format != PlyHeader::Format::little || header.elements.size() != 3 ||
      header.elements[element].name != name || header.elements[element].properties.size() != properties)
    file.refuse("not the surface of a solid as a series has it");
  return static_cast<std::size_t>(std::min<std::uint64_t>(header.elements[element].rows, 1U << 30U));
}

template <class T> T next(const char*& p) {
  const T x = number_at<T>(p);
  p += sizeof x;
  return x;
}

std::string take(ByteSource& file, std::size_t bytes) {
  std::string all;
  while (all.size() < bytes) {
    const std::string_view part = file.take(std::min(ByteSource::block, bytes - all.size()));
    if (part.empty()) file.refuse("the file ends early");
    all.append(part);
  }
  return all;
}

} // namespace

std::string write_surface(const TriangleMesh& mesh, const std::array<double, 3>& origin) {
  const std::size_t vertices = mesh.vertices.size() / 3, faces = mesh.triangles.size() / 3,
                    edges = mesh.outline.size() / 2;
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment surface of a solid: metres\nelement vertex " +
                      std::to_string(vertices) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
                      "\nproperty list uchar uint vertex_indices\nelement edge " + std::to_string(edges) +
                      "\nproperty uint vertex1\nproperty uint vertex2\nend_header\n";
  const std::size_t begin = bytes.size();
  bytes.resize(begin + vertex_bytes * vertices + face_bytes * faces + edge_bytes * edges);
  char* p = bytes.data() + begin;
  for (std::size_t i = 0; i < 3 * vertices; ++i)
    put_bytes(p, static_cast<float>(static_cast<double>(mesh.vertices[i]) + origin[i % 3]));
  for (std::size_t f = 0; f < faces; ++f) {
    put_bytes(p, std::uint8_t{3});
    for (std::size_t c = 0; c < 3; ++c) put_bytes(p, mesh.triangles[3 * f + c]);
  }
  for (std::size_t i = 0; i < 2 * edges; ++i) put_bytes(p, mesh.outline[i]);
  return bytes;
}

TriangleMesh read_surface(const std::string& path, const std::array<double, 3>& origin) {
  ByteSource file(path);
  if (!file.peek(4).starts_with("ply")) file.refuse("not a PLY file: its first line must be \"ply\"");
  const PlyHeader header = read_ply_header(file);
  file.leave_text();
  const std::size_t vertices = rows_of(header, 0, "vertex", 3, file), faces = rows_of(header, 1, "face", 1, file),
                    edges = rows_of(header, 2, "edge", 2, file);
  const std::uint64_t bytes = vertex_bytes * vertices + face_bytes * faces + edge_bytes * edges;
  if (bytes != file.left())
    file.refuse("the rest of the file has " + std::to_string(file.left()) + " bytes, and its header promises " +
                std::to_string(bytes));
  const std::string data = take(file, static_cast<std::size_t>(bytes));
  const char* p = data.data();
  const auto vertex = [&] {
    const auto i = next<std::uint32_t>(p);
    if (i >= vertices) file.refuse("a vertex " + std::to_string(i) + " that the file does not have");
    return i;
  };
  TriangleMesh mesh;
  for (std::size_t i = 0; i < 3 * vertices; ++i)
    mesh.vertices.push_back(static_cast<float>(static_cast<double>(next<float>(p)) - origin[i % 3]));
  for (std::size_t f = 0; f < faces; ++f) {
    if (next<std::uint8_t>(p) != 3) file.refuse("a face that is no triangle");
    for (int c = 0; c < 3; ++c) mesh.triangles.push_back(vertex());
  }
  for (std::size_t i = 0; i < 2 * edges; ++i) mesh.outline.push_back(vertex());
  return mesh;
}

} // namespace flipbook
