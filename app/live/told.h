// SPDX-License-Identifier: MIT
// What the server tells the pages: small JSON texts. app/serve/README.md lists them.
#pragma once

#include "app/live/simulator.h"
#include "app/serve/server.h"

#include <string>
#include <vector>

namespace flipbook::app::live {

[[nodiscard]] std::string tell_hello(serve::ClientId client, bool drives, const std::string& folder);
[[nodiscard]] std::string tell_role(bool drives, std::size_t clients);
[[nodiscard]] std::string tell_message(const std::string& level, const std::string& text);
[[nodiscard]] std::string tell_saved(const std::string& kind, const std::string& name, const std::string& text);
[[nodiscard]] std::string tell_parameters(const std::vector<std::string>& titles,
                                          const std::vector<std::vector<Parameter>>& panes,
                                          const std::vector<Parameter>& view);

struct ToldState {
  LiveStatus status;
  std::vector<std::string> titles; ///< of the panes
  bool linked = true, keyboard = false;
  std::string cursor = "default";
  double fps_drawn = 0;
  int width = 0, height = 0; ///< of the pictures
  std::string recording_kind, recording_name;
  std::size_t recording_frames = 0;
};
[[nodiscard]] std::string tell_state(const ToldState& state);

} // namespace flipbook::app::live
