#include "robot/net/serve/server.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "robot/core/encoding.h"
#include "robot/net/foxglove/web_socket_in_provider.h"
#include "tests/robot/net/server_fixture.h"
#include "tests/support/masked_frame.h"
#include "tests/support/used_up_descriptors.h"

namespace robot::net {
namespace {

using tests::kPatience;
using tests::Peer;
using tests::RawConnection;
using tests::ServerTest;

const std::string kUpgrade =
    "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: "
    "dGhlIHNhbXBsZSBub25jZQ==\r\n"
    "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n";

TEST_F(ServerTest, ShowsTheViewerTheApiAndRecordings) {
  const auto port = start();
  RawConnection connection(port);
  connection.send(get("/"));
  EXPECT_NE(connection.read("</html>").find("built without the viewer"), std::string::npos);
  connection.send(get("/api/status") + get("/logs/old.mcap", "Range: bytes=2-5\r\n"));  // two at once
  const std::string answers = connection.read("2345");
  EXPECT_NE(answers.find(R"({"name":"test"})"), std::string::npos);
  EXPECT_NE(answers.find("Content-Range: bytes 2-5/10"), std::string::npos);
  connection.send("HEAD /logs/old.mcap HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  const std::string head = connection.read();
  EXPECT_NE(head.find("Content-Length: 10\r\n"), std::string::npos);
  EXPECT_TRUE(head.ends_with("\r\n\r\n"));
}

TEST_F(ServerTest, SendsWrittenMessagesToSubscribers) {
  const auto port = start();
  write(*state, "before");
  Peer peer(port);
  EXPECT_EQ(peer.next("serverInfo")["sessionId"].is_string(), true);
  const auto advertised = peer.next("advertise");
  ASSERT_EQ(advertised["channels"].size(), 3u);
  EXPECT_EQ(advertised["channels"][0]["topic"], "/14/2/state");
  peer.subscribe(1, 5);
  EXPECT_EQ(peer.next_data(), "before");  // the last value at once
  write(*state, "after");
  EXPECT_EQ(peer.next_data(), "after");
  peer.subscribe(3, 6);
  std::string large(200'000, 'e');
  write(*events, "event");
  EXPECT_EQ(peer.next_data(), "event");
  write(*events, large);
  EXPECT_EQ(peer.next_data(), large);
}

TEST_F(ServerTest, IsSilentOnWirelessNetworksDuringAGame) {
  options.wireless = {"lo"};
  const auto port = start();
  Peer peer(port);
  peer.next("advertise");
  RawConnection waiting(port);
  backend.game = true;
  EXPECT_EQ(peer.wait_closed(), 0);
  EXPECT_TRUE(waiting.wait_closed());
  backend.game = false;
  RawConnection after(port);  // the kernel asks again until it is answered
  after.send(get("/api/status"));
  EXPECT_NE(after.read("test").find("200 OK"), std::string::npos);
}

TEST_F(ServerTest, AdvertisesLaterChannels) {
  const auto port = start();
  Peer peer(port);
  peer.next("advertise");
  add("/15/3/ball", memory::Delivery::latest);
  EXPECT_EQ(peer.next("advertise")["channels"][0]["topic"], "/15/3/ball");
}

TEST_F(ServerTest, AnswersMalformedMessagesAndContinues) {
  const auto port = start();
  Peer peer(port);
  for (const char* text : {"{", "[]", R"({"op":"dance"})", R"({"op":"subscribe","subscriptions":7})", ""}) {
    peer.send(text);
    EXPECT_EQ(peer.next("status")["level"], 2);
  }
  peer.send(R"({"op":"getParameters","parameterNames":[],"id":"1"})");
  EXPECT_EQ(peer.next("parameterValues")["parameters"][0]["name"], "quality");
}

TEST_F(ServerTest, SendsParametersThatTheProgramChangesToSubscribers) {
  const auto port = start();
  Peer peer(port);
  peer.send(R"({"op":"subscribeParameterUpdates","parameterNames":["quality"]})");
  peer.send(R"({"op":"getParameters","parameterNames":[],"id":"1"})");
  peer.next("parameterValues");
  parameters.update("quality", std::int64_t{20});
  EXPECT_EQ(peer.next("parameterValues")["parameters"][0]["value"], 20);
}

TEST_F(ServerTest, ClosesCleanlyOnProtocolViolations) {
  options.max_message_bytes = 1000;
  const auto port = start();
  std::string unmasked, oversized, fragment, not_utf8;
  append_frame(unmasked, Opcode::text, "{}");
  tests::append_masked_frame(oversized, Opcode::binary, std::string(1001, 'x'), 1);
  tests::append_masked_frame(fragment, Opcode::continuation, "x", 1);
  tests::append_masked_frame(not_utf8, Opcode::text, "\xff", 1);
  const std::pair<std::string, int> cases[] = {{unmasked, 1002}, {oversized, 1009}, {fragment, 1002}, {not_utf8, 1007}};
  for (const auto& [bytes, code] : cases) {
    Peer peer(port);
    ASSERT_EQ(::send(peer.client.socket(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
    EXPECT_EQ(peer.next("status")["level"], 2);
    EXPECT_EQ(peer.wait_closed(), code);
  }
}

TEST_F(ServerTest, ReassemblesFragmentedMessages) {
  const auto port = start();
  Peer peer(port);
  std::string bytes;
  tests::append_masked_frame(bytes, Opcode::text, R"({"op":"getPara)", 1, false);
  tests::append_masked_frame(bytes, Opcode::ping, "between", 2);
  tests::append_masked_frame(bytes, Opcode::continuation, R"(meters","parameterNames":[]})", 3);
  for (const char byte : bytes) ASSERT_EQ(::send(peer.client.socket(), &byte, 1, MSG_NOSIGNAL), 1);
  EXPECT_EQ(peer.next("parameterValues")["parameters"].size(), 1u);
}

TEST_F(ServerTest, AnswersPingAndClose) {
  const auto port = start();
  RawConnection connection(port);
  std::string bytes = get("/", kUpgrade);
  tests::append_masked_frame(bytes, Opcode::ping, "are you there", 7);
  tests::append_masked_frame(bytes, Opcode::close, close_payload(kNormalClosure, "bye"), 8);
  connection.send(bytes);  // the first frames come with the handshake
  const std::string all = connection.read();
  std::string pong;
  append_frame(pong, Opcode::pong, "are you there");
  EXPECT_NE(all.find(pong), std::string::npos);
  EXPECT_TRUE(all.ends_with(close_frame(kNormalClosure, "")));
}

TEST_F(ServerTest, RefusesHandshakesWithASentence) {
  options.access.read_token = "r";
  const auto port = start();
  const auto answer = [&](const std::string& request) {
    RawConnection connection(port);
    connection.send(request);
    return connection.read();
  };
  const std::string plain = kUpgrade.substr(0, kUpgrade.find("Sec-WebSocket-Protocol"));
  EXPECT_TRUE(answer(get("/", plain)).starts_with("HTTP/1.1 400"));
  EXPECT_NE(answer(get("/", plain)).find("expected the subprotocol foxglove.sdk.v1"), std::string::npos);
  EXPECT_NE(answer(get("/", kUpgrade + "Origin: http://evil.com\r\n")).find("--allow-origin http://evil.com"),
            std::string::npos);
  EXPECT_NE(answer("GET / HTTP/1.1\r\nHost: evil.com\r\n" + kUpgrade + "\r\n").find("--allow-host evil.com"),
            std::string::npos);
  EXPECT_TRUE(answer("GET / HTTP/1.1\r\n" + kUpgrade + "\r\n").starts_with("HTTP/1.1 400"));
  EXPECT_TRUE(answer("nonsense\r\n\r\n").starts_with("HTTP/1.1 400"));
  EXPECT_TRUE(answer("GET /logs/../../etc/passwd HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
                  .starts_with("HTTP/1.1 400"));
}

TEST_F(ServerTest, LimitsTheNumberOfClients) {
  options.max_clients = 2;
  const auto port = start();
  Peer one(port), two(port);
  WebSocketClient three;
  const auto refused = three.connect("ws://127.0.0.1:" + std::to_string(port), kPatience);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("503"), std::string::npos);
  write(*state, "still here");
  one.subscribe(1);
  EXPECT_EQ(one.next_data(), "still here");
}

TEST_F(ServerTest, SurvivesAThousandSilentConnections) {
  options.max_http_connections = 16;
  const auto port = start();
  Peer peer(port);
  std::vector<std::unique_ptr<RawConnection>> silent;
  for (int i = 0; i < 1000; ++i) {
    silent.push_back(std::make_unique<RawConnection>(port));
    if (silent.size() > 100) {
      EXPECT_TRUE(silent.front()->wait_closed());  // the oldest connections were closed
      silent.erase(silent.begin());
    }
  }
  RawConnection talking(port);
  talking.send(get("/api/status"));
  EXPECT_NE(talking.read(R"({"name":"test"})").find("200 OK"), std::string::npos);
  peer.subscribe(1);
  write(*state, "x");
  EXPECT_EQ(peer.next_data(), "x");
}

TEST_F(ServerTest, WithoutFileDescriptorsAWaitingConnectionMakesRoomOrTheClientGetsASentence) {
  if (!tests::kCanUseUpDescriptors) GTEST_SKIP() << "the sanitizer itself needs file descriptors";
  const auto port = start();
  Peer peer(port);
  RawConnection idle(port);
  idle.send(get("/api/status"));
  idle.read(R"({"name":"test"})");
  FileDescriptor one(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)),
      two(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const auto ask = [&](const FileDescriptor& socket, const std::string& request) {
    const sockaddr_in address{.sin_family = AF_INET, .sin_port = htons(port), .sin_addr = {htonl(INADDR_LOOPBACK)}};
    EXPECT_EQ(::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::send(socket.get(), request.data(), request.size(), MSG_NOSIGNAL), static_cast<ssize_t>(request.size()));
  };
  {
    const tests::UsedUpDescriptors none;
    ask(one, get("/api/sessions/slow/files"));
    EXPECT_TRUE(idle.wait_closed());  // it made room
    ASSERT_TRUE(tests::eventually([&] { return backend.begun == 1; }));
    ask(two, get("/api/status"));  // no other connection waits
    char block[4096];
    const ssize_t n = ::recv(two.get(), block, sizeof block, 0);
    const std::string refused(block, n > 0 ? static_cast<std::size_t>(n) : 0);
    EXPECT_TRUE(refused.starts_with("HTTP/1.1 503")) << refused;
    EXPECT_NE(refused.find("no file descriptor is left"), std::string::npos) << refused;
  }
  ::shutdown(one.get(), SHUT_RDWR);
  write(*state, "x");
  peer.subscribe(1);
  EXPECT_EQ(peer.next_data(), "x");
  RawConnection later(port);
  later.send(get("/api/status"));
  EXPECT_NE(later.read(R"({"name":"test"})").find("200 OK"), std::string::npos);
}

TEST_F(ServerTest, ClosesAConnectionWhoseHeadersArriveTooSlowly) {
  options.request_timeout_ns = kSecond / 5;
  const auto port = start();
  RawConnection slow(port);
  slow.send("GET / HTTP/1.1\r\n");
  // sends until the server closes: each byte is in time, the whole header is not
  std::thread trickle([&] {
    while (slow.send("X")) ::usleep(20'000);
  });
  EXPECT_TRUE(slow.wait_closed());
  trickle.join();
}

TEST_F(ServerTest, AStalledClientDelaysNoOtherAndHoldsFewMessages) {
  const auto port = start();
  RawConnection stalled(port, 4096);
  std::string bytes = get("/", kUpgrade);
  tests::append_masked_frame(
      bytes, Opcode::text, R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1},{"id":2,"channelId":2}]})", 1);
  stalled.send(bytes);
  Peer peer(port);
  peer.subscribe(1);
  const std::string image(300'000, 'i');
  for (int i = 0; i < 100; ++i) {
    write(*state, image + std::to_string(i));
    write(*sensor, std::to_string(i));
    EXPECT_EQ(peer.next_data(), image + std::to_string(i));
  }
  // 30 MB were written; the stalled client holds one image and a few sensor values
  wait_statistics([](const ServerStatistics& statistics) {
    if (statistics.clients.empty() || statistics.clients[0].channels.size() != 2) return false;
    const auto& image_counts = statistics.clients[0].channels[0];
    const auto& sensor_counts = statistics.clients[0].channels[1];
    return image_counts.dropped > 50 && image_counts.queued_messages <= 1 && sensor_counts.queued_messages <= 32;
  });
}

TEST_F(ServerTest, ALosslessClientGetsEveryMessage) {
  const auto port = start();
  Peer peer(port, "?delivery=lossless");
  write(*sensor, "first");
  peer.subscribe(2);
  EXPECT_EQ(peer.next_data(), "first");  // from here on nothing is missing
  std::thread writer([&] {
    for (int i = 0; i < 5000; ++i) write(*sensor, std::to_string(i));
  });
  for (int i = 0; i < 5000; ++i) ASSERT_EQ(peer.next_data(), std::to_string(i));
  writer.join();
}

TEST_F(ServerTest, ALosslessClientThatStallsIsDisconnected) {
  options.hub.queues.lossless_bytes = 1 << 20;
  options.close_timeout_ns = kSecond / 5;
  const auto port = start();
  RawConnection stalled(port, 4096);
  std::string bytes = get("/?delivery=lossless", kUpgrade);
  tests::append_masked_frame(bytes, Opcode::text, R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})", 1);
  stalled.send(bytes);
  wait_statistics(
      [](const ServerStatistics& statistics) { return !statistics.clients.empty() && statistics.clients[0].lossless; });
  std::atomic<bool> done = false;
  std::thread writer([&] {
    const std::string image(300'000, 'i');
    while (!done) {
      write(*state, image);
      ::usleep(1000);
    }
  });
  wait_statistics([](const ServerStatistics& statistics) { return statistics.clients.empty(); });
  done = true;
  writer.join();
}

TEST_F(ServerTest, AClientThatDisconnectsDuringADownloadLeavesNoConnection) {
  backend.body = std::string(50 << 20, 'x');
  options.max_http_connections = 4;
  const auto port = start();
  for (int i = 0; i < 20; ++i) {
    RawConnection connection(port);
    connection.send(get("/logs/old.mcap"));
    EXPECT_NE(connection.read("\r\n\r\n").find("Content-Length: 52428800"), std::string::npos);
  }
  RawConnection whole(port);
  whole.send(get("/logs/old.mcap", "Connection: close\r\n"));
  EXPECT_GT(whole.read().size(), backend.body.size());
}

TEST_F(ServerTest, StatusSessionsAndDownloadsDoNotWaitForAChecksum) {
  const auto port = start();
  RawConnection hashing(port), other(port);
  hashing.send(get("/api/sessions/slow/files"));
  ASSERT_TRUE(tests::eventually([&] { return backend.begun == 1; }));
  other.send(get("/api/status"));
  EXPECT_NE(other.read(R"({"name":"test"})").find("200 OK"), std::string::npos);
  other.send(get("/api/sessions"));
  EXPECT_NE(other.read(R"({"sessions":)").find("200 OK"), std::string::npos);
  other.send(get("/logs/old.mcap"));
  EXPECT_NE(other.read(backend.body).find("200 OK"), std::string::npos);
  EXPECT_EQ(backend.ended, 0);
}

TEST_F(ServerTest, AChecksumEndsWhenItsClientLeaves) {
  const auto port = start();
  auto leaving = std::make_unique<RawConnection>(port);
  RawConnection behind(port);
  leaving->send(get("/api/sessions/slow/files"));
  ASSERT_TRUE(tests::eventually([&] { return backend.begun == 1; }));
  behind.send(get("/api/sessions/old/files"));
  leaving.reset();
  EXPECT_NE(behind.read(R"("files":[])").find("200 OK"), std::string::npos);
  EXPECT_EQ(backend.ended, 1);

  // the server stops in spite of another one
  RawConnection staying(port);
  staying.send(get("/api/sessions/slow/files"));
  ASSERT_TRUE(tests::eventually([&] { return backend.begun == 2; }));
  server->stop();
  EXPECT_EQ(backend.ended, 2);
}

TEST_F(ServerTest, ListsItsClients) {
  const auto port = start();
  Peer peer(port, "?delivery=lossless");
  peer.subscribe(1);
  write(*state, "x");
  EXPECT_EQ(peer.next_data(), "x");
  std::atomic<bool> done = false;
  std::thread reader([&] {  // answers pings meanwhile
    while (!done) peer.client.receive(monotonic_ns() + kSecond / 10).operator bool();
  });
  wait_statistics([](const ServerStatistics& statistics) {
    return statistics.clients.size() == 1 && statistics.clients[0].round_trip_ns &&
           !statistics.clients[0].channels.empty();
  });
  done = true;
  reader.join();
  const ClientStatistics client = server->statistics().clients.at(0);
  EXPECT_EQ(client.id, 1u);
  EXPECT_TRUE(client.address.starts_with("127.0.0.1:"));
  EXPECT_EQ(client.user_agent, "foresight");
  EXPECT_EQ(client.subprotocol, "foxglove.sdk.v1");
  EXPECT_TRUE(client.lossless);
  EXPECT_EQ(client.channels.at(0).topic, "/14/2/state");
  EXPECT_EQ(client.channels.at(0).sent, 1u);
}

TEST_F(ServerTest, StopsWhileClientsWatchStallOrDownload) {
  backend.body = std::string(50 << 20, 'x');
  const auto port = start();
  Peer peer(port);
  peer.subscribe(1);
  RawConnection stalled(port, 4096), downloading(port, 4096), silent(port);
  std::string bytes = get("/", kUpgrade);
  tests::append_masked_frame(bytes, Opcode::text, R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})", 1);
  stalled.send(bytes);
  downloading.send(get("/logs/old.mcap"));
  downloading.read("\r\n\r\n");
  std::atomic<bool> done = false;
  std::thread writer([&] {
    const std::string image(300'000, 'i');
    while (!done) write(*state, image);
  });
  EXPECT_TRUE(peer.next_data());
  server->stop();
  server->stop();
  done = true;
  writer.join();
  EXPECT_TRUE(silent.wait_closed());
  EXPECT_TRUE(board.statuses().empty());
  write(*state, "nobody is there");  // the objects that the server watched still live
  add("/16/1/late", memory::Delivery::latest);
  parameters.update("quality", std::int64_t{3});
}

TEST_F(ServerTest, SaysGoodbyeToAClientThatReadsWhileItStops) {
  options.stop_timeout_ns = kPatience;
  const auto port = start();
  Peer peer(port);
  peer.subscribe(1);
  std::atomic<bool> done = false;
  std::thread writer([&] {
    const std::string image(300'000, 'i');
    while (!done) write(*state, image);
  });
  EXPECT_TRUE(peer.next_data());
  std::thread stopping([&] {
    server->stop();
    server->stop();
  });
  EXPECT_EQ(peer.wait_closed(), kGoingAway);
  stopping.join();
  done = true;
  writer.join();
}

TEST_F(ServerTest, ATakenPortGivesASentence) {
  const auto port = start();
  ServerOptions same = options;
  same.port = port;
  Server second(same, channels, Derive(), streams, clock, parameters, services, backend);
  const auto started = second.start();
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error(), "cannot listen on 127.0.0.1:" + std::to_string(port) + ": Address already in use");
  same.bind = {"robot"};
  Server third(same, channels, Derive(), streams, clock, parameters, services, backend);
  EXPECT_EQ(third.start().error(), "cannot listen on robot:" + std::to_string(port) + ": expected an IP address");
}

TEST_F(ServerTest, ANewTimeLineIsANewSession) {
  const auto port = start();
  Peer peer(port);
  const auto first = peer.next("serverInfo")["sessionId"];
  server->restart_time();
  EXPECT_NE(peer.next("serverInfo")["sessionId"], first);
}

// our own client

TEST_F(ServerTest, OurInProviderReadsAChannel) {
  const auto port = start();
  const std::string url = "ws://127.0.0.1:" + std::to_string(port) + "/?delivery=lossless";
  write(*events, "one");
  WebSocketInProvider provider(url, "/14/2/events", kPatience);
  const auto info = provider.open();
  ASSERT_TRUE(info) << info.error();
  EXPECT_EQ(*info, events->info());
  const auto one = provider.read();
  ASSERT_TRUE(one && *one);
  EXPECT_EQ((*one)->bytes, "one");
  EXPECT_EQ((*one)->sequence, 1u);
  write(*events, "two");
  const auto two = provider.read();
  ASSERT_TRUE(two && *two);
  EXPECT_EQ((*two)->sequence, 2u);
  EXPECT_EQ((*two)->capture_ns, events->newest()->capture_ns());
  std::thread cancelling([&] { provider.cancel(); });
  const auto none = provider.read();
  ASSERT_TRUE(none);
  EXPECT_FALSE(*none);
  cancelling.join();
}

TEST_F(ServerTest, OurInProviderNamesTheMissingChannelAndTheEnd) {
  const auto port = start();
  const std::string url = "ws://127.0.0.1:" + std::to_string(port) + "/?token=secret";
  WebSocketInProvider missing(url, "/14/2/nothing", kPatience);
  EXPECT_EQ(missing.open().error(),
            "/14/2/nothing: there is no such channel; the server offers /14/2/state, /14/2/sensor, /14/2/events");
  WebSocketInProvider stopped(url, "/14/2/state", kPatience);
  ASSERT_TRUE(stopped.open());
  server->stop();
  const auto end = stopped.read();
  ASSERT_TRUE(end) << end.error();
  EXPECT_FALSE(*end);
  WebSocketInProvider nobody(url, "/14/2/state", kPatience);
  EXPECT_EQ(nobody.open().error(), "ws://127.0.0.1:" + std::to_string(port) + "/: Connection refused");
}

TEST(WebSocketUrl, IsParsed) {
  const auto url = parse_web_socket_url("ws://10.0.14.2:8765/x?token=1");
  ASSERT_TRUE(url);
  EXPECT_EQ(url->host + " " + url->port + " " + url->target, "10.0.14.2 8765 /x?token=1");
  EXPECT_EQ(parse_web_socket_url("ws://[::1]:8765?a")->authority(), "[::1]:8765");
  EXPECT_EQ(parse_web_socket_url("ws://[::1]:8765?a")->target, "/?a");
  EXPECT_EQ(parse_web_socket_url("ws://nao")->authority(), "nao:80");
  for (const char* wrong :
       {"", "ws://", "http://x", "wss://x", "ws://x:", "ws://x:1a", "ws://[::1", "ws://x/ y", "ws://x:123456"})
    EXPECT_FALSE(parse_web_socket_url(wrong)) << wrong;
}

}  // namespace
}  // namespace robot::net
