// SPDX-License-Identifier: MIT
#include "sim/files/read_particles.h"

#include "sim/files/particle_formats.h"
#include "sim/frame/text.h"

#include <algorithm>
#include <filesystem>

namespace flipbook {
namespace {

/// Does a text begin with names rather than with a count? Looks at its first line with content, without taking it.
bool begins_with_names(ByteSource& file) {
  std::string_view rest = file.peek(ByteSource::longest_line);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    if (!line.empty() && line.front() != '#' && line.front() != '\r') {
      const char c = line.front();
      return std::string_view("\"_,;").find(c) != std::string_view::npos || (c >= 'a' && c <= 'z') ||
             (c >= 'A' && c <= 'Z');
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

constexpr Option formats[] = {
    {"text", "A line with the number of rows, then rows: x y, x y z, x y vx vy or x y z vx vy vz"},
    {"csv", "A line of names, then rows; commas, semicolons or tabs"},
    {"ply", "The element \"vertex\" with x y [z] [vx vy vz]; text or binary"},
    {"vtp", "VTK PolyData with raw appended data: points and the array \"velocity\""},
};

} // namespace

ParticleRows read_particles(const std::string& path, bool ids) {
  ByteSource file(path);
  if (file.peek(3) == "\xef\xbb\xbf") (void)file.take(3); // the mark that some editors put before UTF-8
  const std::string_view start = file.peek(4);
  const std::string extension = lower(std::filesystem::path(path).extension().string());
  if (start == "ply\n" || start == "ply\r") return read_ply(file, ids);
  if (extension == ".ply") file.refuse("not a PLY file: its first line must be \"ply\"");
  if (start == "<?xm" || start == "<VTK" || extension == ".vtp") return read_vtp(file, ids);
  if (extension == ".csv" || extension == ".tsv" || begins_with_names(file)) return read_csv(file, ids);
  return read_counted_text(file);
}

std::span<const Option> particle_input_options() {
  return formats;
}

} // namespace flipbook
