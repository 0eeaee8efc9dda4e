// SPDX-License-Identifier: MIT
#include "app/serve/gate.h"

#include "sim/frame/errors.h"
#include "sim/frame/text.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <netinet/in.h>
#include <sys/random.h>
#include <system_error>

namespace flipbook::app::serve {
namespace {

/// "name" of "name:80" and "[::1]" of "[::1]:80"; empty for what is neither.
std::string_view without_port(std::string_view host) {
  const std::size_t end = host.starts_with('[') ? host.find(']') : std::string_view::npos;
  if (host.starts_with('[') && end == std::string_view::npos) return {};
  const std::size_t colon = host.find(':', end == std::string_view::npos ? 0 : end);
  if (colon == std::string_view::npos) return host;
  const std::string_view port = host.substr(colon + 1);
  const bool digits =
      port.size() <= 5 && std::all_of(port.begin(), port.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits ? host.substr(0, colon) : std::string_view{};
}

struct Address {
  bool is_one = false, loopback = false;
};

Address address_of(std::string_view name) {
  const bool bracketed = name.size() > 2 && name.front() == '[' && name.back() == ']';
  const std::string text(bracketed ? name.substr(1, name.size() - 2) : name);
  in_addr four{};
  in6_addr six{};
  if (!bracketed && inet_pton(AF_INET, text.c_str(), &four) == 1) return {true, ntohl(four.s_addr) >> 24U == 127};
  if (bracketed && inet_pton(AF_INET6, text.c_str(), &six) == 1) return {true, IN6_IS_ADDR_LOOPBACK(&six) != 0};
  return {};
}

} // namespace

std::string random_token() {
  std::array<std::uint8_t, 16> bytes{};
  for (std::size_t have = 0; have < bytes.size();) {
    const ssize_t n = getrandom(bytes.data() + have, bytes.size() - have, 0);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw MachineError("no random numbers: " + std::generic_category().message(errno));
    have += static_cast<std::size_t>(n);
  }
  std::string text;
  for (const std::uint8_t b : bytes) {
    text += "0123456789abcdef"[b >> 4U];
    text += "0123456789abcdef"[b & 15U];
  }
  return text;
}

std::string chosen_token() {
  const char* given = std::getenv("FLIPBOOK_TOKEN");
  if (!given || *given == '\0') return random_token();
  const std::string token = given;
  constexpr std::size_t shortest = 16, longest = 128;
  const bool plain = std::all_of(token.begin(), token.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (!plain || token.size() < shortest || token.size() > longest)
    throw UserError("FLIPBOOK_TOKEN: a token has 16 to 128 letters, digits, _ and -");
  return token;
}

bool same_token(std::string_view given, std::string_view token) {
  if (given.size() != token.size()) return false;
  unsigned differs = 0;
  for (std::size_t i = 0; i < token.size(); ++i)
    differs |= static_cast<unsigned>(static_cast<unsigned char>(given[i]) ^ static_cast<unsigned char>(token[i]));
  return differs == 0;
}

bool host_allowed(std::string_view host, const OwnNames& own) {
  const std::string_view name = without_port(host);
  if (name.empty()) return false;
  if (same_word(name, "localhost")) return true;
  if (const Address a = address_of(name); a.is_one) return a.loopback || !own.loopback;
  return !own.loopback &&
         std::any_of(own.names.begin(), own.names.end(), [&](const std::string& n) { return same_word(n, name); });
}

bool origin_allowed(std::string_view origin, std::string_view host) {
  if (origin.empty()) return true;
  for (const std::string_view scheme : {"http://", "https://"})
    if (origin.size() > scheme.size() && same_word(origin.substr(0, scheme.size()), scheme))
      return same_word(origin.substr(scheme.size()), host);
  return false;
}

std::string_view path_of(std::string_view target) {
  return target.substr(0, std::min(target.find('?'), target.size()));
}

std::string query_value(std::string_view target, std::string_view name) {
  std::size_t at = target.find('?');
  while (at < target.size()) {
    const std::size_t end = std::min(target.find('&', at + 1), target.size());
    const std::string_view pair = target.substr(at + 1, end - at - 1);
    const std::size_t equals = pair.find('=');
    if (equals != std::string_view::npos && pair.substr(0, equals) == name) return std::string(pair.substr(equals + 1));
    at = end;
  }
  return {};
}

} // namespace flipbook::app::serve
