// SPDX-License-Identifier: MIT
// The one file that is made of Boost.Beast; hub.h, client.h and request.h are parts of it.
#include "app/serve/server.h"

#include "app/serve/request.h"
#include "sim/frame/errors.h"

#include <limits.h>
#include <thread>
#include <unistd.h>

namespace flipbook::app::serve {

static constexpr std::size_t most_connections = 64; // waiting, asking for files, or clients

struct Server::Impl {
  Impl(const ServerOptions& options, std::function<void()> wake)
      : hub(std::move(wake)), acceptor(context), pause(context) {
    hub.most_clients = options.most_clients;
    listen(options);
    accept();
    thread = std::thread([this] { run(); });
  }

  ~Impl() {
    asio::post(context, [this] { say_goodbye(); });
    thread.join();
    hub.clients.clear(); // their sockets need the context
  }

  /// What one connection cannot do (no memory) ends no other.
  void run() {
    for (bool again = true; again;) {
      again = false;
      try {
        context.run();
      } catch (const std::exception&) {
        again = true;
      }
    }
  }

  void listen(const ServerOptions& options) {
    Error e;
    tcp::resolver resolver(context);
    const auto found = resolver.resolve(options.host, std::to_string(options.port), tcp::resolver::passive, e);
    if (e || found.empty())
      throw UserError("--host " + options.host + ": it is an address or a name of this machine (" + e.message() + ")");
    const tcp::endpoint at = found.begin()->endpoint();
    const auto fail = [&] {
      throw MachineError("cannot listen on " + options.host + " port " + std::to_string(options.port) + ": " +
                         e.message());
    };
    acceptor.open(at.protocol(), e);
    if (e) fail();
    acceptor.set_option(tcp::acceptor::reuse_address(true), e);
    acceptor.bind(at, e);
    if (e) fail();
    acceptor.listen(asio::socket_base::max_listen_connections, e);
    if (e) fail();
    name_it(options.host, at.address());
  }

  void name_it(const std::string& host, const asio::ip::address& address) {
    std::array<char, HOST_NAME_MAX + 1> machine{};
    gethostname(machine.data(), machine.size() - 1);
    hub.names = {address.is_loopback(), {host, machine.data()}};
    const std::string own = address.is_unspecified() ? machine.data() : host;
    const bool brackets = own.find(':') != std::string::npos;
    url = "http://" + (brackets ? "[" + own + "]" : own) + ":" + std::to_string(acceptor.local_endpoint().port()) +
          "/#token=" + hub.token;
  }

  void accept() {
    acceptor.async_accept([this](Error e, tcp::socket socket) {
      if (e == asio::error::operation_aborted) return;
      if (!e && hub.connections < most_connections) std::make_shared<Request>(std::move(socket), hub)->run();
      if (!e) return accept();
      pause.expires_after(std::chrono::milliseconds(200)); // no more files, for example: others may end soon
      pause.async_wait([this](Error stopped) {
        if (!stopped) accept();
      });
    });
  }

  void say_goodbye() {
    Error ignored;
    acceptor.close(ignored);
    pause.cancel();
    const auto clients = hub.clients;
    for (const auto& [id, client] : clients) client->close(websocket::close_code::going_away, "flipbook has ended");
    // A client that does not answer is not waited for.
    pause.expires_after(std::chrono::milliseconds(300));
    pause.async_wait([this](Error) { context.stop(); });
  }

  Hub hub; // outlives the context, whose handlers hold clients
  asio::io_context context{1};
  tcp::acceptor acceptor;
  asio::steady_timer pause;
  std::string url;
  std::thread thread;
};

Server::Server(const ServerOptions& options, std::function<void()> wake)
    : impl_(std::make_unique<Impl>(options, std::move(wake))) {}
Server::~Server() = default;

std::string Server::url() const {
  return impl_->url;
}
bool Server::loopback() const {
  return impl_->hub.names.loopback;
}

std::vector<ClientEvent> Server::take_events() {
  const std::scoped_lock lock(impl_->hub.mutex);
  return std::exchange(impl_->hub.events, {});
}

bool Server::wanted() const {
  return impl_->hub.wanting > 0;
}

void Server::send(ClientId client, std::string text) {
  asio::post(impl_->context, [this, client, text = std::make_shared<const std::string>(std::move(text))] {
    const auto at = impl_->hub.clients.find(client);
    if (at == impl_->hub.clients.end()) return;
    const auto held = at->second; // it may leave
    held->send(text);
  });
}

void Server::send_all(std::string text) {
  asio::post(impl_->context, [this, text = std::make_shared<const std::string>(std::move(text))] {
    const auto clients = impl_->hub.clients; // some may leave
    for (const auto& [id, client] : clients) client->send(text);
  });
}

void Server::publish(std::shared_ptr<const ServedPicture> picture) {
  asio::post(impl_->context, [this, picture = std::move(picture)] {
    impl_->hub.newest = {picture, {}};
    const auto clients = impl_->hub.clients;
    for (const auto& [id, client] : clients) client->offer();
    impl_->hub.count_wanting();
  });
}

} // namespace flipbook::app::serve
