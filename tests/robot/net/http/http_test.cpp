#include "robot/net/http/http.h"

#include <gtest/gtest.h>

#include "robot/net/http/http_parser.h"
#include "robot/net/http/response_head.h"
#include "tests/robot/net/net_support.h"

namespace robot::net {
namespace {

/// "whole", "none" or "3+4": offset and size.
std::string range(std::string_view header, std::uint64_t size) {
  const auto [outcome, bytes] = parse_range(header, size);
  if (outcome == RangeOutcome::whole) return "whole";
  if (outcome == RangeOutcome::unsatisfiable) return "none";
  return std::to_string(bytes.offset) + "+" + std::to_string(bytes.size);
}

TEST(Range, FollowsRfc9110) {
  EXPECT_EQ(range("bytes=0-0", 10), "0+1");
  EXPECT_EQ(range("bytes=3-", 10), "3+7");
  EXPECT_EQ(range("bytes=3-99", 10), "3+7");
  EXPECT_EQ(range("bytes=-4", 10), "6+4");
  EXPECT_EQ(range("bytes=-99", 10), "0+10");
  EXPECT_EQ(range("bytes=10-", 10), "none");
  EXPECT_EQ(range("bytes=-0", 10), "none");
  EXPECT_EQ(range("bytes=0-", 0), "none");
  for (const char* odd : {"", "bytes=", "bytes=-", "bytes=4-3", "bytes=a-b", "bytes=1-2,4-5", "lines=1-2", "bytes=1",
                          "bytes=--1", "bytes=99999999999999999999-"})
    EXPECT_EQ(range(odd, 10), "whole") << odd;
}

TEST(Target, IsParsedAndDecoded) {
  const auto target = parse_target("/logs/a_b.mcap?from=12&token=a%2Bb+c&empty=&alone&from=13");
  ASSERT_TRUE(target);
  EXPECT_EQ(target->path, "/logs/a_b.mcap");
  EXPECT_EQ(target->parameter("from"), "12");
  EXPECT_EQ(target->parameter("token"), "a+b c");
  EXPECT_EQ(target->parameter("empty"), "");
  EXPECT_EQ(target->parameter("missing"), "");
  EXPECT_EQ(parse_target("/a%20b")->path, "/a b");
}

TEST(Target, RefusesPathsThatLeadElsewhere) {
  for (const char* target : {"",          "logs",   "*",      "http://x/",      "/logs/../../etc/passwd",
                             "/..",       "/.",     "/a/./b", "/logs/%2e%2e/x", "/logs/..%2fx",
                             "/logs%2fx", "/a%5cb", "/a\\b",  "/%252e%252e/",   "/a%00b",
                             "/a%0ab",    "/%",     "/%2",    "/%zz",           "/a/.."})
    EXPECT_FALSE(parse_target(target)) << target;
}

TEST(Response, HasLengthAndSecurityHeaders) {
  const std::string head = response_head(error_response(404, "no"), true);
  EXPECT_TRUE(head.starts_with("HTTP/1.1 404 Not Found\r\n"));
  for (const char* line :
       {"Content-Length: 3\r\n", "X-Content-Type-Options: nosniff\r\n", "Referrer-Policy: no-referrer\r\n",
        "Cache-Control: no-store\r\n", "Connection: keep-alive\r\n", "default-src 'self'"})
    EXPECT_NE(head.find(line), std::string::npos) << line;
  EXPECT_EQ(head.find("unsafe"), std::string::npos);
  EXPECT_NE(head.find("frame-ancestors 'none'\r\n"), std::string::npos);
  EXPECT_NE(response_head(error_response(404, "no"), true, "https://lab").find("frame-ancestors https://lab\r\n"),
            std::string::npos);
  EXPECT_TRUE(head.ends_with("\r\n\r\n"));
}

TEST(Response, KeepsItsOwnContentSecurityPolicyAlone) {
  HttpResponse page = text_response(200, "text/html", "<p>");
  page.headers.emplace_back("Content-Security-Policy", "default-src 'none'");
  const std::string head = response_head(page, true);
  EXPECT_NE(head.find("Content-Security-Policy: default-src 'none'; frame-ancestors 'none'\r\n"), std::string::npos);
  EXPECT_EQ(head.find("default-src 'self'"), std::string::npos);
}

TEST(Response, HasTheReasonOfEachStatus) {
  const std::pair<int, std::string_view> reasons[] = {{200, "OK"},
                                                      {204, "No Content"},
                                                      {206, "Partial Content"},
                                                      {304, "Not Modified"},
                                                      {307, "Temporary Redirect"},
                                                      {400, "Bad Request"},
                                                      {401, "Unauthorized"},
                                                      {403, "Forbidden"},
                                                      {404, "Not Found"},
                                                      {405, "Method Not Allowed"},
                                                      {409, "Conflict"},
                                                      {416, "Range Not Satisfiable"},
                                                      {500, "Internal Server Error"},
                                                      {503, "Service Unavailable"}};
  for (const auto& [status, reason] : reasons)
    EXPECT_EQ(plain_head(status, {}),
              std::string("HTTP/1.1 ").append(std::to_string(status)).append(" ").append(reason).append("\r\n\r\n"));
}

TEST(Response, KeepsTheHeadersAndTheirOrder) {
  const Headers headers{
      {"X-one", "1"}, {"Etag", "\"e\""}, {"Empty", ""}, {"vary", "a"}, {"Last", std::string(9000, 'x')}};
  std::string expected = "HTTP/1.1 200 OK\r\n";
  for (const auto& [name, value] : headers) expected.append(name).append(": ").append(value).append("\r\n");
  EXPECT_EQ(plain_head(200, headers), expected + "\r\n");
}

TEST(Response, HasNoLengthWhereNoBodyMayFollow) {
  for (const int status : {204, 304})
    EXPECT_EQ(response_head({.status = status}, false).find("Content-Length"), std::string::npos) << status;
  const HttpResponse part{.body = BodyPart{nullptr, 3, std::uint64_t{5} << 32}};
  EXPECT_NE(response_head(part, false).find("Content-Length: 21474836480\r\n"), std::string::npos);
  EXPECT_NE(response_head(part, false).find("Connection: close\r\n"), std::string::npos);
}

std::string header(const HttpResponse& response, std::string_view name) {
  for (const auto& [key, value] : response.headers)
    if (key == name) return value;
  return "";
}

HttpResponse ask(Headers headers) {
  return body_response({.method = "GET", .headers = std::move(headers)}, std::make_shared<MemorySource>("0123456789"),
                       "\"e1\"", "application/octet-stream");
}

TEST(Body, IsSentWholeInPartOrNotAtAll) {
  const HttpResponse whole = ask({});
  EXPECT_EQ(whole.status, 200);
  EXPECT_EQ(whole.body_size(), 10u);
  EXPECT_EQ(header(whole, "Accept-Ranges"), "bytes");
  EXPECT_EQ(header(whole, "ETag"), "\"e1\"");

  const HttpResponse part = ask({{"range", "bytes=2-4"}});
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.body_size(), 3u);
  EXPECT_EQ(header(part, "Content-Range"), "bytes 2-4/10");

  const HttpResponse none = ask({{"range", "bytes=10-"}});
  EXPECT_EQ(none.status, 416);
  EXPECT_EQ(header(none, "Content-Range"), "bytes */10");

  EXPECT_EQ(ask({{"if-none-match", "W/\"x\", \"e1\""}}).status, 304);
  EXPECT_EQ(ask({{"if-none-match", "\"e2\""}}).status, 200);
  // a part only if the client has a part of the same version
  EXPECT_EQ(ask({{"range", "bytes=2-4"}, {"if-range", "\"e1\""}}).status, 206);
  EXPECT_EQ(ask({{"range", "bytes=2-4"}, {"if-range", "\"e2\""}}).status, 200);
}

/// The targets of the requests in `bytes`, fed in portions, and "!" if there was an error.
std::string requests(std::string_view bytes, std::size_t portion) {
  HttpParser parser;
  std::string log;
  while (!bytes.empty()) {
    const std::string_view now = bytes.substr(0, portion);
    bytes.remove_prefix(now.size());
    parser.add(now);
    while (true) {
      const auto request = parser.next();
      if (!request) return log + "!";
      if (!*request) break;
      log += (*request)->method + (*request)->target + " ";
    }
  }
  return log;
}

TEST(HttpParser, GivesTheSameRequestForPiecesOfAnySize) {
  const std::string text = "GET /a HTTP/1.1\r\nHost: x\r\n\r\nHEAD /b?c=d HTTP/1.1\r\nHost: x\r\nX-Empty:\r\n\r\n";
  for (std::size_t portion = 1; portion <= text.size(); ++portion)
    EXPECT_EQ(requests(text, portion), "GET/a HEAD/b?c=d ");
}

TEST(HttpParser, GivesHeadersInLowerCase) {
  HttpParser parser;
  parser.add("GET / HTTP/1.1\r\nHOST: Nao.local\r\nConnection: keep-alive, Upgrade\r\nUpgrade: WebSocket\r\n\r\nrest");
  const auto request = parser.next();
  ASSERT_TRUE(request && *request);
  EXPECT_EQ((*request)->header("host"), "Nao.local");
  EXPECT_TRUE((*request)->has_token("connection", "upgrade"));
  EXPECT_TRUE((*request)->has_token("upgrade", "websocket"));
  EXPECT_FALSE((*request)->has_token("connection", "close"));
  EXPECT_EQ(parser.take_rest(), "rest");
}

TEST(HttpParser, RefusesMalformedAndTooLargeRequests) {
  const std::string header = "GET / HTTP/1.1\r\n";
  for (const std::string& text :
       {std::string("hello\r\n\r\n"), std::string("\x16\x03\x01\x02"), std::string("GET / HTTP/9.9\r\n\r\n"),
        header + "bad header\r\n\r\n", header + "X: " + std::string(20'000, 'x') + "\r\n\r\n", std::string(20'000, 'G'),
        "GET /" + std::string(20'000, 'x'), std::string("POST / HTTP/1.1\r\nContent-Length: 5\r\n\r\nhello"),
        std::string("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n")}) {
    EXPECT_EQ(requests(text, SIZE_MAX), "!") << text.substr(0, 40);
    EXPECT_EQ(requests(text, 7), "!") << text.substr(0, 40);
  }
}

}  // namespace
}  // namespace robot::net
