// SPDX-License-Identifier: MIT
// The server from outside: who gets in, who gets what, and what a hostile client can do (nothing).
#include "tests/cli/program.h"
#include "tests/serve/served.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

namespace flipbook::test {
namespace {

const std::vector<std::string> small{"dam_break", "--cells", "24", "--size", "640x360", "--set", "view.plot_height=0"};

class Server : public testing::Test {
protected:
  Folder folder_;
  Served server_{small, folder_.path()};

  std::string host() const { return "Host: 127.0.0.1:" + std::to_string(server_.port()) + "\r\n"; }
  std::string ws() const { return "/ws?token=" + server_.token(); }
};

/// So many pictures; the largest gap of their numbers.
std::uint32_t largest_gap(WebClient& client, int pictures) {
  std::uint32_t last = 0, gap = 0;
  for (int n = 0; n < pictures;) {
    const Arrived a = client.next(30);
    if (a.what == Arrived::What::closed || a.what == Arrived::What::nothing) {
      ADD_FAILURE() << "no more pictures";
      return gap;
    }
    if (a.what != Arrived::What::picture) continue;
    if (last > 0) gap = std::max(gap, a.picture - last);
    EXPECT_GT(a.picture, last);
    last = a.picture;
    ++n;
  }
  return gap;
}

TEST_F(Server, ThePageNeedsNoTokenButAHost) {
  const auto get = [&](const std::string& target, const std::string& headers, const char* verb = "GET") {
    return http_get(server_.port(), std::string(verb) + " " + target + " HTTP/1.1\r\n" + headers + "\r\n").first;
  };
  EXPECT_EQ(get("/", host()), 200);
  EXPECT_EQ(get("/index.html", host()), 200);
  EXPECT_EQ(get("/", "Host: localhost:1234\r\n"), 200); // through a tunnel
  EXPECT_EQ(get("/", "Host: evil.example\r\n"), 403);
  EXPECT_EQ(get("/", host() + "Host: localhost\r\n"), 403);
  EXPECT_EQ(get("/", ""), 403);
  for (const char* none :
       {"/no", "/../README.md", "/index.html/..", "/ws", "//index.html", "/%2e%2e/%2e%2e/etc/passwd"})
    EXPECT_EQ(get(none, host()), 404) << none;
  EXPECT_EQ(get("/", host(), "POST"), 405);
  EXPECT_EQ(get("/" + std::string(20000, 'x'), host()), 0); // no answer to that
  EXPECT_TRUE(server_.runs());
}

TEST_F(Server, OnlyTheRightTokenOriginAndHostGetIn) {
  EXPECT_EQ(WebClient(server_.port(), ws(), "Host: evil.example\r\n").status(), 403);
  EXPECT_EQ(WebClient(server_.port(), ws(), host() + "Origin: http://evil.example\r\n").status(), 403);
  EXPECT_EQ(WebClient(server_.port(), ws(), host() + "Origin: null\r\n").status(), 403);
  const std::string own = "Origin: http://127.0.0.1:" + std::to_string(server_.port()) + "\r\n";
  EXPECT_EQ(WebClient(server_.port(), ws(), host() + own).status(), 101);
  for (const std::string& wrong : {std::string(""), std::string("?token="), "?token=" + std::string(32, '0'),
                                   "?token=" + server_.token() + "0", "?Token=" + server_.token()}) {
    WebClient client(server_.port(), "/ws" + wrong);
    EXPECT_EQ(client.status(), 101) << wrong;
    EXPECT_EQ(client.closed(), 4401) << wrong;
  }
}

TEST_F(Server, TheFirstDrivesAndTheRoleIsPassedOn) {
  auto first = std::make_unique<WebClient>(server_);
  EXPECT_EQ(first->until("hello")["role"], "driver");
  WebClient second(server_);
  EXPECT_EQ(second.until("hello")["role"], "viewer");
  second.act("play"); // which is not for viewers
  second.say(nlohmann::json{{"type", "do"}, {"action", "parameters"}});
  bool ran = false; // states come when something changes: there need not be another one
  const auto until = [&](auto&& is) {
    return second.until([&](auto& j) {
      ran = ran || (j["type"] == "state" && j["running"] == true);
      return is(j);
    });
  };
  EXPECT_EQ(until([](auto& j) { return j["type"] == "parameters"; })["panes"].size(), 4U);
  second.say(nlohmann::json{{"type", "do"}, {"action", "drive"}});
  until([](auto& j) { return j["type"] == "role" && j["role"] == "driver"; });
  EXPECT_FALSE(ran);
  first->until([](auto& j) { return j["type"] == "role" && j["role"] == "viewer"; });
  second.act("play");
  first->until([](auto& j) { return j["type"] == "state" && j["running"] == true; });

  second.say(nlohmann::json{{"type", "do"}, {"action", "drive"}, {"take", false}});
  first->until([](auto& j) { return j["type"] == "role" && j["role"] == "driver"; });
  first.reset(); // and it leaves
  second.until([](auto& j) { return j["type"] == "role" && j["role"] == "driver" && j["clients"] == 1; });
}

TEST_F(Server, ASlowClientGetsFewerPicturesNotOldOnes) {
  WebClient quick(server_), slow(server_);
  quick.until("hello");
  slow.until("hello");
  quick.act("play");
  slow.acknowledge = false;
  EXPECT_LE(largest_gap(quick, 40), 3U);
  int got = 0;
  std::uint32_t newest = 0;
  for (Arrived a = slow.next(0.5); a.what == Arrived::What::picture || a.what == Arrived::What::text;
       a = slow.next(0.5)) {
    got += a.what == Arrived::What::picture ? 1 : 0;
    newest = std::max(newest, a.picture);
    if (got > 2) break;
    if (a.what == Arrived::What::text && a.json["type"] == "state" && got == 2) break;
  }
  EXPECT_EQ(got, 2); // and no more, without an answer
  largest_gap(quick, 10);
  slow.say(nlohmann::json{{"type", "ack"}, {"picture", newest}});
  for (;;) {
    const Arrived a = slow.next(20);
    ASSERT_NE(a.what, Arrived::What::nothing);
    if (a.what != Arrived::What::picture) continue;
    EXPECT_GT(a.picture, newest + 20); // what is new now
    break;
  }
}

TEST_F(Server, ABadMessageEndsOneConnectionAndNothingElse) {
  WebClient good(server_);
  good.until("hello");
  good.act("play");
  for (const std::string& bad : {std::string("nonsense"), std::string("{}"),
                                 std::string(R"({"type":"do","action":"shutdown"})"), std::string("\xff\xfe")}) {
    WebClient client(server_);
    client.until("hello");
    client.say(bad);
    const int code = client.closed();
    EXPECT_TRUE(code == 4400 || code == 1007) << bad << ": " << code;
  }
  {
    WebClient client(server_);
    client.frame(0x82, "binary");
    EXPECT_EQ(client.closed(), 4400);
  }
  {
    WebClient client(server_);
    client.say(std::string(5000, ' '));
    EXPECT_EQ(client.closed(), 1009); // too large
  }
  {
    WebClient client(server_);
    client.raw(std::string("\xff\xff\xff\xff\xff\xff\xff\xff", 8)); // no frame at all
    EXPECT_EQ(client.closed(), 1002);
  }
  {
    WebClient client(server_);
    client.raw(std::string("\x81\xff\x7f\xff\xff\xff\xff\xff\xff\xff", 10)); // of 2^63 bytes
    EXPECT_GT(client.closed(), 0);
  }
  {
    WebClient client(server_);
    for (int i = 0; i < 2000; ++i) client.act("parameters");
    EXPECT_EQ(client.closed(), 4429); // too many
  }
  largest_gap(good, 5);
  EXPECT_TRUE(server_.runs());
}

TEST_F(Server, NamesFromTheNetworkAreNoPaths) {
  WebClient client(server_);
  client.until("hello");
  for (const char* name : {"../../../etc/passwd", "/etc/passwd", "./dam_break.toml", "dam_break.toml", ""}) {
    client.say(nlohmann::json{{"type", "do"}, {"action", "open"}, {"kind", "scene"}, {"name", name}});
    EXPECT_EQ(client.until("message")["level"], "error") << name;
  }
  client.say(nlohmann::json{{"type", "do"}, {"action", "set"}, {"path", "output.ledger"}, {"value", "../x.csv"}});
  EXPECT_EQ(client.until("message")["level"], "error");
  client.say(nlohmann::json{{"type", "do"}, {"action", "open"}, {"kind", "scene"}, {"name", "drop"}});
  client.until([](auto& j) { return j["type"] == "state" && j["name"] == "drop"; });
  EXPECT_TRUE(folder_.files().empty());
}

TEST_F(Server, TooManyClientsAreTurnedAway) {
  std::vector<std::unique_ptr<WebClient>> clients;
  for (int i = 0; i < 12; ++i) {
    clients.push_back(std::make_unique<WebClient>(server_));
    clients.back()->until("hello");
  }
  WebClient late(server_);
  EXPECT_EQ(late.closed(), 4409);
  clients.pop_back();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  WebClient again(server_);
  again.until("hello");
}

TEST_F(Server, ConnectsAndDisconnectsLeaveNothingBehind) {
  const auto come_and_go = [&](int times) {
    for (int i = 0; i < times; ++i) {
      WebClient client(server_);
      if (i % 3 == 0) continue;
      client.until("hello");
      if (i % 3 == 1) client.frame(0x88, "\x03\xe8"); // closes as it should
    }
  };
  come_and_go(60); // what is kept for later is there now
  const std::size_t before = server_.memory();
  come_and_go(300);
  EXPECT_LT(server_.memory(), before + (24U << 20U));
  WebClient driver(server_);
  driver.until("hello");
  driver.act("play");
  driver.until([](auto& j) { return j["type"] == "state" && j["running"] == true; });
}

TEST(ServerBeyondLoopback, SaysSo) {
  const Folder folder;
  const Outcome o =
      run({"serve", "dam_break", "--cells", "16", "--host", "0.0.0.0"}, folder.path(), {.interrupt_after_ms = 1500});
  EXPECT_NE(o.err.find("warning: other machines can reach this server"), std::string::npos) << o.err;
  EXPECT_EQ(o.code, 0);
  expect_refusal(run({"serve", "dam_break", "--host", "no.such.host.invalid"}, folder.path()), 2, {"--host"});
  expect_refusal(run({"serve", "dam_break", "--port", "99999"}, folder.path()), 2, {"--port"});
  expect_refusal(run({"serve", "no_such_scene"}, folder.path()), 2, {"no_such_scene"});
}

} // namespace
} // namespace flipbook::test
