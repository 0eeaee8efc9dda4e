// SPDX-License-Identifier: MIT
// Boost.Beast, which takes half a minute to compile: for server.cpp and what is a part of it.
#pragma once

#include <utility> // which Boost 1.74 uses without including it

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <string_view>

namespace flipbook::app::serve {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = asio::ip::tcp;
using Error = beast::error_code;

/// Boost's own kind of view, which changes from version to version.
inline std::string_view text_of(beast::string_view s) {
  return {s.data(), s.size()};
}

} // namespace flipbook::app::serve
