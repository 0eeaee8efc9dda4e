// SPDX-License-Identifier: MIT
#include "app/serve/messages.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace flipbook::app::serve {
namespace {

using Json = nlohmann::json;

constexpr int deepest = 3; // an object, a list in it, and nothing more
constexpr std::size_t longest_text = 256, longest_typed = 64, most_items = 64;
constexpr double most_wheel = 10, most_pixels = 16384, largest_u32 = 4294967295.0;

/// Thrown inside this file only.
struct Malformed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads the entries of one message by name.
class Entries {
public:
  explicit Entries(const Json& object) : object_(object) {}

  [[nodiscard]] double number(const char* name, double lo, double hi, std::optional<double> fallback = {}) const {
    const Json* entry = find(name);
    if (!entry && fallback) return *fallback;
    if (!entry || !entry->is_number()) throw Malformed(quoted(name) + " must be a number");
    const double x = entry->get<double>();
    if (!std::isfinite(x)) throw Malformed(quoted(name) + " must be finite");
    return std::clamp(x, lo, hi);
  }
  /// A whole number that is within the range as it stands.
  [[nodiscard]] std::uint32_t whole(const char* name, double hi, std::optional<std::uint32_t> fallback = {}) const {
    const Json* entry = find(name);
    if (!entry && fallback) return *fallback;
    if (!entry || !entry->is_number()) throw Malformed(quoted(name) + " must be a number");
    const double x = entry->get<double>();
    if (!(x >= 0 && x <= hi && x == std::floor(x))) throw Malformed(quoted(name) + " is out of its range");
    return static_cast<std::uint32_t>(x);
  }
  [[nodiscard]] bool flag(const char* name, bool fallback) const {
    const Json* entry = find(name);
    if (!entry) return fallback;
    if (!entry->is_boolean()) throw Malformed(quoted(name) + " must be true or false");
    return entry->get<bool>();
  }
  [[nodiscard]] std::string text(const char* name, std::size_t longest,
                                 std::optional<std::string> fallback = {}) const {
    const Json* entry = find(name);
    if (!entry && fallback) return *fallback;
    if (!entry || !entry->is_string()) throw Malformed(quoted(name) + " must be a text");
    const auto& s = entry->get_ref<const std::string&>();
    if (s.size() > longest) throw Malformed(quoted(name) + " is too long");
    return s;
  }
  [[nodiscard]] const Json* find(const char* name) const {
    const auto at = object_.find(name);
    return at == object_.end() ? nullptr : &*at;
  }

private:
  static std::string quoted(const char* name) { return "\"" + std::string(name) + "\""; }
  const Json& object_;
};

Modifiers modifiers(const Entries& e) {
  return {e.flag("shift", false), e.flag("ctrl", false), e.flag("alt", false)};
}

std::uint32_t sequence(const Entries& e) {
  return e.whole("seq", largest_u32);
}

ClientMessage pointer(const Entries& e) {
  PointerMessage m;
  m.seq = sequence(e);
  m.x = e.number("x", -1, 2);
  m.y = e.number("y", -1, 2);
  m.buttons = e.whole("buttons", 255, 0) & 7U;
  m.wheel = e.number("wheel", -most_wheel, most_wheel, 0.0);
  m.out = e.flag("out", false);
  m.with = modifiers(e);
  const std::string tool = e.text("tool", longest_typed, "camera");
  const auto at = std::find(std::begin(tool_names), std::end(tool_names), tool);
  if (at == std::end(tool_names)) throw Malformed("there is no such tool");
  m.tool = static_cast<Tool>(at - std::begin(tool_names));
  m.radius = e.number("radius", 0.01, 0.5, m.radius);
  return m;
}

ClientMessage orbit(const Entries& e) {
  return OrbitMessage{sequence(e), e.number("dx", -1, 1), e.number("dy", -1, 1)};
}

ClientMessage key(const Entries& e) {
  return KeyMessage{sequence(e), e.text("key", longest_typed), e.flag("down", false), modifiers(e)};
}

ClientMessage typed(const Entries& e) {
  return TextMessage{sequence(e), e.text("text", longest_typed)};
}

ClientMessage ack(const Entries& e) {
  return AckMessage{e.whole("picture", largest_u32)};
}

ClientMessage view(const Entries& e) {
  return ViewMessage{static_cast<int>(e.number("width", 1, most_pixels)),
                     static_cast<int>(e.number("height", 1, most_pixels)), e.flag("panel", true)};
}

/// A flag, a number, a text, or a list of numbers or of texts.
Value value_in(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number() && std::isfinite(json.get<double>())) return json.get<double>();
  if (json.is_string() && json.get_ref<const std::string&>().size() <= longest_text) return json.get<std::string>();
  if (!json.is_array() || json.size() > most_items) throw Malformed("\"value\" is no value of a parameter");
  const auto all = [&](auto is) { return std::all_of(json.begin(), json.end(), is); };
  if (!json.empty() && all([](const Json& x) { return x.is_number() && std::isfinite(x.get<double>()); }))
    return json.get<std::vector<double>>();
  if (all([](const Json& x) { return x.is_string() && x.get_ref<const std::string&>().size() <= longest_text; }))
    return json.get<std::vector<std::string>>();
  throw Malformed("\"value\" is no value of a parameter");
}

constexpr std::array<std::string_view, 13> action_names{"play",        "pause",    "step",       "reset", "record",
                                                        "stop_record", "snapshot", "save_study", "open",  "drive",
                                                        "link",        "set",      "parameters"};

ClientMessage act(const Entries& e) {
  DoMessage m;
  const std::string name = e.text("action", longest_typed);
  const auto at = std::find(action_names.begin(), action_names.end(), name);
  if (at == action_names.end()) throw Malformed("there is no such action");
  m.action = static_cast<Action>(at - action_names.begin());
  m.kind = e.text("kind", longest_typed, "");
  m.name = e.text("name", longest_text, "");
  m.on = e.flag(m.action == Action::drive ? "take" : "on", true);
  if (m.action == Action::record && m.kind != "video" && m.kind != "png")
    throw Malformed("\"kind\" of a recording is \"video\" or \"png\"");
  if (m.action == Action::open && m.kind != "study" && m.kind != "scene")
    throw Malformed("\"kind\" of what is opened is \"study\" or \"scene\"");
  if (m.action != Action::set) return m;
  m.path = e.text("path", longest_text);
  m.pane = static_cast<int>(e.whole("pane", 12, 0));
  const Json* value = e.find("value");
  if (!value) throw Malformed("\"value\" is missing");
  m.value = value_in(*value);
  return m;
}

struct Kind {
  std::string_view type;
  ClientMessage (*read)(const Entries&);
};
constexpr std::array<Kind, 7> kinds{
    {{"pointer", pointer}, {"orbit", orbit}, {"key", key}, {"text", typed}, {"ack", ack}, {"view", view}, {"do", act}}};

ClientMessage read(std::string_view text) {
  if (text.size() > longest_message) throw Malformed("a message has at most 4096 bytes");
  bool too_deep = false;
  const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
    too_deep = too_deep || depth > deepest;
    return !too_deep;
  };
  const Json json = Json::parse(text.begin(), text.end(), shallow, false);
  if (too_deep || json.is_discarded() || !json.is_object()) throw Malformed("a message is a small JSON object");
  const Entries entries(json);
  const std::string type = entries.text("type", longest_typed);
  const auto at = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.type == type; });
  if (at == kinds.end()) throw Malformed("there is no such message");
  return at->read(entries);
}

} // namespace

std::optional<ClientMessage> parse_message(std::string_view text, std::string& why) {
  try {
    return read(text);
  } catch (const Malformed& e) {
    why = e.what();
  } catch (const Json::exception&) {
    why = "a message is a small JSON object";
  }
  return std::nullopt;
}

} // namespace flipbook::app::serve
