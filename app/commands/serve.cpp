// SPDX-License-Identifier: MIT
// flipbook serve STUDY|SCENE: runs it live, in a browser.
#include "app/commands/run_options.h"
#include "app/live/session.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

#include <cmath>
#include <filesystem>
#include <iostream>

namespace flipbook::app {

namespace {

class Serve final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"STUDY", Argument::Kind::study}, study_, "Name or path of a study or a scene; dam_break if not given",
                 false);
    v.text("--port", port_, "N", "Port to listen on; one that is free if not given");
    v.text("--host", host_, "HOST", "Address to listen on; this machine alone (127.0.0.1) if not given");
    options_.describe_live(v);
  }

  int run() override {
    live::LiveOptions live;
    if (study_.empty()) study_ = "dam_break";
    live.study = options_.applied_to(read_study(study_));
    live.kind = is_path(study_) ? "file" : find_asset("studies", study_) ? "study" : "scene";
    live.folder = options_.folder();
    live.threads = options_.session_options().threads;
    live.gl = options_.session_options().gl;
    if (!host_.empty()) live.server.host = host_;
    if (!port_.empty())
      live.server.port = static_cast<std::uint16_t>(std::lround(parse_number(port_, "--port", 0, 65535)));
    live.listening = [](const serve::Server& server) {
      if (!server.loopback())
        std::cerr << "warning: other machines can reach this server, and nothing is encrypted: whoever has the link "
                     "drives it\n";
      std::cout << server.url() << std::endl;
    };
    (void)resolve(live.study); // its mistakes come before the work
    run_live_session(live);
    return 0;
  }

private:
  std::string study_, port_, host_;
  RunOptions options_;
};

} // namespace

std::unique_ptr<Command> make_serve() {
  return std::make_unique<Serve>();
}

} // namespace flipbook::app
