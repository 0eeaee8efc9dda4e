// SPDX-License-Identifier: MIT
#include "tests/serve/served.h"

#include "tests/cli/program.h"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace flipbook::test {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::uint32_t little(const std::string& s, std::size_t at) {
  std::uint32_t x = 0;
  for (std::size_t i = 4; i-- > 0;) x = x << 8U | static_cast<std::uint8_t>(s[at + i]);
  return x;
}

int connected(int port) {
  const int s = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(s, reinterpret_cast<sockaddr*>(&to), sizeof to) != 0) ADD_FAILURE() << "no connection to port " << port;
  return s;
}

bool send_all(int s, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = send(s, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

bool receive(int s, std::string& into, double until) {
  pollfd p{s, POLLIN, 0};
  const double left = until - now();
  if (left <= 0 || poll(&p, 1, static_cast<int>(1000 * left) + 1) <= 0) return false;
  char part[65536];
  const ssize_t n = recv(s, part, sizeof part, 0);
  if (n <= 0) return false;
  into.append(part, static_cast<std::size_t>(n));
  return true;
}

} // namespace

// === The server

Served::Served(const std::vector<std::string>& arguments, const std::filesystem::path& where) {
  const std::string program = std::string(FLIPBOOK_BINARY_DIR) + "/flipbook";
  std::vector<std::string> words{program, "serve"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  int said[2];
  if (pipe2(said, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  pid_ = fork();
  if (pid_ == 0) {
    dup2(said[1], STDOUT_FILENO);
    if (chdir(where.c_str()) != 0) _exit(127);
    std::vector<char*> argv;
    for (std::string& w : words) argv.push_back(w.data());
    argv.push_back(nullptr);
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  close(said[1]);
  std::string line;
  for (char c = 0; read(said[0], &c, 1) == 1 && c != '\n';) line += c;
  // The rest of what it says is read by nobody, and must not stop it.
  std::thread([fd = said[0]] {
    char rest[4096];
    while (read(fd, rest, sizeof rest) > 0) {
    }
    close(fd);
  }).detach();
  const std::size_t hash = line.find("/#token="), colon = line.rfind(':', hash);
  if (hash == std::string::npos) throw std::runtime_error("the server said: " + line);
  port_ = std::stoi(line.substr(colon + 1));
  token_ = line.substr(hash + 8);
}

Served::~Served() {
  if (pid_ <= 0) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

bool Served::runs() const {
  return pid_ > 0 && waitpid(pid_, nullptr, WNOHANG) == 0;
}

std::size_t Served::memory() const {
  std::ifstream in("/proc/" + std::to_string(pid_) + "/statm");
  std::size_t total = 0, resident = 0;
  in >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

int Served::interrupt() {
  kill(pid_, SIGINT);
  int status = 0;
  for (const double end = now() + 60; now() < end; std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
    if (waitpid(pid_, &status, WNOHANG) != pid_) continue;
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  return 2000;
}

// === The client

WebClient::WebClient(int port, const std::string& target, const std::string& headers) : socket_(connected(port)) {
  const std::string host = headers.empty() ? "Host: 127.0.0.1:" + std::to_string(port) + "\r\n" : headers;
  send_all(socket_, "GET " + target + " HTTP/1.1\r\n" + host +
                        "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                        "Sec-WebSocket-Version: 13\r\n\r\n");
  const double end = now() + 20;
  std::size_t header = std::string::npos;
  while ((header = buffer_.find("\r\n\r\n")) == std::string::npos && receive(socket_, buffer_, end)) {
  }
  if (buffer_.size() > 12) status_ = std::stoi(buffer_.substr(9, 3));
  if (header != std::string::npos) buffer_.erase(0, header + 4);
}

WebClient::~WebClient() {
  close(socket_);
}

void WebClient::raw(const std::string& bytes) const {
  send_all(socket_, bytes);
}

void WebClient::frame(std::uint8_t first, const std::string& payload) const {
  std::string bytes(1, static_cast<char>(first));
  if (payload.size() < 126) {
    bytes += static_cast<char>(0x80U | payload.size());
  } else {
    bytes += static_cast<char>(0x80U | 126U);
    bytes += static_cast<char>(payload.size() >> 8U & 255U);
    bytes += static_cast<char>(payload.size() & 255U);
  }
  const std::string mask = "\x12\x34\x56\x78";
  bytes += mask;
  for (std::size_t i = 0; i < payload.size(); ++i) bytes += static_cast<char>(payload[i] ^ mask[i % 4]);
  send_all(socket_, bytes);
}

bool WebClient::fill(std::size_t bytes, double until) {
  while (buffer_.size() < bytes)
    if (!receive(socket_, buffer_, until)) return false;
  return true;
}

Arrived WebClient::next(double seconds) {
  const double until = now() + seconds;
  for (;;) {
    Arrived a;
    if (!fill(2, until)) {
      a.what = now() < until ? Arrived::What::closed : Arrived::What::nothing;
      return a;
    }
    const unsigned opcode = static_cast<std::uint8_t>(buffer_[0]) & 15U;
    std::uint64_t size = static_cast<std::uint8_t>(buffer_[1]) & 127U;
    std::size_t at = 2;
    const std::size_t more = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (!fill(2 + more, until)) return a;
    if (more > 0) size = 0;
    for (; at < 2 + more; ++at) size = size << 8U | static_cast<std::uint8_t>(buffer_[at]);
    if (!fill(at + size, until)) return a;
    const std::string payload = buffer_.substr(at, size);
    buffer_.erase(0, at + size);
    if (opcode == 9) frame(0x8a, payload); // ping
    if (opcode == 1) {
      a.what = Arrived::What::text;
      a.json = nlohmann::json::parse(payload);
      return a;
    }
    if (opcode == 8) {
      a.what = Arrived::What::closed;
      if (payload.size() >= 2)
        a.code = static_cast<std::uint8_t>(payload[0]) * 256 + static_cast<std::uint8_t>(payload[1]);
      return a;
    }
    if (opcode != 2 || payload.size() < 24) continue;
    a.what = Arrived::What::picture;
    a.picture = little(payload, 4);
    a.width = little(payload, 8);
    a.height = little(payload, 12);
    a.input = little(payload, 16);
    a.frame = little(payload, 20);
    a.jpeg.assign(payload.begin() + 24, payload.end());
    if (acknowledge) say(nlohmann::json{{"type", "ack"}, {"picture", a.picture}});
    return a;
  }
}

nlohmann::json WebClient::until(const std::function<bool(const nlohmann::json&)>& holds, double seconds) {
  for (const double end = now() + seconds; now() < end;) {
    const Arrived a = next(end - now());
    if (a.what == Arrived::What::closed) break;
    if (a.what == Arrived::What::text && holds(a.json)) return a.json;
  }
  ADD_FAILURE() << "it never came";
  return nlohmann::json::object();
}

nlohmann::json WebClient::until(const std::string& type, double seconds) {
  return until([&](const nlohmann::json& j) { return j["type"] == type; }, seconds);
}

int WebClient::closed(double seconds) {
  for (const double end = now() + seconds; now() < end;) {
    const Arrived a = next(end - now());
    if (a.what == Arrived::What::closed) return a.code;
  }
  return -1;
}

std::pair<int, std::string> http_get(int port, const std::string& request) {
  const int s = connected(port);
  send_all(s, request);
  std::string answer;
  const double end = now() + 20;
  while (receive(s, answer, end)) {
  }
  close(s);
  const std::size_t body = answer.find("\r\n\r\n");
  if (answer.size() < 12 || body == std::string::npos) return {0, answer};
  return {std::stoi(answer.substr(9, 3)), answer.substr(body + 4)};
}

std::string pixels_of(const std::filesystem::path& png) {
  const std::string bytes = read_file(png);
  std::string rest;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) size = size << 8U | static_cast<std::uint8_t>(bytes[at + i]);
    const std::string kind = bytes.substr(at + 4, 4);
    if (kind != "iTXt" && kind != "tEXt") rest += kind + bytes.substr(at + 8, size);
    at += size + 12;
  }
  return rest;
}

} // namespace flipbook::test
