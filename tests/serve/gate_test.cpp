// SPDX-License-Identifier: MIT
// Who may come in.
#include "app/serve/gate.h"
#include "app/serve/page.h"
#include "sim/frame/errors.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace flipbook::app::serve {
namespace {

TEST(Gate, TokensAreRandomAndLong) {
  std::set<std::string> seen;
  for (int i = 0; i < 100; ++i) seen.insert(random_token());
  EXPECT_EQ(seen.size(), 100U);
  for (const std::string& t : seen) {
    EXPECT_EQ(t.size(), 32U);
    EXPECT_EQ(t.find_first_not_of("0123456789abcdef"), std::string::npos);
  }
}

TEST(Gate, AnotherTokenIsTakenFromTheEnvironmentIfItIsLongAndPlain) {
  for (const char* bad :
       {"short", "0123456789abcde", "0123456789abcdef/", "0123456789abcdef ", "0123456789abcdef\u00e9"}) {
    setenv("FLIPBOOK_TOKEN", bad, 1);
    EXPECT_THROW((void)chosen_token(), UserError) << bad;
  }
  setenv("FLIPBOOK_TOKEN", "0123456789-abc_DEF", 1);
  EXPECT_EQ(chosen_token(), "0123456789-abc_DEF");
  unsetenv("FLIPBOOK_TOKEN");
  EXPECT_NE(chosen_token(), chosen_token());
}

TEST(Gate, OnlyTheWholeTokenIsRight) {
  EXPECT_TRUE(same_token("abc", "abc"));
  for (const char* wrong : {"", "ab", "abd", "abcd", "ABC"}) EXPECT_FALSE(same_token(wrong, "abc")) << wrong;
}

TEST(Gate, OnLoopbackOnlyItsOwnNamesAreHosts) {
  const OwnNames own{true, {"machine"}};
  for (const char* host :
       {"localhost", "LOCALHOST:8080", "127.0.0.1", "127.0.0.1:9", "127.1.2.3:80", "[::1]", "[::1]:80"})
    EXPECT_TRUE(host_allowed(host, own)) << host;
  for (const char* host :
       {"", ":80", "evil.example", "evil.example:80", "localhost.evil.example", "machine", "10.0.0.1",
        "127.0.0.1.evil.example", "[::2]", "[::1", "::1", "localhost:x", "localhost:123456", "0x7f000001"})
    EXPECT_FALSE(host_allowed(host, own)) << host;
}

TEST(Gate, BeyondLoopbackAddressesAndTheMachinesNamesAreHosts) {
  const OwnNames own{false, {"machine", "0.0.0.0"}};
  for (const char* host : {"localhost", "machine:80", "Machine", "10.0.0.1:80", "[fe80::1]"})
    EXPECT_TRUE(host_allowed(host, own)) << host;
  for (const char* host : {"evil.example", "", "machine.evil.example"}) EXPECT_FALSE(host_allowed(host, own)) << host;
}

TEST(Gate, AnOriginIsTheSameHostOrNone) {
  EXPECT_TRUE(origin_allowed("", "localhost:80"));
  EXPECT_TRUE(origin_allowed("http://localhost:80", "localhost:80"));
  EXPECT_TRUE(origin_allowed("https://LOCALHOST:80", "localhost:80"));
  for (const char* origin : {"null", "http://", "http://evil.example", "http://localhost", "http://localhost:81",
                             "http://localhost:80.evil.example", "file://localhost:80", "http://localhost:80/"})
    EXPECT_FALSE(origin_allowed(origin, "localhost:80")) << origin;
}

TEST(Gate, ATargetIsAPathAndItsQuery) {
  EXPECT_EQ(path_of("/ws?token=a"), "/ws");
  EXPECT_EQ(path_of("/"), "/");
  EXPECT_EQ(query_value("/ws?token=abc&x=1", "token"), "abc");
  EXPECT_EQ(query_value("/ws?x=1&token=abc", "token"), "abc");
  for (const char* none : {"/ws", "/ws?", "/ws?token", "/ws?atoken=1", "/ws?&&", ""})
    EXPECT_EQ(query_value(none, "token"), "");
}

TEST(Gate, OnlyThePagesFilesAreServed) {
  ASSERT_NE(page_file("/"), nullptr);
  EXPECT_EQ(page_file("/"), page_file("/index.html"));
  EXPECT_EQ(page_file("/")->type(), "text/html; charset=utf-8");
  EXPECT_NE(page_file("/")->text.find("<html"), std::string_view::npos);
  for (const char* none : {"", "//", "/../page.cpp", "/index.html/", "/etc/passwd", "/%2e%2e", "/INDEX.HTML"})
    EXPECT_EQ(page_file(none), nullptr) << none;
}

} // namespace
} // namespace flipbook::app::serve
