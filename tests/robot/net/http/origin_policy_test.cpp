#include "robot/net/http/origin_policy.h"

#include <gtest/gtest.h>

#include "robot/net/serve/routes.h"

namespace robot::net {
namespace {

const OriginPolicy kPolicy{.hosts = {"Nao.Lab.example.org", "nao.local"},
                           .origins = {"https://lab.example.org"},
                           .robots = {"10.0.14.2", "nao2"}};

TEST(OriginPolicy, AcceptsOurOwnHosts) {
  for (const char* host :
       {"127.0.0.1", "127.0.0.1:8765", "10.0.14.7:8765", "[::1]", "[fe80::1]:8765", "localhost", "LOCALHOST:80",
        "nao.local", "nao.local:8765", "nao.lab.example.org", "NAO.lab.example.org:1", "nao2:8765"})
    EXPECT_TRUE(check_host(kPolicy, host)) << host;
}

TEST(OriginPolicy, RefusesForeignHosts) {
  for (const char* host : {"", "evil.example.com", "evil.example.com:8765", "localhost.evil.com", "nao.local.evil.com",
                           ".local", "local", "evil.local", "nao3.local:8765", "127.0.0.1.evil.com", "127.0.0.1:80:90",
                           "127.0.0.1:8a", "[::1", "nao.lab.example.org.", "127.0.0.1@evil.com"})
    EXPECT_FALSE(check_host(kPolicy, host)) << host;
  EXPECT_EQ(check_host(kPolicy, "nao.lan:8765").error(),
            "host 'nao.lan:8765' is not a name of this robot; if it is, start it with --allow-host nao.lan");
}

TEST(OriginPolicy, KnowsTheNamesOfAMachine) {
  EXPECT_EQ(names_of_machine("Nao14"), (std::vector<std::string>{"nao14", "nao14", "nao14.local"}));
  EXPECT_EQ(names_of_machine("nao14.lab"), (std::vector<std::string>{"nao14.lab", "nao14", "nao14.local"}));
  EXPECT_TRUE(names_of_machine("").empty());
}

TEST(OriginPolicy, AcceptsThePagesThatMayConnect) {
  const std::string host = "nao.local:8765";
  EXPECT_TRUE(check_origin(kPolicy, std::nullopt, host));
  for (const char* origin :
       {"http://nao.local:8765", "http://NAO.local:8765", "file://", "http://localhost:5173", "https://localhost",
        "http://127.0.0.1:8080", "http://[::1]:8080", "https://app.foxglove.dev", "https://lab.example.org",
        "http://10.0.14.2:8765", "http://nao2:9"})
    EXPECT_TRUE(check_origin(kPolicy, origin, host)) << origin;
}

TEST(OriginPolicy, RefusesOtherPages) {
  for (const char* origin :
       {"", "null", "http://evil.example.com", "http://nao.local:80", "https://app.foxglove.dev.evil.com",
        "http://app.foxglove.dev", "http://localhost.evil.com", "http://127.0.0.1.evil.com", "ftp://localhost",
        "https://lab.example.org:444", "http://10.0.14.3:8765", "file://x", "http://", "localhost"})
    EXPECT_FALSE(check_origin(kPolicy, origin, "nao.local:8765")) << origin;
  EXPECT_EQ(check_origin(kPolicy, "http://evil.com", "nao.local").error(),
            "pages of 'http://evil.com' may not connect to this robot; if they should, start it with --allow-origin "
            "http://evil.com");
}

TEST(OriginPolicy, KnowsLoopback) {
  for (const char* address : {"127.0.0.1", "127.255.0.9", "::1", "::ffff:127.0.0.1"})
    EXPECT_TRUE(is_loopback(address)) << address;
  for (const char* address : {"10.0.0.1", "128.0.0.1", "::2", "::ffff:10.0.0.1", "fe80::1", "", "localhost", "::"})
    EXPECT_FALSE(is_loopback(address)) << address;
}

TEST(Frames, AreForNobodyOrForTheNamedPages) {
  EXPECT_EQ(*frame_ancestors({}), "'none'");
  EXPECT_EQ(*frame_ancestors({"https://lab.example.org", "http://10.0.0.9:8080", "http://[fe80::1]:80"}),
            "https://lab.example.org http://10.0.0.9:8080 http://[fe80::1]:80");
  for (const char* page : {"", "https://", "lab.example.org", "*", "https://*", "https://a b", "https://a;script-src",
                           "https://a/b", "ftp://a", "https://a\r\nX: y", "https://a,https://b"})
    EXPECT_FALSE(frame_ancestors({"https://good", page})) << page;
  EXPECT_EQ(frame_ancestors({"lab"}).error(),
            "--allow-frame: expected a page such as https://lab.example.org, got 'lab'");
}

TEST(Token, IsTheWholeTokenAndNotEmpty) {
  EXPECT_TRUE(same_token("secret", "secret"));
  for (const char* given : {"", "secre", "secret1", "Secret", "secretsecret"})
    EXPECT_FALSE(same_token(given, "secret")) << given;
  EXPECT_FALSE(same_token("", ""));
}

TEST(Token, DecidesWhoMayWatchAndControl) {
  const AccessOptions open{.control_token = "c"}, closed{.control_token = "c", .read_token = "r"}, none{};
  const struct {
    const AccessOptions& options;
    const char *address, *token;
    bool watch, control;
  } cases[] = {
      {open, "127.0.0.1", "", true, true},        {open, "10.0.0.9", "", true, false},
      {open, "10.0.0.9", "c", true, true},        {open, "10.0.0.9", "x", true, false},
      {closed, "127.0.0.1", "", true, true},      {closed, "10.0.0.9", "", false, false},
      {closed, "10.0.0.9", "r", true, false},     {closed, "10.0.0.9", "c", true, true},
      {closed, "10.0.0.9", "x", false, false},    {none, "10.0.0.9", "", true, false},
      {none, "::ffff:127.0.0.1", "", true, true},
  };
  for (const auto& [options, address, token, watch, control] : cases) {
    const Access access = access_of(options, address, {}, {.path = "/", .query = "", .parameters = {{"token", token}}});
    EXPECT_EQ(access.may_watch, watch) << address << " " << token;
    EXPECT_EQ(access.may_control, control) << address << " " << token;
  }
}

}  // namespace
}  // namespace robot::net
