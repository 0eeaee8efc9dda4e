// SPDX-License-Identifier: MIT
#include "sim/files/read_mesh.h"

#include "sim/files/mesh_screen.h"
#include "sim/frame/errors.h"
#include "sim/frame/text.h"

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iterator>
#include <memory>
#include <new>
#include <numeric>

namespace flipbook {
namespace {

constexpr std::uint64_t most_bytes = 1ULL << 31U;

std::string extension_of(const std::string& path) {
  std::string extension = lower(std::filesystem::path(path).extension().string());
  if (std::find(std::begin(mesh_extensions), std::end(mesh_extensions), extension) == std::end(mesh_extensions))
    throw UserError("\"" + path + "\" is not a mesh by its name: .obj, .stl and .ply files are read");
  return extension;
}

std::string screened(const std::string& path, const std::string& extension) {
  ByteSource file(path);
  if (file.left() > most_bytes)
    throw UserError("cannot read \"" + path + "\": it is too large for a mesh; at most 2 GiB are supported");
  if (file.peek(3) == "\xEF\xBB\xBF") (void)file.take(3); // a UTF-8 mark
  if (extension == ".obj") return screen_obj(file);
  return extension == ".stl" ? screen_stl(file) : screen_ply(file);
}

/// Takes every other parser away, so that the content cannot choose one.
void keep_only(Assimp::Importer& importer, const std::string& extension) {
  Assimp::BaseImporter* wanted = importer.GetImporter(extension.c_str());
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;)
    if (Assimp::BaseImporter* other = importer.GetImporter(i); other != wanted) {
      importer.UnregisterLoader(other);
      delete other; // its owner after that is whoever took it out
    }
}

Mesh collect(const aiScene& scene) {
  Mesh mesh;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    const std::size_t first = mesh.vertices.size();
    for (unsigned v = 0; v < part.mNumVertices; ++v)
      mesh.vertices.push_back({part.mVertices[v].x, part.mVertices[v].y, part.mVertices[v].z});
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue; // a point or a line
      std::array<std::uint32_t, 3> t{};
      for (std::size_t k = 0; k < 3; ++k) t[k] = static_cast<std::uint32_t>(first + face.mIndices[k]);
      if (std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return v < mesh.vertices.size(); }))
        mesh.triangles.push_back(t);
    }
  }
  return mesh;
}

Mesh parse(const std::string& bytes, const std::string& path, const std::string& extension) try {
  Assimp::Importer importer;
  keep_only(importer, extension);
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate,
                                                     extension.c_str() + 1); // its parser is told by the name
  if (!scene) throw UserError("cannot read \"" + path + "\": " + shown(importer.GetErrorString()));
  return collect(*scene);
} catch (const UserError&) {
  throw;
} catch (const std::bad_alloc&) {
  throw MachineError("cannot read \"" + path + "\": out of memory");
} catch (const std::exception& error) {
  throw UserError("cannot read \"" + path + "\": " + shown(error.what()));
}

/// One vertex for each place, in the order of their first appearance: STL lists each corner anew, and the others
/// do so along the seams of a texture.
void weld(Mesh& mesh) {
  auto& x = mesh.vertices;
  for (auto& p : x)
    for (double& c : p) c += 0.0; // -0 is the same place as 0
  std::vector<std::uint32_t> order(x.size()), place(x.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return x[a] != x[b] ? x[a] < x[b] : a < b; });
  for (std::size_t i = 0; i < order.size(); ++i)
    place[order[i]] = i > 0 && x[order[i]] == x[order[i - 1]] ? place[order[i - 1]] : order[i];
  std::vector<std::uint32_t> number(x.size());
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < x.size(); ++v) {
    number[v] = place[v] == v ? kept : number[place[v]];
    if (place[v] == v) x[kept++] = x[v];
  }
  x.resize(kept);
  for (auto& t : mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
  std::erase_if(mesh.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

} // namespace

Mesh read_mesh(const std::string& path) {
  const std::string extension = extension_of(path);
  Mesh mesh = parse(screened(path, extension), path, extension);
  for (const auto& p : mesh.vertices)
    if (!std::isfinite(p[0] + p[1] + p[2])) throw UserError("\"" + path + "\" has a vertex that is not finite");
  weld(mesh);
  if (mesh.triangles.empty()) throw UserError("\"" + path + "\" has no triangles");
  return mesh;
}

} // namespace flipbook
