// SPDX-License-Identifier: MIT
// Where a live session keeps what it writes: it begins and ends recordings, takes what the simulations hand over, and
// tells people what was saved. What cannot be written ends no session.
#pragma once

#include "app/live/recording.h"

#include <functional>
#include <memory>
#include <string>

namespace flipbook::app::live {

class Desk {
public:
  /// `tell` gets the messages for the clients.
  Desk(std::string folder, render::Context& context, const render::Workers& workers, Budget& budget,
       Simulator& simulator, std::function<void(const std::string&)> tell);

  void begin(const std::string& kind);
  void write_recorded(); ///< if a frame waits
  void take(const Report& report);
  [[nodiscard]] const Recording* recording() const { return recording_.get(); }

private:
  void end(const Study& study);
  void saved(const std::string& kind, const std::string& name, const std::string& more = {});
  void failed(const std::string& why);

  const std::string folder_;
  render::Context& context_;
  const render::Workers& workers_;
  Budget& budget_;
  Simulator& simulator_;
  const std::function<void(const std::string&)> tell_;
  std::unique_ptr<Recording> recording_;
};

} // namespace flipbook::app::live
