// SPDX-License-Identifier: MIT
#include "app/commands/new_scheme.h"

#include "app/commands/text_output.h"
#include "app/encode/staging.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"
#include "sim/scene/toml_reader.h"
#include "sim/transfer/schemes.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

const fs::path folder_of_schemes = fs::path("sim") / "transfer";
constexpr std::string_view list_begins = "using Schemes = std::tuple<", list_ends = ">;";

/// Lower-case words of letters and digits with single underscores between them.
bool is_identifier(const std::string& name) {
  const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto fine = [&](char c) { return lower(c) || (c >= '0' && c <= '9') || c == '_'; };
  constexpr std::size_t longest = 40;
  return !name.empty() && name.size() <= longest && lower(name.front()) && name.back() != '_' &&
         name.find("__") == std::string::npos && std::all_of(name.begin(), name.end(), fine);
}

char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// "my_own" as MyOwnScheme.
std::string struct_name(const std::string& name) {
  std::string made;
  bool first = true;
  for (const char c : name) {
    if (c != '_') made += first ? upper(c) : c;
    first = c == '_';
  }
  return made + "Scheme";
}

/// "my_own" as MY_OWN: verify finds a scheme by its label, whatever the case.
std::string label_of(const std::string& name) {
  std::string made = name;
  std::transform(made.begin(), made.end(), made.begin(), upper);
  return made;
}

void check_name(const std::string& name) {
  if (!is_identifier(name))
    throw UserError("\"" + name + "\" is no name for a scheme: use lower-case letters, digits and _, at most 40");
  for (const SchemeInfo& info : scheme_infos())
    if (info.name == name) throw UserError("there is a scheme \"" + name + "\" already");
}

/// The folder above which sim/transfer/schemes.h is.
std::optional<fs::path> source_tree() {
  std::error_code none;
  for (fs::path at = fs::current_path(none); !at.empty(); at = at.parent_path()) {
    if (fs::is_regular_file(at / folder_of_schemes / "schemes.h", none)) return at;
    if (at == at.parent_path()) break;
  }
  return std::nullopt;
}

std::string include_line(const std::string& name) {
  return "#include \"sim/transfer/" + name + ".h\"\n";
}

/// schemes.h with the scheme in it; nothing where the list does not look as expected.
std::optional<std::string> registered(std::string text, const std::string& name) {
  const std::size_t begin = text.find(list_begins);
  const std::size_t end = begin == std::string::npos ? begin : text.find(list_ends, begin);
  const std::string include = "#include \"sim/transfer/";
  const std::size_t first = text.find(include);
  if (end == std::string::npos || first == std::string::npos || first > begin) return std::nullopt;
  text.insert(end, ", " + struct_name(name));
  // In the order of the alphabet.
  std::size_t at = first;
  while (text.compare(at, include.size(), include) == 0 && text.compare(at, std::string::npos, include_line(name)) < 0)
    at = text.find('\n', at) + 1;
  text.insert(at, include_line(name));
  return text;
}

std::string filled_template(const std::string& name) {
  const auto beside = find_asset("templates", "scene");
  const fs::path path = beside ? fs::path(*beside).parent_path() / "scheme.h.in" : fs::path();
  std::error_code none;
  if (!beside || !fs::is_regular_file(path, none))
    throw MachineError("templates/scheme.h.in is missing where the scenes are");
  std::string text = read_text_file(path.string());
  replace_all(text, "@NAME@", name);
  replace_all(text, "@LABEL@", label_of(name));
  replace_all(text, "@STRUCT@", struct_name(name));
  return text;
}

fs::path given_path(const std::string& output, const std::string& name) {
  std::error_code none;
  if (output.empty() || output.ends_with('/') || fs::is_directory(output, none))
    return fs::path(output) / (name + ".h");
  if (fs::path(output).extension() == ".h") return output;
  throw UserError("-o " + output + ": a scheme goes to a file that ends in .h, or to a folder that ends in /");
}

} // namespace

void new_scheme(const std::string& name, const std::string& output) {
  check_name(name);
  const std::optional<fs::path> tree = output.empty() ? source_tree() : std::nullopt;
  const fs::path file = tree ? *tree / folder_of_schemes / (name + ".h") : given_path(output, name);
  std::error_code none;
  if (fs::exists(fs::symlink_status(file, none))) throw UserError(file.string() + " exists; a scheme replaces no file");
  const std::string header = filled_template(name);
  const fs::path list = tree ? *tree / folder_of_schemes / "schemes.h" : fs::path();
  const auto entered = tree ? registered(read_text_file(list.string()), name) : std::nullopt;
  write_file(file, header);
  if (entered) write_file(list, *entered);
  std::cout << file.string() << '\n';
  if (entered)
    std::cerr << "entered into " << list.string() << "\n";
  else
    std::cerr << "to make it a scheme: put it into sim/transfer/, and into sim/transfer/schemes.h write\n  "
              << include_line(name) << "and " << struct_name(name) << " into the list Schemes\n";
  std::cerr << "then: cmake --build build, flipbook verify --only " << name
            << ", flipbook compare transfer_shear --schemes apic," << name << '\n';
}

} // namespace flipbook::app
