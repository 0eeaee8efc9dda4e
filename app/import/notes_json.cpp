// SPDX-License-Identifier: MIT
// The only file that includes nlohmann-json.
#include "app/import/notes_json.h"

#include "sim/files/byte_source.h"
#include "sim/frame/errors.h"
#include "sim/frame/parameters.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

namespace flipbook::app {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t largest = 1U << 20U; // bytes; the notes' own has 258
constexpr int deepest = 8;                 // levels; the notes' own has two
constexpr std::size_t longest_shown = 60;  // characters of a key or a value

std::string quoted(const std::string& s) {
  return "\"" + s + "\"";
}

Location place_of(std::size_t byte, std::string_view text, const std::string& file) {
  const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const std::size_t newline = before.rfind('\n');
  return {file, 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          static_cast<int>(before.size() - (newline == std::string_view::npos ? 0 : newline + 1)) + 1};
}

/// What went wrong, without the library's own name and place for it.
std::string reason(const std::string& what) {
  std::size_t at = what.find("] ");
  at = at == std::string::npos ? 0 : at + 2;
  if (const std::size_t column = what.find("column ", at); column != std::string::npos)
    if (const std::size_t colon = what.find(": ", column); colon != std::string::npos) at = colon + 2;
  return printable(std::string_view(what).substr(at), 200);
}

/// The object in the text. A key that is there twice, which JSON leaves open, is a mistake.
json parse(std::string_view text, const std::string& file, Mistakes& mistakes) {
  std::set<std::string> met;
  const auto watch = [&](int depth, json::parse_event_t event, const json& parsed) {
    if (depth > deepest) throw UserError("is nested too deeply", Location{file});
    if (event == json::parse_event_t::key && depth == 1 && !met.insert(parsed.get<std::string>()).second)
      mistakes.add("the key " + shown(parsed.get<std::string>(), longest_shown) + " is there twice", Location{file});
    return true;
  };
  try {
    json root = json::parse(text, watch);
    if (!root.is_object()) throw UserError("must be an object with the keys of the fluid notes", Location{file});
    return root;
  } catch (const json::parse_error& e) {
    throw UserError("not JSON: " + reason(e.what()), place_of(e.byte, text, file));
  } catch (const json::exception& e) {
    throw UserError("not JSON: " + reason(e.what()), Location{file});
  }
}

/// Takes the keys of the object one by one.
class Keys {
public:
  Keys(const json& object, std::string file, Mistakes& mistakes)
      : object_(object), file_(std::move(file)), mistakes_(mistakes) {}

  double number(const std::string& key, double lo, double hi) {
    const json* value = take(key);
    if (value && fits(*value, lo, hi)) return value->get<double>();
    if (value) refuse(key, "a number" + range(lo, hi), *value);
    return lo;
  }
  std::array<double, 3> numbers(const std::string& key, double lo, double hi, bool whole = false) {
    std::array<double, 3> all{lo, lo, lo};
    const json* value = take(key);
    if (!value) return all;
    bool good = value->is_array() && value->size() == 3;
    for (std::size_t a = 0; good && a < 3; ++a) {
      const json& one = (*value)[a];
      good = fits(one, lo, hi) && (!whole || one.get<double>() == std::floor(one.get<double>()));
      if (good) all[a] = one.get<double>();
    }
    if (!good) refuse(key, (whole ? "a list of 3 whole numbers" : "a list of 3 numbers") + range(lo, hi), *value);
    return all;
  }
  std::string text(const std::string& key) {
    const json* value = take(key);
    if (!value) return "";
    if (value->is_string() && !value->get_ref<const std::string&>().empty()) return value->get<std::string>();
    refuse(key, "a text that is not empty", *value);
    return "";
  }
  /// A key without use here may be missing.
  void unused_text(const std::string& key) {
    if (object_.contains(key))
      (void)text(key);
    else
      known_.push_back(key);
  }

  /// Keys that nobody took: mistakes where they stand for one that is missing, else left out with a warning.
  void done(std::vector<std::string>& warnings) {
    for (const auto& [key, value] : object_.items()) {
      if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
      const auto slip = std::find(missing_.begin(), missing_.end(), nearest_name(key, missing_));
      const std::string unknown = "unknown key " + shown(key, longest_shown);
      if (slip != missing_.end()) {
        mistakes_.add(unknown, Location{file_}, *slip);
        missing_.erase(slip);
      } else {
        warnings.emplace_back(UserError(unknown + " is left out", Location{file_}, nearest_name(key, known_)).what());
      }
    }
    for (const std::string& key : missing_) mistakes_.add("the key " + quoted(key) + " is missing", Location{file_});
  }

private:
  const json* take(const std::string& key) {
    known_.push_back(key);
    const auto at = object_.find(key);
    if (at == object_.end()) missing_.push_back(key);
    return at == object_.end() ? nullptr : &*at;
  }
  static bool fits(const json& value, double lo, double hi) {
    return value.is_number() && value.get<double>() >= lo && value.get<double>() <= hi;
  }
  static std::string range(double lo, double hi) { return " from " + to_toml(Value(lo)) + " to " + to_toml(Value(hi)); }
  void refuse(const std::string& key, const std::string& wanted, const json& value) {
    mistakes_.add(quoted(key) + " must be " + wanted + ", not " +
                      printable(value.dump(-1, ' ', false, json::error_handler_t::replace), longest_shown),
                  Location{file_});
  }

  const json& object_;
  const std::string file_;
  Mistakes& mistakes_;
  std::vector<std::string> known_, missing_;
};

} // namespace

NotesJson read_notes_json(const std::string& file) {
  ByteSource source(file);
  if (source.left() > largest) throw UserError("is too long for an input of the fluid notes", Location{file});
  Mistakes mistakes;
  const json root = parse(source.take(largest), file, mistakes);

  NotesJson notes;
  notes.file = file;
  Keys keys(root, file, mistakes);
  // The bounds are those of the parameters that these become; a frame has a million steps at most.
  notes.dt = keys.number("dt", 1e-7, 1000);
  notes.total_time = keys.number("total_time", 1e-6, 1e6);
  notes.density = keys.number("density", 1e-6, 1e6);
  const auto res = keys.numbers("res", 3, 16384, true);
  std::transform(res.begin(), res.end(), notes.res.begin(), [](double n) { return static_cast<int>(n); });
  notes.h = keys.number("h", 1e-6, 1e6 / *std::max_element(res.begin(), res.end()));
  notes.lc = keys.numbers("lc", -9e5, 9e5);
  notes.flip_ratio = keys.number("flipRatio", 0, 1);
  notes.particles = keys.text("particles");
  keys.unused_text("output_fname");
  keys.done(notes.warnings);
  mistakes.raise();
  return notes;
}

std::string particles_of(const NotesJson& notes) {
  const fs::path written(notes.particles), folder = fs::path(notes.file).parent_path();
  const fs::path as_written = folder / written, beside = folder / written.filename(); // an absolute path stays one
  std::error_code none;
  for (const fs::path& path : {as_written, beside})
    if (fs::exists(path, none) && !fs::is_directory(path, none)) return path.string();
  std::string tried = quoted(as_written.string());
  if (beside != as_written) tried += " nor " + quoted(beside.string());
  throw UserError("there is no file of particles: neither " + tried, Location{notes.file});
}

} // namespace flipbook::app
