// SPDX-License-Identifier: MIT
// A live session: simulations on a thread of their own, clients on another, and here, on the calling thread, who owns
// OpenGL and Dear ImGui: it takes what the clients do, draws what the simulations have, and writes what is recorded.
#pragma once

#include "app/serve/server.h"
#include "app/study/study.h"
#include "render/context/context.h"

#include <functional>
#include <memory>
#include <string>

namespace flipbook::app::live {

struct LiveOptions {
  Study study;
  std::string kind; ///< "study", "scene" or "file"
  serve::ServerOptions server;
  std::string folder = "out"; ///< where everything goes that is written
  int threads = 1;
  render::Backend gl = render::Backend::automatic;
  std::function<void(const serve::Server&)> listening; ///< called once, when clients can come
};

/// Until a signal asks to end; all files are whole then.
void run_live_session(const LiveOptions& options);

} // namespace flipbook::app::live
