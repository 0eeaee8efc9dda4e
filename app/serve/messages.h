// SPDX-License-Identifier: MIT
// What a page may say to the server: a closed set of small JSON objects. Whatever arrives is hostile until it has been
// through here; what comes out has every number finite and within its range, and every text short.
#pragma once

#include "sim/frame/parameters.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace flipbook::app::serve {

/// What a pointer does in a pane.
enum class Tool { camera, push, add, remove, solid };
inline constexpr std::string_view tool_names[] = {"camera", "push", "add", "remove", "solid"};

struct Modifiers {
  bool shift = false, ctrl = false, alt = false;
};

/// Where the pointer is, in fractions of the picture from its upper left corner.
struct PointerMessage {
  std::uint32_t seq = 0;
  double x = 0, y = 0;
  unsigned buttons = 0; ///< 1 left, 2 right, 4 middle
  double wheel = 0;     ///< notches, away from the user is positive
  bool out = false;     ///< the pointer left the picture
  Modifiers with;
  Tool tool = Tool::camera;
  double radius = 0.08; ///< of the tool, as a fraction of the domain's shortest side
};

/// Turns the camera, in fractions of the picture.
struct OrbitMessage {
  std::uint32_t seq = 0;
  double dx = 0, dy = 0;
};

struct KeyMessage {
  std::uint32_t seq = 0;
  std::string key; ///< as KeyboardEvent.key says it
  bool down = false;
  Modifiers with;
};

struct TextMessage {
  std::uint32_t seq = 0;
  std::string text;
};

/// A picture is on the screen.
struct AckMessage {
  std::uint32_t picture = 0;
};

/// How many pixels the page has for the picture.
struct ViewMessage {
  int width = 0, height = 0;
  bool panel = true; ///< is the panel to be in it?
};

enum class Action {
  play,
  pause,
  step,
  reset,
  record,
  stop_record,
  snapshot,
  save_study,
  open,
  drive,
  link,
  set,
  parameters
};

struct DoMessage {
  Action action = Action::play;
  std::string kind, name; ///< of `record` and `open`
  std::string path;       ///< of `set`
  std::optional<Value> value;
  int pane = 0;   ///< of `set`: from 1; 0: all
  bool on = true; ///< of `drive`, `link` and `parameters`
};

using ClientMessage =
    std::variant<PointerMessage, OrbitMessage, KeyMessage, TextMessage, AckMessage, ViewMessage, DoMessage>;

inline constexpr std::size_t longest_message = 4096; ///< bytes

/// Nothing, and why, for what is no message.
[[nodiscard]] std::optional<ClientMessage> parse_message(std::string_view text, std::string& why);

} // namespace flipbook::app::serve
