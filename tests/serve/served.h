// SPDX-License-Identifier: MIT
// A server that runs, and a client that talks to it over a plain socket: no library, so that it can also say what no
// library would.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace flipbook::test {

/// `flipbook serve`, until it is told to end.
class Served {
public:
  Served(const std::vector<std::string>& arguments, const std::filesystem::path& where);
  ~Served(); ///< kills it if it still runs
  Served(const Served&) = delete;
  Served& operator=(const Served&) = delete;

  [[nodiscard]] int port() const { return port_; }
  [[nodiscard]] const std::string& token() const { return token_; }
  [[nodiscard]] bool runs() const;
  [[nodiscard]] std::size_t memory() const; ///< bytes that it holds now
  /// Ctrl-C; the exit code, or 1000 + signal. 2000: it does not end.
  int interrupt();

private:
  int pid_ = -1, port_ = 0;
  std::string token_;
};

/// What came from the server.
struct Arrived {
  enum class What { nothing, text, picture, closed } what = What::nothing;
  nlohmann::json json;
  std::uint32_t picture = 0, width = 0, height = 0, input = 0, frame = 0;
  std::vector<std::uint8_t> jpeg;
  int code = 0; ///< of closed: that of the close frame; 0: the connection was cut
};

class WebClient {
public:
  /// Connects and asks for a WebSocket. `headers` stand in place of the usual Host.
  WebClient(int port, const std::string& target, const std::string& headers = "");
  explicit WebClient(const Served& server) : WebClient(server.port(), "/ws?token=" + server.token()) {}
  ~WebClient();
  WebClient(const WebClient&) = delete;
  WebClient& operator=(const WebClient&) = delete;

  [[nodiscard]] int status() const { return status_; } ///< of the answer; 101: it is a WebSocket
  void say(const std::string& text) const { frame(0x81, text); }
  void say(const nlohmann::json& json) const { say(json.dump()); }
  void act(const std::string& action) const { say(nlohmann::json{{"type", "do"}, {"action", action}}); }
  /// A frame with any first byte.
  void frame(std::uint8_t first, const std::string& payload) const;
  void raw(const std::string& bytes) const;
  /// The next thing, or nothing within the time. Pictures are acknowledged unless `acknowledge` is false.
  Arrived next(double seconds);
  bool acknowledge = true;
  /// The first text for which it holds; a failure if none comes.
  nlohmann::json until(const std::function<bool(const nlohmann::json&)>& holds, double seconds = 60);
  nlohmann::json until(const std::string& type, double seconds = 60);
  /// The code with which the server closes; -1 if it does not.
  int closed(double seconds = 20);

private:
  bool fill(std::size_t bytes, double until);

  int socket_ = -1, status_ = 0;
  std::string buffer_;
};

/// The status of a plain request, and its body.
std::pair<int, std::string> http_get(int port, const std::string& request);

/// Everything of a PNG file but its texts: equal for equal pixels.
[[nodiscard]] std::string pixels_of(const std::filesystem::path& png);

} // namespace flipbook::test
