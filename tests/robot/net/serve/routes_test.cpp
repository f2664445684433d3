#include "robot/net/serve/routes.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "robot/net/http/asset_files.h"
#include "robot/net/serve/session_page.h"
#include "robot/net/websocket/handshake.h"
#include "tests/robot/net/net_support.h"

namespace robot::net {
namespace {

std::string gzip(std::string_view text) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string packed(text.size() + 100, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

class RoutesTest : public testing::Test {
 protected:
  tests::TestBackend backend;
  AccessOptions access{.control_token = "c", .read_token = "r", .read_cookie = "k"};
  const std::string page = gzip("<h1>viewer</h1>"), script = gzip("run()");
  const Asset assets[2] = {{"/index.html", "text/html; charset=utf-8", page, "i1"},
                           {"assets/app-1a2b.js", "text/javascript", script, "s1"}};
  Routes routes{access, assets, backend};

  HttpResponse get(std::string target, Headers headers = {}, std::string_view address = "127.0.0.1",
                   std::string method = "GET") {
    headers.emplace_back("host", "127.0.0.1:8765");
    return routes.answer({.method = std::move(method), .target = std::move(target), .headers = std::move(headers)},
                         address, {});
  }
  static std::string header(const HttpResponse& response, std::string_view name) {
    for (const auto& [key, value] : response.headers)
      if (key == name) return value;
    return "";
  }
  static std::string text(const HttpResponse& response) {
    if (const auto* view = std::get_if<std::string_view>(&response.body)) return std::string(*view);
    return std::get<std::string>(response.body);
  }
};

TEST(Routes, EachKindOfWaitingIsWorkOfItsOwn) {
  const auto work = [](const char* target) { return Routes::work_of({.method = "GET", .target = target}); };
  EXPECT_EQ(work("/"), Work::none);
  EXPECT_EQ(work("/../x"), Work::none);
  EXPECT_EQ(work("/api/status?token=t"), Work::status);
  EXPECT_EQ(work("/api/sessions"), Work::status);
  EXPECT_EQ(work("/logs/"), Work::status);
  EXPECT_EQ(work("/api/played?topic=/x"), Work::files);
  EXPECT_EQ(work("/api/recent"), Work::files);
  EXPECT_EQ(work("/logs/a.mcap"), Work::files);
  EXPECT_EQ(work("/logs/a.mcap?foxglove"), Work::checksums);  // it reads the whole recording
  EXPECT_EQ(work("/api/sessions/a/files"), Work::checksums);
  EXPECT_EQ(work("/api/whole/events"), Work::checksums);
  EXPECT_EQ(work("/api/sessions/a/b/files"), Work::files);
}

TEST_F(RoutesTest, ALinkOfAReportToARecordingBesideItOpensTheViewer) {
  const HttpResponse game = get("/reports/seed-7.mcap?token=r");
  EXPECT_EQ(game.status, 302);
  EXPECT_EQ(header(game, "Location"), "/#/?session=seed-7.mcap");
  EXPECT_EQ(get("/reports/report.html?token=r").status, 404) << "this program plays nothing";
  for (const char* path : {"/reports/", "/reports/a.txt", "/reports/a/b.html", "/reports/.a.html"})
    EXPECT_EQ(get(std::string(path) + "?token=r").status, 404) << path;
  EXPECT_EQ(get("/reports/..%2fa.html?token=r").status, 400);
  EXPECT_EQ(get("/reports/report.html", {}, "10.0.0.9").status, 401);
  EXPECT_EQ(Routes::work_of({.method = "GET", .target = "/reports/report.html"}), Work::files);
}

TEST_F(RoutesTest, TheViewerIsSentGzippedOrInflatedForClientsWithoutGzip) {
  const HttpResponse packed = get("/", {{"accept-encoding", "br, gzip"}});
  EXPECT_EQ(packed.status, 200);
  EXPECT_EQ(header(packed, "Content-Encoding"), "gzip");
  EXPECT_EQ(header(packed, "Cache-Control"), "no-cache");
  EXPECT_EQ(text(packed), page);
  const HttpResponse plain = get("/index.html");
  EXPECT_EQ(header(plain, "Content-Encoding"), "");
  EXPECT_EQ(text(plain), "<h1>viewer</h1>");
  EXPECT_NE(header(plain, "ETag"), header(packed, "ETag"));
  EXPECT_EQ(get("/", {{"if-none-match", header(plain, "ETag")}}).status, 304);
  EXPECT_EQ(header(get("/assets/app-1a2b.js"), "Cache-Control"), "public, max-age=31536000, immutable");
}

TEST_F(RoutesTest, ABuildWithoutAViewerHasAPage) {
  const auto response = asset_response({kViewerAssets, kViewerAssetCount}, {.method = "GET"}, "/");
  ASSERT_TRUE(response);
  EXPECT_NE(text(*response).find("built without the viewer"), std::string::npos);
}

TEST_F(RoutesTest, DamagedGzipIsAnError) {
  for (std::size_t n = 0; n < page.size(); ++n) EXPECT_FALSE(inflate_gzip(std::string_view(page).substr(0, n)));
}

TEST_F(RoutesTest, TheApiSpeaksJson) {
  EXPECT_EQ(text(get("/api/status")), R"({"name":"test"})");
  EXPECT_EQ(header(get("/api/sessions"), "Content-Type"), "application/json");
  EXPECT_EQ(text(get("/logs/", {{"accept", "application/json"}})), backend.sessions_json());
  EXPECT_EQ(get("/api/nothing").status, 404);
}

TEST_F(RoutesTest, TheListOfRecordingsIsAPageWithoutForeignContent) {
  const HttpResponse response = get("/logs/?token=r", {}, "10.0.0.9");
  const std::string html = text(response);
  EXPECT_NE(html.find("<a href=\"/logs/old.mcap\">old</a>"), std::string::npos);
  EXPECT_NE(html.find("&lt;b&gt;final&lt;/b&gt;"), std::string::npos);
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_NE(html.find("2023-11-14 22:13:20 UTC"), std::string::npos);
  const std::string evil = session_page(R"x({"sessions":[{"session":"x","url":"javascript:alert(1)"},7,null]})x");
  EXPECT_EQ(evil.find("javascript"), std::string::npos);
  EXPECT_NE(session_page("nonsense").find("</html>"), std::string::npos);
  const std::string untold = session_page(
      R"x({"sessions":[{"session":"x","streams":[{"topic":"","file":"a.mcap","url":"/logs/x/a.mcap"}]}]})x");
  EXPECT_NE(untold.find("<a href=\"/logs/x/a.mcap\">a.mcap</a>"), std::string::npos);
}

TEST_F(RoutesTest, RecordingsAreSentWithRanges) {
  const HttpResponse whole = get("/logs/old.mcap");
  EXPECT_EQ(whole.status, 200);
  EXPECT_EQ(header(whole, "ETag"), "\"e1\"");
  EXPECT_EQ(header(whole, "Content-Disposition"), "attachment; filename=\"old.mcap\"");
  EXPECT_EQ(get("/logs/old/14.2.ball.mcap", {{"range", "bytes=0-1"}}).status, 206);
  EXPECT_EQ(get("/logs/other.mcap").status, 404);
  EXPECT_EQ(get("/logs/old.mcap?from=yesterday").status, 404);
}

TEST_F(RoutesTest, ASessionsFilesAreServedUnchanged) {
  EXPECT_EQ(text(get("/api/sessions/old/files")), R"({"session":"old","files":[]})");
  EXPECT_EQ(get("/api/sessions/../files").status, 400);
  EXPECT_EQ(get("/api/sessions//files").status, 404);
  const HttpResponse file = get("/logs/old/files/session.json", {{"range", "bytes=0-6"}});
  EXPECT_EQ(file.status, 206);
  EXPECT_EQ(header(file, "ETag"), "\"f1\"");
  EXPECT_EQ(header(file, "Content-Disposition"), "attachment; filename=\"session.json\"");
  for (const char* path : {"/logs/old/files/", "/logs//files/a", "/logs/old/files/a/b", "/logs/old/files/.hidden"})
    EXPECT_EQ(get(path).status, 404) << path;
}

TEST_F(RoutesTest, PartsOfAPlayedRecordingAreServedByTopicAndTime) {
  const HttpResponse part = get("/api/played?topic=%2F14%2F2%2Fball&from=5&to=9");
  EXPECT_EQ(part.status, 200);
  EXPECT_EQ(text(part), "5..9");
  EXPECT_EQ(header(part, "Foresight-Until"), "7");
  EXPECT_EQ(text(get("/api/played?topic=/14/2/ball")), "0..18446744073709551615");
  EXPECT_EQ(get("/api/played?topic=/14/2/x").status, 404);
  EXPECT_EQ(get("/api/played").status, 400);
  EXPECT_EQ(get("/api/whole/events").status, 404) << "no recording is played here";
  EXPECT_EQ(get("/api/whole/events", {}, "10.0.0.9").status, 401) << "needs the read token";
  EXPECT_EQ(text(get("/api/played?topic=/14/2/ball&from=noon")),
            "played: 'from' must be a time in ns since the epoch\n");
  EXPECT_EQ(get("/api/played?topic=/14/2/ball", {}, "10.0.0.9").status, 401) << "needs the read token";
  backend.game = true;
  EXPECT_EQ(get("/api/played?topic=/14/2/ball&token=r", {}, "10.0.0.9").status, 503);
}

TEST_F(RoutesTest, TheLastMinutesAreServedToThoseWhoMayWatch) {
  EXPECT_EQ(text(get("/api/recent")), "all");
  EXPECT_EQ(text(get("/api/recent?topics=%2F14%2F2%2Fball")), "/14/2/ball+0");
  EXPECT_EQ(text(get("/api/recent?topics=/14/2/ball%0A/14/2/pose%0A/a,b")), "/14/2/ball+2");
  EXPECT_EQ(get("/api/recent", {}, "10.0.0.9").status, 401) << "needs the read token";
  EXPECT_EQ(get("/api/recent?token=r", {}, "10.0.0.9").status, 200);
  backend.game = true;
  EXPECT_EQ(get("/api/recent?token=r", {}, "10.0.0.9").status, 503);
  EXPECT_EQ(get("/api/recent").status, 200) << "this machine is no network";
}

TEST_F(RoutesTest, AClientWithControlMayDeleteASession) {
  const auto remove = [&](std::string target, Headers headers = {}, std::string_view address = "10.0.0.9") {
    return get(std::move(target), std::move(headers), address, "DELETE").status;
  };
  EXPECT_EQ(remove("/logs/old"), 401);
  EXPECT_EQ(remove("/logs/old?token=r"), 401);
  EXPECT_EQ(remove("/logs/old?token=c", {{"origin", "https://elsewhere.example"}}), 403);
  EXPECT_EQ(remove("/logs/old", {{"origin", "https://elsewhere.example"}}, "127.0.0.1"), 403);
  EXPECT_EQ(remove("/logs/old.mcap/x?token=c"), 404);
  EXPECT_EQ(remove("/api/status?token=c"), 404);
  EXPECT_EQ(remove("/?token=c"), 404);
  EXPECT_EQ(backend.deleted, "");
  EXPECT_EQ(remove("/logs/old?token=c"), 204);
  EXPECT_EQ(remove("/logs/live", {}, "127.0.0.1"), 204);
  EXPECT_EQ(backend.deleted, "oldlive");
  EXPECT_EQ(header(get("/", {}, "127.0.0.1", "POST"), "Allow"), "GET, HEAD, DELETE, OPTIONS");
}

TEST_F(RoutesTest, DuringAGameRecordingsAreServedToThisMachineOnly) {
  backend.game = true;
  for (const char* path : {"/logs/old.mcap?token=c", "/logs/old/files/a?token=c", "/api/sessions/old/files?token=c"}) {
    EXPECT_EQ(get(path, {}, "10.0.0.9").status, 503) << path;
    EXPECT_EQ(get(path).status, 200) << path;
  }
  EXPECT_EQ(get("/logs/old?token=c", {}, "10.0.0.9", "DELETE").status, 503);
  EXPECT_EQ(text(get("/logs/old.mcap?token=c", {}, "10.0.0.9")),
            "a game is in progress: recordings can be had when it has finished, or with --practice in a test game\n");
  EXPECT_EQ(get("/api/status?token=r", {}, "10.0.0.9").status, 200);
  EXPECT_EQ(get("/api/sessions?token=r", {}, "10.0.0.9").status, 200);
}

TEST_F(RoutesTest, ALiveRecordingIsSentWholeUntilAMomentOrRedirectedThereForRanges) {
  const HttpResponse whole = get("/logs/live.mcap?from=5");
  EXPECT_EQ(whole.status, 200);
  EXPECT_GT(whole.body_size(), 0u);
  EXPECT_EQ(header(whole, "Content-Location"), "/logs/live.mcap?from=5&until=77");
  EXPECT_EQ(get("/logs/live.mcap", {}, "127.0.0.1", "HEAD").status, 307);
  const HttpResponse response = get("/logs/live.mcap?from=5", {{"range", "bytes=0-3"}});
  EXPECT_EQ(response.status, 307);
  EXPECT_EQ(header(response, "Location"), "/logs/live.mcap?from=5&until=77");
  EXPECT_EQ(get("/logs/live.mcap?until=77").status, 200);
}

TEST_F(RoutesTest, PathsThatLeadElsewhereAreRefused) {
  for (const char* path :
       {"/logs/../secret.mcap", "/logs/%2e%2e/secret.mcap", "/logs/..%2fsecret.mcap", "/logs//etc/passwd.mcap",
        "/logs/.hidden.mcap", "/logs/a/b/c.mcap", "/logs/.mcap", "/logs/a b.mcap", "/logs/old", "/../etc/passwd",
        "/assets/../index.html", "//", "/logs/old/.mcap", "/logs/old/..mcap"}) {
    const int status = get(path).status;
    EXPECT_TRUE(status == 400 || status == 404) << path << " " << status;
  }
}

TEST_F(RoutesTest, DataNeedTheReadTokenAndTheViewerDoesNot) {
  for (const char* path : {"/api/status", "/api/sessions", "/logs/", "/logs", "/logs/old.mcap"}) {
    EXPECT_EQ(get(path, {}, "10.0.0.9").status, 401) << path;
    EXPECT_EQ(get(path + std::string("?token=x"), {}, "10.0.0.9").status, 401) << path;
    EXPECT_EQ(get(path + std::string("?token=r"), {}, "10.0.0.9").status, 200) << path;
    EXPECT_EQ(get(path + std::string("?token=c"), {}, "10.0.0.9").status, 200) << path;
  }
  EXPECT_EQ(get("/", {}, "10.0.0.9").status, 200);
}

TEST_F(RoutesTest, ABrowserWithATokenContinuesToReadWithItsCookie) {
  const std::string cookie = header(get("/?token=c", {}, "10.0.0.9"), "Set-Cookie");
  EXPECT_EQ(cookie, "foresight_reader=k; Path=/; HttpOnly; SameSite=Strict");
  EXPECT_EQ(header(get("/?token=x", {}, "10.0.0.9"), "Set-Cookie"), "");
  EXPECT_EQ(header(get("/", {}, "10.0.0.9"), "Set-Cookie"), "");
  EXPECT_EQ(get("/logs/", {{"cookie", "a=b; foresight_reader=k"}}, "10.0.0.9").status, 200);
  for (const char* wrong :
       {"foresight_reader=", "foresight_reader=x", "foresight_reader", "xforesight_reader=k", ";;", "="})
    EXPECT_EQ(get("/logs/", {{"cookie", wrong}}, "10.0.0.9").status, 401) << wrong;
}

TEST_F(RoutesTest, OnlyOurNamesAreServed) {
  const auto with_host = [&](Headers headers) {
    return routes.answer({.method = "GET", .target = "/", .headers = std::move(headers)}, "127.0.0.1", {}).status;
  };
  EXPECT_EQ(with_host({{"host", "localhost"}}), 200);
  EXPECT_EQ(with_host({{"host", "evil.com"}}), 403);
  EXPECT_EQ(with_host({}), 400);
  EXPECT_EQ(with_host({{"host", "localhost"}, {"host", "evil.com"}}), 400);
}

TEST_F(RoutesTest, PagesOfAcceptedOriginsMayRead) {
  const HttpResponse mine = get("/logs/old.mcap", {{"origin", "http://localhost:8080"}});
  EXPECT_EQ(header(mine, "Access-Control-Allow-Origin"), "http://localhost:8080");
  EXPECT_NE(header(mine, "Access-Control-Expose-Headers").find("Accept-Ranges, Content-Length"), std::string::npos);
  EXPECT_EQ(header(get("/logs/old.mcap", {{"origin", "http://evil.com"}}), "Access-Control-Allow-Origin"), "");
  const HttpResponse preflight =
      get("/logs/old.mcap", {{"origin", "https://app.foxglove.dev"}}, "127.0.0.1", "OPTIONS");
  EXPECT_EQ(preflight.status, 204);
  EXPECT_NE(header(preflight, "Access-Control-Allow-Headers").find("Range"), std::string::npos);
  EXPECT_EQ(header(preflight, "Access-Control-Allow-Methods").find("DELETE"), std::string::npos);
  EXPECT_EQ(get("/", {}, "127.0.0.1", "POST").status, 405);
}

// the handshake of RFC 6455, section 1.3
TEST(Handshake, MatchesTheExampleOfRfc6455) {
  HttpRequest request{.method = "GET",
                      .target = "/chat",
                      .headers = {{"host", "x"},
                                  {"upgrade", "websocket"},
                                  {"connection", "Upgrade"},
                                  {"sec-websocket-key", "dGhlIHNhbXBsZSBub25jZQ=="},
                                  {"sec-websocket-protocol", "chat, foxglove.websocket.v1, foxglove.sdk.v1"},
                                  {"sec-websocket-version", "13"}}};
  EXPECT_TRUE(wants_web_socket(request));
  const auto upgrade = accept_web_socket(request);
  ASSERT_TRUE(upgrade);
  EXPECT_EQ(upgrade->subprotocol, "foxglove.sdk.v1");
  EXPECT_EQ(upgrade->response,
            "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\nSec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n");

  for (std::size_t i = 2; i < request.headers.size(); ++i) {
    HttpRequest broken = request;
    broken.headers[i].second = "x";
    EXPECT_FALSE(accept_web_socket(broken)) << broken.headers[i].first;
  }
  HttpRequest two_lines = request;
  two_lines.headers[2].second = "keep-alive";
  two_lines.headers.emplace_back("connection", "upgrade");
  EXPECT_TRUE(accept_web_socket(two_lines));

  request.headers[4].second = "chat";
  EXPECT_EQ(accept_web_socket(request).error(),
            "WebSocket: expected the subprotocol foxglove.sdk.v1 or foxglove.websocket.v1 to be offered, it is not");

  // another case is another name: the answer never has a spelling that was not offered
  request.headers[4].second = "Foxglove.SDK.v1";
  EXPECT_FALSE(accept_web_socket(request));
  request.headers[4].second = "FOXGLOVE.SDK.V1, foxglove.websocket.v1";
  EXPECT_EQ(accept_web_socket(request)->subprotocol, "foxglove.websocket.v1");
}

}  // namespace
}  // namespace robot::net
