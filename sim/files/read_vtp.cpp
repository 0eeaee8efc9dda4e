// SPDX-License-Identifier: MIT
#include "sim/files/numbers.h"
#include "sim/files/particle_formats.h"
#include "sim/files/row_store.h"
#include "sim/frame/text.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace flipbook {
namespace {

/// <Name attribute="value" ...> or </Name>, as it stands in the XML.
struct Tag {
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;

  [[nodiscard]] std::string get(std::string_view key, const std::string& otherwise = "") const {
    const auto at = attributes.find(key);
    return at == attributes.end() ? otherwise : at->second;
  }
};

constexpr std::size_t most_tags = 4096, longest_name = 256;

/// What stands between < and >.
Tag tag_of(std::string_view inside, const ByteSource& file) {
  constexpr std::string_view blank = " \t\r\n";
  const std::string_view name = inside.substr(0, inside.find_first_of(" \t\r\n/", 1));
  if (name.size() > longest_name)
    file.refuse("not XML: a tag's name is longer than " + std::to_string(longest_name) + " bytes");
  Tag tag{std::string(name), {}};
  for (std::size_t equals = inside.find('='); equals != std::string_view::npos; equals = inside.find('=')) {
    const std::string_view before = inside.substr(0, equals);
    const std::size_t last = before.find_last_not_of(blank);
    const std::size_t open = inside.find_first_of("\"'", equals);
    if (last == std::string_view::npos || open == std::string_view::npos) break;
    const std::size_t first = before.find_last_of(blank, last), close = inside.find(inside[open], open + 1);
    if (close == std::string_view::npos) break;
    const std::size_t begin = first == std::string_view::npos ? 0 : first + 1;
    tag.attributes[std::string(before.substr(begin, last + 1 - begin))] = inside.substr(open + 1, close - open - 1);
    inside.remove_prefix(close + 1);
  }
  return tag;
}

/// The tags of a text in order; enough of XML for files that programs wrote.
std::vector<Tag> tags_of(std::string_view xml, const ByteSource& file) {
  std::vector<Tag> tags;
  std::size_t behind = 0;
  for (std::size_t at = xml.find('<'); at != std::string_view::npos; at = xml.find('<', behind)) {
    const bool comment = xml.substr(at).starts_with("<!--");
    const std::size_t end = xml.find(comment ? "-->" : ">", at);
    if (end == std::string_view::npos) break;
    behind = end + 1;
    if (comment) continue;
    if (tags.size() == most_tags) file.refuse("more than " + std::to_string(most_tags) + " tags in the VTK file");
    tags.push_back(tag_of(xml.substr(at + 1, end - at - 1), file));
  }
  return tags;
}

struct NumberType {
  std::string_view name;
  std::size_t bytes;
  double (*read)(const char*);
};

template <class T> double real_at(const char* p) {
  return static_cast<double>(number_at<T>(p));
}

constexpr NumberType number_types[] = {
    {"Float32", 4, real_at<float>},        {"Float64", 8, real_at<double>},       {"Int32", 4, real_at<std::int32_t>},
    {"UInt32", 4, real_at<std::uint32_t>}, {"Int64", 8, real_at<std::int64_t>},   {"UInt64", 8, real_at<std::uint64_t>},
    {"Int16", 2, real_at<std::int16_t>},   {"UInt16", 2, real_at<std::uint16_t>}, {"Int8", 1, real_at<signed char>},
    {"UInt8", 1, real_at<unsigned char>},
};

/// One array that we want, and which numbers of a row it fills.
struct Array {
  std::uint64_t offset;
  NumberType type;
  std::string name;
  std::size_t first, count;
};

class VtpReader {
public:
  VtpReader(ByteSource& file, bool ids) : file_(file), ids_(ids) {}

  ParticleRows read() {
    file_.leave_text();
    const std::string xml = take_header();
    find_arrays(tags_of(xml, file_));
    std::sort(arrays_.begin(), arrays_.end(), [](auto& a, auto& b) { return a.offset < b.offset; });
    std::uint64_t bytes = 0; // of a row, at least
    for (const Array& a : arrays_) bytes += a.count * a.type.bytes;
    RowStore rows(file_);
    rows.promised(count_, bytes);
    std::vector<Row> all(static_cast<std::size_t>(count_));
    for (const Array& a : arrays_) fill(a, all);
    if (ids_) rows.keep_ids();
    rows.reserve(count_);
    for (const Row& row : all) rows.add(row);
    return rows.take(false);
  }

private:
  /// Everything before the '_' that binary data follow.
  std::string take_header() {
    const std::string_view start = file_.peek(ByteSource::block);
    const std::size_t appended = start.find("<AppendedData");
    const std::size_t close = start.find('>', std::min(appended, start.size()));
    if (start.find("<VTKFile") == std::string_view::npos) file_.refuse("not a VTK XML file: it has no <VTKFile>");
    if (close == std::string_view::npos)
      file_.refuse("no <AppendedData> in the VTK file: only raw appended data without compression can be read");
    const std::size_t underscore = start.find('_', close);
    if (underscore == std::string_view::npos || start.find_first_not_of(" \t\r\n", close + 1) != underscore)
      file_.refuse("the appended data of a VTK file begin with '_'");
    std::string xml(start.substr(0, close + 1));
    (void)file_.take(underscore + 1);
    return xml;
  }

  void check_file(const Tag& tag) {
    if (tag.get("type") != "PolyData")
      file_.refuse("a VTK file of type " + shown(tag.get("type")) + "; it must be \"PolyData\" (.vtp)");
    if (!tag.get("compressor").empty()) file_.refuse("the VTK file is compressed: save it without compression");
    if (tag.get("byte_order", "LittleEndian") != "LittleEndian") file_.refuse("the VTK file is big endian");
    const std::string header = tag.get("header_type", "UInt32");
    if (header != "UInt32" && header != "UInt64") file_.refuse("header_type " + shown(header) + " is none of VTK's");
    length_bytes_ = header == "UInt64" ? 8 : 4;
  }

  void find_arrays(const std::vector<Tag>& tags) {
    std::string inside;
    int pieces = 0;
    bool points = false;
    for (const Tag& tag : tags) {
      if (tag.name == "VTKFile") check_file(tag);
      if (tag.name == "Points" || tag.name == "PointData") inside = tag.name;
      if (tag.name == "/" + inside) inside.clear();
      if (tag.name == "AppendedData" && tag.get("encoding") != "raw")
        file_.refuse("the data of the VTK file are " + shown(tag.get("encoding")) + "; only \"raw\" can be read");
      if (tag.name == "Piece") {
        if (++pieces > 1) file_.refuse("the VTK file has several pieces; save it as one");
        count_ = whole(tag, "NumberOfPoints");
      }
      if (tag.name != "DataArray") continue;
      if (inside == "Points" && !std::exchange(points, true)) want(tag, 0, 3);
      const std::string name = lower(tag.get("Name"));
      const bool velocity = name == "velocity" || name == "velocities" || name == "vel" || name == "v";
      if (inside == "PointData" && velocity && !std::exchange(velocity_, true)) want(tag, 3, 3);
      if (inside == "PointData" && name == "id" && ids_ && !std::exchange(has_id_, true)) want(tag, 6, 1);
    }
    if (!points) file_.refuse("the VTK file has no points");
    ids_ = has_id_;
  }

  void want(const Tag& tag, std::size_t first, std::size_t count) {
    const std::string name = shown(tag.get("Name", "Points")), type = tag.get("type");
    const auto* known = std::find_if(std::begin(number_types), std::end(number_types),
                                     [&](const NumberType& t) { return t.name == type; });
    if (known == std::end(number_types)) file_.refuse("the array " + name + " has numbers of type " + shown(type));
    if (tag.get("format") != "appended")
      file_.refuse("the array " + name + " is " + shown(tag.get("format", "ascii")) +
                   "; only raw appended data without compression can be read");
    if (tag.get("NumberOfComponents", first == 0 ? "3" : "1") != std::to_string(count))
      file_.refuse("the array " + name + " must have " + std::to_string(count) + " components");
    arrays_.push_back({whole(tag, "offset"), *known, name, first, count});
  }

  std::uint64_t whole(const Tag& tag, const std::string& key) const {
    const std::string text = tag.get(key);
    const auto value = whole_number<std::uint64_t>(text);
    if (!value) file_.refuse(key + " of <" + tag.name + "> must be a whole number, not " + shown(text));
    return *value;
  }

  [[noreturn]] void ends_early(const Array& a) const { file_.refuse("the file ends inside the array " + a.name); }

  void fill(const Array& a, std::vector<Row>& rows) {
    if (a.offset < passed_) file_.refuse("the array " + a.name + " overlaps another");
    if (!file_.skip(a.offset - passed_) || file_.left() < length_bytes_) ends_early(a);
    const char* before = file_.take(length_bytes_).data();
    const std::uint64_t length =
        length_bytes_ == 8 ? number_at<std::uint64_t>(before) : number_at<std::uint32_t>(before);
    const std::uint64_t wanted = count_ * a.count * a.type.bytes; // count_ was checked against the file
    if (length != wanted)
      file_.refuse("the array " + a.name + " has " + std::to_string(length) + " bytes, and " + std::to_string(count_) +
                   " points need " + std::to_string(wanted));
    passed_ = a.offset + length_bytes_ + length;
    const std::size_t row_bytes = a.count * a.type.bytes, in_block = ByteSource::block / row_bytes;
    for (std::size_t done = 0; done < rows.size();) {
      const std::size_t n = std::min(in_block, rows.size() - done);
      const std::string_view bytes = file_.take(n * row_bytes);
      if (bytes.size() < n * row_bytes) ends_early(a);
      for (const char* p = bytes.data(); p != bytes.data() + bytes.size(); ++done)
        for (std::size_t c = 0; c < a.count; ++c, p += a.type.bytes) rows[done][a.first + c] = a.type.read(p);
    }
  }

  ByteSource& file_;
  bool ids_, has_id_ = false, velocity_ = false;
  std::uint64_t count_ = 0, passed_ = 0;
  std::size_t length_bytes_ = 4; ///< of the number before an array
  std::vector<Array> arrays_;
};

} // namespace

ParticleRows read_vtp(ByteSource& file, bool ids) {
  return VtpReader(file, ids).read();
}

} // namespace flipbook
