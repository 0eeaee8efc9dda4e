// SPDX-License-Identifier: MIT
// One client's WebSocket. A part of server.cpp.
#pragma once

#include "app/serve/beast.h"
#include "app/serve/hub.h"

#include <chrono>
#include <deque>
#include <optional>

namespace flipbook::app::serve {

inline constexpr std::size_t most_waiting_texts = 256, most_waiting_bytes = 4U << 20U;
inline constexpr double messages_per_second = 250, message_burst = 500;
inline constexpr auto request_time = std::chrono::seconds(10);
inline constexpr auto silence = std::chrono::seconds(60); ///< longest without a sign of life

/// Why a connection is closed, beside the reasons of the protocol.
enum Close : std::uint16_t { malformed = 4400, wrong_token = 4401, too_many_clients = 4409, too_many_messages = 4429 };

inline double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// It lives as long as something of it is under way.
class Client : public std::enable_shared_from_this<Client> {
public:
  Client(tcp::socket socket, Hub& hub) : ws_(std::move(socket)), hub_(hub) { ++hub_.connections; }
  ~Client() { --hub_.connections; }

  void accept(const http::request<http::empty_body>& request) {
    token_ok_ = same_token(query_value(text_of(request.target()), "token"), hub_.token);
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = request_time;
    timeout.idle_timeout = silence;
    timeout.keep_alive_pings = true;
    ws_.set_option(timeout);
    ws_.read_message_max(longest_message);
    ws_.auto_fragment(false);
    ws_.async_accept(request, [self = shared_from_this()](Error e) {
      if (!e) self->opened();
    });
  }

  void send(std::shared_ptr<const std::string> text) {
    if (ending_) return;
    greeted_ = true;
    waiting_bytes_ += text->size();
    texts_.push_back(std::move(text));
    if (texts_.size() > most_waiting_texts || waiting_bytes_ > most_waiting_bytes) return drop();
    write();
  }
  /// There is a newer picture.
  void offer() {
    fresh_ = true;
    write();
  }
  [[nodiscard]] bool wants() const { return id_ != 0 && !ending_ && flow_.open() && !fresh_; }

  void close(std::uint16_t code, const char* why) {
    if (ending_) return;
    ending_ = true;
    leave();
    goodbye_ = websocket::close_reason(static_cast<websocket::close_code>(code), why);
    if (!writing_) say_goodbye();
  }
  [[nodiscard]] bool gone() const { return ending_ && said_goodbye_; }

private:
  void opened() {
    ws_.next_layer().set_option(tcp::no_delay(true));
    if (!token_ok_) return close(wrong_token, "the link is not valid: the token is wrong");
    if (hub_.clients.size() >= hub_.most_clients) return close(too_many_clients, "too many clients are connected");
    id_ = ++hub_.last_client;
    hub_.clients.emplace(id_, shared_from_this());
    fresh_ = hub_.newest.picture != nullptr;
    hub_.happened({id_, ClientEvent::What::joined, {}});
    hub_.count_wanting();
    read();
    write();
  }

  void leave() {
    if (id_ == 0 || hub_.clients.erase(id_) == 0) return;
    hub_.happened({id_, ClientEvent::What::left, {}});
    hub_.count_wanting();
  }

  /// The connection is broken, or its other end does not read.
  void drop() {
    ending_ = said_goodbye_ = true;
    leave();
    Error ignored;
    ws_.next_layer().close(ignored);
  }

  void read() {
    ws_.async_read(buffer_, [self = shared_from_this()](Error e, std::size_t) {
      if (e == websocket::error::message_too_big || e == websocket::error::bad_frame_payload) // Beast has said so
        return self->drop();
      if (e) return self->drop();
      self->received();
    });
  }

  void received() {
    if (ending_) return;
    if (!rate_.take(clock_seconds())) return close(too_many_messages, "too many messages");
    std::string why = "a message is a text";
    std::optional<ClientMessage> message;
    if (ws_.got_text()) {
      const auto bytes = buffer_.cdata();
      message = parse_message({static_cast<const char*>(bytes.data()), bytes.size()}, why);
    }
    buffer_.consume(buffer_.size());
    if (!message) return close(malformed, why.c_str());
    if (const auto* ack = std::get_if<AckMessage>(&*message)) {
      flow_.acknowledged(ack->picture, clock_seconds());
      hub_.count_wanting();
      if (wants()) hub_.wake();
      write();
    } else {
      hub_.happened({id_, ClientEvent::What::said, std::move(*message)});
    }
    read();
  }

  /// Texts first, then the newest picture if it may go.
  void write() {
    if (writing_ || ending_ || id_ == 0) return;
    if (!texts_.empty()) {
      waiting_bytes_ -= texts_.front()->size();
      text_ = std::move(texts_.front());
      texts_.pop_front();
      ws_.text(true);
      return write(asio::buffer(*text_));
    }
    if (!greeted_ || !fresh_ || !flow_.open() || !hub_.newest.picture) return;
    fresh_ = false;
    hub_.coded(flow_.grade());
    jpeg_ = hub_.newest.coded[flow_.grade()];
    const ServedPicture& p = *hub_.newest.picture;
    flow_.sent(p.number, clock_seconds());
    hub_.count_wanting();
    write_header(p);
    ws_.binary(true);
    write(std::array<asio::const_buffer, 2>{asio::buffer(header_), asio::buffer(jpeg_->bytes)});
  }

  /// See README.md.
  void write_header(const ServedPicture& p) {
    header_ = {1, 0, 0, 0};
    std::size_t at = 4;
    for (const std::uint32_t x :
         {p.number, static_cast<std::uint32_t>(jpeg_->width), static_cast<std::uint32_t>(jpeg_->height),
          p.driver == id_ ? p.last_seq : 0U, static_cast<std::uint32_t>(p.frame)})
      for (unsigned shift = 0; shift < 32; shift += 8) header_[at++] = static_cast<std::uint8_t>(x >> shift & 255U);
  }

  template <class Buffers> void write(const Buffers& buffers) {
    writing_ = true;
    ws_.async_write(buffers, [self = shared_from_this()](Error e, std::size_t) {
      self->writing_ = false;
      if (e) return self->drop();
      if (self->ending_) return self->say_goodbye();
      self->write();
    });
  }

  void say_goodbye() {
    if (said_goodbye_) return;
    said_goodbye_ = true;
    ws_.async_close(goodbye_, [self = shared_from_this()](Error) {});
  }

  websocket::stream<tcp::socket> ws_;
  Hub& hub_;
  ClientId id_ = 0;                         ///< 0: has not come in
  bool token_ok_ = false, greeted_ = false; ///< greeted: it was told who it is, before any picture
  beast::flat_buffer buffer_{longest_message};
  RateLimit rate_{messages_per_second, message_burst};
  Flow flow_;
  bool fresh_ = false; ///< is the newest picture one that it has not got?
  bool writing_ = false, ending_ = false, said_goodbye_ = false;
  std::deque<std::shared_ptr<const std::string>> texts_;
  std::size_t waiting_bytes_ = 0;
  std::shared_ptr<const std::string> text_; ///< on its way
  std::shared_ptr<const Jpeg> jpeg_;        ///< likewise
  std::array<std::uint8_t, 24> header_{};
  websocket::close_reason goodbye_;
};

inline void Hub::count_wanting() {
  int n = 0;
  for (const auto& [id, client] : clients) n += client->wants() ? 1 : 0;
  wanting = n;
}

} // namespace flipbook::app::serve
