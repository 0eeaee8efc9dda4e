// SPDX-License-Identifier: MIT
// The way to the browsers: HTTP for the page's files, a WebSocket for each client. One thread of its own does all of
// it; what clients say goes through parse_message() into one bounded inbox, and pictures go out newest first. Knows
// nothing of simulations.
//
// A client that says what is no message, or says too much, loses its connection, and nobody else notices.
#pragma once

#include "app/serve/messages.h"
#include "render/image.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace flipbook::app::serve {

using ClientId = std::uint32_t; ///< from 1, never used again

/// A picture for all clients. The newest one waits for each of them, older ones are forgotten.
struct ServedPicture {
  std::uint32_t number = 0;
  std::uint64_t frame = 0;
  render::Image image;
  ClientId driver = 0;        ///< whose input it reflects,
  std::uint32_t last_seq = 0; ///< up to this
};

/// What happened at a client.
struct ClientEvent {
  enum class What { joined, left, said };
  ClientId client = 0;
  What what = What::said;
  ClientMessage message{};
};

struct ServerOptions {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0; ///< 0: any that is free
  std::size_t most_clients = 12;
};

class Server {
public:
  /// Listens from here on; throws UserError for a host that is none, MachineError for a port that cannot be had.
  /// `wake` is called on the server's thread after something came into the inbox or a client can take a picture.
  Server(const ServerOptions& options, std::function<void()> wake);
  /// Tells all clients that the program ends.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] std::string url() const; ///< with the token
  [[nodiscard]] bool loopback() const;   ///< can only this machine reach it?

  /// Everything since the last call, in order.
  [[nodiscard]] std::vector<ClientEvent> take_events();
  /// Can any client take another picture now?
  [[nodiscard]] bool wanted() const;
  /// A JSON text to one client, or to all of them. A client with too much waiting loses its connection.
  void send(ClientId client, std::string text);
  void send_all(std::string text);
  void publish(std::shared_ptr<const ServedPicture> picture);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace flipbook::app::serve
