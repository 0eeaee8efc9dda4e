// SPDX-License-Identifier: MIT
// Mesh files that were cut, changed or made to do harm: each is refused in one line that names it, quickly and in
// little memory.
#include "sim/boundary/mesh_check.h"
#include "sim/core/random.h"
#include "sim/files/read_mesh.h"
#include "tests/unit/mesh_files.h"
#include "tests/unit/message.h"
#include "tests/unit/temporary_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <sys/stat.h>

namespace flipbook {
namespace {

/// What is said of a file; its path becomes M.
std::string read(const std::string& name, const std::string& content) {
  const TemporaryFile file(name, content);
  std::string message = message_of([&] {
    Mesh mesh = read_mesh(file.path());
    make_solid(mesh, "\"" + file.path() + "\"");
  });
  const std::size_t at = message.find(file.path());
  if (at != std::string::npos) message.replace(at, file.path().size(), "M");
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) ADD_FAILURE() << what;
  return text.replace(at, what.size(), by);
}

TEST(HostileMesh, IsNotOne) {
  EXPECT_EQ(read("m.fbx", "x"), "\"M\" is not a mesh by its name: .obj, .stl and .ply files are read");
  EXPECT_EQ(read("m", "x"), "\"M\" is not a mesh by its name: .obj, .stl and .ply files are read");
  EXPECT_EQ(read("m.obj", " "), "M: it has no faces");
  EXPECT_EQ(read("m.obj", "<html>\n"), "M: it has no faces");
  EXPECT_EQ(read("m.stl", "<html>\n"),
            "M: it is neither a text that begins with \"solid\" nor long enough for a binary STL file");
  EXPECT_EQ(read("m.stl", "solid\nendsolid\n"), "M: it has no triangles");
  EXPECT_EQ(read("m.stl", std::string(84, '\0')), "M: it has no triangles");
  EXPECT_EQ(read("m.ply", "solid\n"), "M:1: not a PLY file: its first line must be \"ply\"");
  EXPECT_EQ(message_of([] { (void)read_mesh("/nonexistent/a.obj"); }),
            "cannot read \"/nonexistent/a.obj\": No such file or directory");
}

TEST(HostileMesh, IsEmptyAFolderOrAPipe) {
  const TemporaryFile empty("m.obj"), folder("folder.ply"), pipe("pipe.stl");
  EXPECT_EQ(message_of([&] { (void)read_mesh(empty.path()); }),
            "cannot read \"" + empty.path() + "\": No such file or directory");
  std::filesystem::create_directory(folder.path());
  EXPECT_EQ(message_of([&] { (void)read_mesh(folder.path()); }),
            "cannot read \"" + folder.path() + "\": it is not a regular file");
  ASSERT_EQ(mkfifo(pipe.path().c_str(), 0600), 0);
  EXPECT_EQ(message_of([&] { (void)read_mesh(pipe.path()); }),
            "cannot read \"" + pipe.path() + "\": it is not a regular file");
}

TEST(HostileMesh, ObjNamesTheLine) {
  const std::string good = obj_text(tetrahedron());
  EXPECT_EQ(read("m.obj", good), "no error");
  EXPECT_EQ(read("m.obj", good + "f 1 2 5\n"), "M: a face has the vertex 5, but there are 4");
  EXPECT_EQ(read("m.obj", good + "f 1 2 99999999999999999999\n"),
            "M:9: a corner of a face must be a number of a vertex, not \"99999999999999999999\"");
  EXPECT_EQ(read("m.obj", good + "f 1 2 -5\n"), "M:9: the vertex \"-5\" does not exist");
  EXPECT_EQ(read("m.obj", good + "f 0 1 2\n"), "M:9: a corner of a face must be a number of a vertex, not \"0\"");
  EXPECT_EQ(read("m.obj", good + "f 1 2\n"), "M:9: a face must have at least three corners");
  EXPECT_EQ(read("m.obj", "v 0 nan 0\n" + good), "M:1: a coordinate must be a finite number, not \"nan\"");
  EXPECT_EQ(read("m.obj", "v 0 1e999 0\n" + good), "M:1: a coordinate must be a finite number, not \"1e999\"");
  EXPECT_EQ(read("m.obj", "v 0 1\n" + good), "M:1: a vertex must have three coordinates");
  EXPECT_EQ(read("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1\nl 1 2 3\n"), "M: it has no faces");
  EXPECT_EQ(read("m.obj", "mtllib m.obj\nmtllib /dev/zero\ncall m.obj\n" + good), "no error")
      << "nothing else is opened";
  EXPECT_EQ(read("m.obj", "v 0 1e39 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n"), "\"M\" has a vertex that is not finite")
      << "too large for single precision, in which the library reads";
}

TEST(HostileMesh, StlMustHoldWhatItAnnounces) {
  const std::string binary = stl_binary(tetrahedron()), text = stl_text(tetrahedron());
  EXPECT_EQ(read("m.stl", binary), "no error");
  EXPECT_EQ(read("m.stl", binary + "trailing"), "M: it has no triangles") << "it begins with \"solid\": a text";
  EXPECT_EQ(read("m.stl", "x" + binary.substr(1) + "trailing"), "no error");
  EXPECT_EQ(read("m.stl", "x" + binary.substr(1, 120)), "M: it announces 4 triangles but ends after 0");
  std::string huge = "x" + binary.substr(1);
  huge.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(read("m.stl", huge), "M: 4294967295 triangles are too many; at most 10000000 are supported");
  huge.replace(80, 4, std::string("\x00\x00\x80\x00", 4));
  EXPECT_EQ(read("m.stl", huge), "M: it announces 8388608 triangles but ends after 4");
  std::string not_finite = binary;
  not_finite.replace(96, 4, bytes_of_number(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(read("m.stl", not_finite), "\"M\" has a vertex that is not finite");
  EXPECT_EQ(read("m.stl", text), "no error");
  EXPECT_NE(read("m.stl", text.substr(0, text.size() / 2)), "no error");
  EXPECT_EQ(read("m.stl", text.substr(0, text.size() - 70)), "M: it ends within a facet");
  EXPECT_EQ(read("m.stl", replaced(text, "vertex 0", "vertex inf")),
            "M:4: a coordinate must be a finite number, not \"inf.000000\"");
  EXPECT_EQ(read("m.stl", replaced(text, "vertex", "corner")), "M:7: a facet must have three vertices");
}

TEST(HostileMesh, PlyMustHoldWhatItAnnounces) {
  const std::string text = ply_text(tetrahedron()), binary = ply_binary(tetrahedron(), false);
  EXPECT_EQ(read("m.ply", text), "no error");
  EXPECT_EQ(read("m.ply", binary), "no error");
  EXPECT_EQ(read("m.ply", replaced(text, "vertex 4", "vertex 20000000")).substr(0, 69),
            "M:13: the element \"vertex\" promises 20000000 rows, which the rest of ");
  EXPECT_EQ(read("m.ply", replaced(text, "vertex 4", "vertex 4000000000")),
            "M:13: 4000000000 vertices are too many; at most 30000000 are supported");
  EXPECT_EQ(read("m.ply", replaced(text, "vertex 4", "vertex 18446744073709551616")).substr(0, 35),
            "M:6: an element's count must be a n");
  EXPECT_EQ(read("m.ply", replaced(binary, "face 4", "face 4000000")).substr(0, 64),
            "M: the element \"face\" promises 4000000 rows, which the rest of t");
  EXPECT_EQ(read("m.ply", replaced(text, "\n3 0 2 1", "\n4000000000 0 2 1")),
            "M:19: a list must have 0 to 4096 entries");
  EXPECT_EQ(read("m.ply", replaced(text, "\n3 0 2 1", "\n4 0 2 1")), "M:19: the row is too short");
  EXPECT_EQ(read("m.ply", replaced(text, "\n3 0 2 1", "\n3 0 2 4")),
            "M:19: a face has the vertex 4, but there are 4, counted from 0");
  EXPECT_EQ(read("m.ply", replaced(text, "\n3 0 2 1", "\n3 0 2 -1")).substr(0, 32), "M:19: a face has the vertex -1, ");
  EXPECT_EQ(read("m.ply", replaced(text, "\n3 0 2 1", "\n2 0 2")), "M:19: a face must have at least three corners");
  EXPECT_EQ(read("m.ply", replaced(text, "property float y\n", "")),
            "M:12: the element \"vertex\" needs one property \"y\"");
  EXPECT_EQ(read("m.ply", replaced(text, "vertex_indices", "corners")),
            "M:13: the element \"face\" needs one list \"vertex_indices\"");
  EXPECT_EQ(read("m.ply", replaced(text, "element face", "element tristrips")),
            "M:13: a mesh needs an element \"vertex\" and after it an element \"face\"");
  EXPECT_EQ(read("m.ply", replaced(text, "\n0.000000 0.000000 0.0", "\nnan 0 0.0")),
            "M:15: expected a finite number, not \"nan\"");
  EXPECT_EQ(read("m.ply", replaced(text, "\n0.000000 0.000000 0.0", "\n1e999 0 0.0")),
            "M:15: expected a finite number, not \"1e999\"");
  EXPECT_EQ(read("m.ply", replaced(text, "\n0.000000 0.000000 0.0", "\n1E-999 0 0.0")), "no error") << "it is 0";
  EXPECT_EQ(read("m.ply", replaced(text, "\n3 0 2 1", "\n\n \n3 0 2 1\n")), "no error") << "blank lines";
  EXPECT_EQ(read("m.ply", text.substr(0, text.size() - 20)).substr(0, 2), "M:");
  EXPECT_EQ(read("m.ply", binary.substr(0, binary.size() - 20)).substr(0, 2), "M:");
}

TEST(HostileMesh, BoundsNoSolid) {
  Mesh open = box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_EQ(read("m.stl", stl_text(open)).substr(0, 58),
            "\"M\" is not closed: 3 of 18 edges have one triangle only, t");
  EXPECT_EQ(read("m.ply", ply_text(box_mesh({0, 0, 0}, {0, 0, 1}))), "\"M\" has no triangles") << "it collapsed";
  EXPECT_EQ(read("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n"), "\"M\" is flat: it encloses no volume");
  EXPECT_EQ(read("m.obj", obj_text(tetrahedron()) + "f 1 3 2\n").substr(0, 31), "\"M\" is not the surface of a sol");
}

/// Every prefix, and thousands of files with a few bytes changed: an error or a mesh, never anything else.
TEST(HostileMesh, CutOrChangedAnywhereIsHandled) {
  for (const auto& [name, good] : mesh_files(box_mesh({0, 0, 0}, {1, 1, 1}))) {
    EXPECT_EQ(read(name, good), "no error");
    for (std::size_t n = 1; n < good.size(); n += 1 + good.size() / 150) (void)read(name, good.substr(0, n));
    for (std::uint64_t i = 0; i < 400; ++i) {
      std::string changed = good;
      for (std::uint64_t k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(uniform(1, i, 2 * k) * static_cast<double>(good.size()));
        changed[at] = static_cast<char>(static_cast<int>(uniform(1, i, 2 * k + 1) * 256) - 128);
      }
      (void)read(name, changed);
    }
  }
}

} // namespace
} // namespace flipbook
