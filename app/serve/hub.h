// SPDX-License-Identifier: MIT
// What all connections of a server share. A part of server.cpp.
#pragma once

#include "app/serve/flow.h"
#include "app/serve/gate.h"
#include "app/serve/jpeg.h"
#include "app/serve/server.h"

#include <array>
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace flipbook::app::serve {

/// Coded once for all clients of one grade.
struct CodedPicture {
  std::shared_ptr<const ServedPicture> picture;
  std::array<std::shared_ptr<const Jpeg>, picture_grades.size()> coded;
};

class Client;

inline constexpr std::size_t most_events = 4096; ///< that a program which does not listen leaves lying

/// What all connections share; used on the server's thread unless it says otherwise.
struct Hub {
  explicit Hub(std::function<void()> w) : wake(std::move(w)), token(chosen_token()) {}

  void happened(ClientEvent event) { // drops what a program that does not listen would never read
    {
      const std::scoped_lock lock(mutex);
      const bool said = event.what == ClientEvent::What::said;
      if (said && events.size() >= most_events) return;
      events.push_back(std::move(event));
    }
    wake();
  }
  const Jpeg& coded(std::size_t grade) {
    auto& jpeg = newest.coded[grade];
    if (!jpeg) jpeg = std::make_shared<const Jpeg>(encoder.encode(newest.picture->image, picture_grades[grade]));
    return *jpeg;
  }
  void count_wanting();

  const std::function<void()> wake; // any thread
  const std::string token;
  OwnNames names;
  std::size_t most_clients = 12, connections = 0;
  JpegEncoder encoder;
  CodedPicture newest;
  std::map<ClientId, std::shared_ptr<Client>> clients;
  ClientId last_client = 0;
  std::atomic<int> wanting{0}; // clients that could take a picture; any thread
  std::mutex mutex;            // of the events, which another thread takes
  std::vector<ClientEvent> events;
};

} // namespace flipbook::app::serve
