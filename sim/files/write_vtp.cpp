// SPDX-License-Identifier: MIT
// VTK's XML format for PolyData with raw appended data: arrays described in XML, then '_' and for each array its length
// in bytes (UInt64) and its numbers.
#include "sim/files/particle_writers.h"
#include "sim/frame/errors.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace flipbook {
namespace {

using Column = ParticleTable::Column;

/// An array of `components` numbers for each row; a missing column is 0.
struct Array {
  std::string name;
  std::vector<const Column*> components;
};

/// C_xx C_xy ... of a 2D run stand in the upper left of a 3 x 3 matrix, omega_z is the last of three.
std::vector<Array> point_data(const ParticleTable& table) {
  std::vector<Array> all;
  const auto v = vector_of(table, "v");
  all.push_back({"velocity", {v.begin(), v.end()}});
  if (table.find("omega_z")) {
    const auto omega = vector_of(table, "omega_");
    all.push_back({"omega", {omega.begin(), omega.end()}});
  }
  if (table.find("C_xx")) {
    Array c{"C", {}};
    for (const char a : {'x', 'y', 'z'})
      for (const Column* column : vector_of(table, std::string("C_") + a)) c.components.push_back(column);
    all.push_back(std::move(c));
  }
  return all;
}

class File {
public:
  explicit File(const ParticleTable& table) : table_(table) {}

  [[nodiscard]] std::string write() {
    const std::string rows = std::to_string(table_.id.size());
    xml_ = "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
           "<PolyData>\n<Piece NumberOfPoints=\"" +
           rows + "\" NumberOfVerts=\"" + rows + "\">\n<Points>\n";
    const auto x = vector_of(table_, "");
    add({"Points", {x.begin(), x.end()}});
    xml_ += "</Points>\n<Verts>\n";
    add_numbers("connectivity", 0);
    add_numbers("offsets", 1);
    xml_ += "</Verts>\n<PointData Scalars=\"id\" Vectors=\"velocity\">\n";
    add_ids();
    for (const Array& array : point_data(table_)) add(array);
    xml_ += "</PointData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    return xml_ + data_ + "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  /// Describes an array and returns where its bytes go.
  char* declare(const std::string& name, const std::string& type, std::size_t components, std::size_t bytes) {
    xml_ += "<DataArray type=\"" + type + "\" Name=\"" + name + "\"" +
            (components > 1 ? " NumberOfComponents=\"" + std::to_string(components) + "\"" : "") +
            " format=\"appended\" offset=\"" + std::to_string(data_.size()) + "\"/>\n";
    const std::size_t at = data_.size();
    data_.resize(at + sizeof(std::uint64_t) + bytes);
    char* p = data_.data() + at;
    put_bytes(p, std::uint64_t{bytes});
    return p;
  }

  template <class Real> void put(const Array& array, char* p) const {
    for (std::size_t r = 0; r < table_.id.size(); ++r)
      for (const Column* c : array.components) put_bytes(p, c ? static_cast<Real>(c->values[r]) : Real(0));
  }

  void add(const Array& array) {
    bool single = true;
    for (const Column* c : array.components) single = single && (!c || table_.is_single(*c));
    const std::size_t n = array.components.size();
    char* p = declare(array.name, single ? "Float32" : "Float64", n, n * table_.id.size() * (single ? 4 : 8));
    single ? put<float>(array, p) : put<double>(array, p);
  }

  void add_ids() {
    char* p = declare("id", "UInt32", 1, 4 * table_.id.size());
    for (const std::uint32_t id : table_.id) put_bytes(p, id);
  }

  /// first, first + 1, ...: which point each vertex has, and where the vertices end in that list.
  void add_numbers(const std::string& name, std::int32_t first) {
    char* p = declare(name, "Int32", 1, 4 * table_.id.size());
    for (std::size_t r = 0; r < table_.id.size(); ++r) put_bytes(p, static_cast<std::int32_t>(r) + first);
  }

  const ParticleTable& table_;
  std::string xml_, data_;
};

} // namespace

std::string write_vtp(const ParticleTable& table) {
  if (table.id.size() >= std::numeric_limits<std::int32_t>::max())
    throw UserError("a VTK file holds at most 2147483646 particles, not " + std::to_string(table.id.size()));
  return File(table).write();
}

} // namespace flipbook
