// SPDX-License-Identifier: MIT
// One request: a file of the page, or the beginning of a client. A part of server.cpp.
#pragma once

#include "app/serve/beast.h"
#include "app/serve/client.h"
#include "app/serve/page.h"

namespace flipbook::app::serve {

inline constexpr std::size_t longest_header = 8192;

/// One request for each connection: the page is a few small files.
class Request : public std::enable_shared_from_this<Request> {
public:
  Request(tcp::socket socket, Hub& hub) : stream_(std::move(socket)), hub_(hub) {
    parser_.header_limit(longest_header);
    parser_.body_limit(0);
    ++hub_.connections;
  }
  ~Request() { --hub_.connections; }

  void run() {
    stream_.expires_after(request_time);
    http::async_read(stream_, buffer_, parser_, [self = shared_from_this()](Error e, std::size_t) {
      if (!e) self->answer();
    });
  }

private:
  void answer() {
    const auto& request = parser_.get();
    const std::string_view host = text_of(request[http::field::host]), target = text_of(request.target());
    if (request.count(http::field::host) != 1 || !host_allowed(host, hub_.names))
      return reply(http::status::forbidden, "This server is not known by that name.\n");
    host_ok_ = true;
    if (path_of(target) == "/ws" && websocket::is_upgrade(request)) {
      if (request.count(http::field::origin) > 1 || !origin_allowed(text_of(request[http::field::origin]), host))
        return reply(http::status::forbidden, "A page of another site may not connect.\n");
      stream_.expires_never();
      std::make_shared<Client>(stream_.release_socket(), hub_)->accept(parser_.release_());
      return;
    }
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return reply(http::status::method_not_allowed, "Only GET is understood.\n");
    const PageFile* file = page_file(path_of(target));
    if (!file) return reply(http::status::not_found, "There is no such page.\n");
    reply(http::status::ok, file->text, file->type());
  }

  void reply(http::status status, std::string_view text, std::string_view type = "text/plain; charset=utf-8") {
    response_.version(11);
    response_.result(status);
    response_.keep_alive(false);
    const auto set = [&](auto field, std::string_view value) {
      response_.set(field, beast::string_view(value.data(), value.size()));
    };
    set(http::field::content_type, type);
    set(http::field::cache_control, "no-store");
    set("Content-Security-Policy", content_policy());
    set("X-Content-Type-Options", "nosniff");
    set("Referrer-Policy", "no-referrer");
    set("Cross-Origin-Resource-Policy", "same-origin");
    response_.content_length(text.size());
    if (parser_.get().method() != http::verb::head) response_.body() = std::string(text);
    http::async_write(stream_, response_, [self = shared_from_this()](Error, std::size_t) {
      Error ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  /// Nothing from elsewhere. Not every browser counts ws: under 'self'; the host is one of ours.
  [[nodiscard]] std::string content_policy() const {
    const std::string host(host_ok_ ? text_of(parser_.get()[http::field::host]) : std::string_view());
    const std::string sockets = host.empty() ? "" : " ws://" + host + " wss://" + host;
    return "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'" +
           sockets + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
  }

  struct Parser : http::request_parser<http::empty_body> {
    http::request<http::empty_body> release_() { return release(); }
  };

  beast::tcp_stream stream_;
  Hub& hub_;
  beast::flat_buffer buffer_{longest_header};
  Parser parser_;
  bool host_ok_ = false;
  http::response<http::string_body> response_;
};

} // namespace flipbook::app::serve
