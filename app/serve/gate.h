// SPDX-License-Identifier: MIT
// Who may come in: what a request's headers and its token must be. Pure functions, apart from the token's making.
//
// A page of another site can make a browser send requests here, and a name of its own can lead to this address ("DNS
// rebinding"). Both betray themselves: the first by its Origin, the second by its Host, which is not a name of ours.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flipbook::app::serve {

/// 128 random bits of the operating system, as 32 hexadecimal digits. Throws MachineError.
[[nodiscard]] std::string random_token();

/// The one that the environment variable FLIPBOOK_TOKEN holds, so that pages find a server that was started again; a
/// random one where there is none. Throws UserError for one that could be guessed or does not belong into a link.
[[nodiscard]] std::string chosen_token();

/// In a time that does not tell how much of it is right.
[[nodiscard]] bool same_token(std::string_view given, std::string_view token);

/// The names by which a server is called.
struct OwnNames {
  bool loopback = true;           ///< it listens on this machine alone
  std::vector<std::string> names; ///< besides "localhost" and addresses
};

/// "localhost:8080", "127.0.0.1", "[::1]:80". On loopback the name must mean loopback (the port may be a tunnel's);
/// else any address will do, and those names.
[[nodiscard]] bool host_allowed(std::string_view host, const OwnNames& own);

/// Empty (not a browser), or the scheme http or https with the same host.
[[nodiscard]] bool origin_allowed(std::string_view origin, std::string_view host);

/// The value of `name` in "/ws?token=abc&x=1"; empty if there is none.
[[nodiscard]] std::string query_value(std::string_view target, std::string_view name);
/// "/ws"
[[nodiscard]] std::string_view path_of(std::string_view target);

} // namespace flipbook::app::serve
