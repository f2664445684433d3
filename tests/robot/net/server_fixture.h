// A server on loopback, and clients that follow the protocol or break it.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "robot/memory/channels.h"
#include "robot/net/foxglove/from_client.h"
#include "robot/net/serve/board_streams.h"
#include "robot/net/serve/server.h"
#include "robot/net/websocket/web_socket_client.h"
#include "tests/robot/net/net_support.h"
#include "tests/support/eventually.h"

namespace tests {

/// Longest wait. Only a failure takes this long.
inline constexpr std::uint64_t kPatience = 60 * robot::kSecond;

/// A TCP connection that sends any bytes.
class RawConnection {
 public:
  /// `receive_buffer` bytes, if given, make it a slow reader.
  explicit RawConnection(std::uint16_t port, int receive_buffer = 0)
      : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (receive_buffer > 0) ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    const timeval patience{.tv_sec = 60, .tv_usec = 0};
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    const sockaddr_in address{.sin_family = AF_INET, .sin_port = htons(port), .sin_addr = {htonl(INADDR_LOOPBACK)}};
    EXPECT_EQ(::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }

  /// Returns false if the server has closed the connection.
  bool send(std::string_view bytes) {
    return ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
  }

  /// Reads until the server closes, or until `enough` has arrived.
  std::string read(std::string_view enough = {}) {
    std::string text;
    char block[65536];
    while (enough.empty() || text.find(enough) == std::string::npos) {
      const ssize_t n = ::recv(socket_.get(), block, sizeof block, 0);
      if (n <= 0) break;
      text.append(block, static_cast<std::size_t>(n));
    }
    return text;
  }
  /// Waits until the server closes; returns false if it does not.
  bool wait_closed() {
    char byte;
    const ssize_t n = ::recv(socket_.get(), &byte, 1, 0);
    return n == 0 || (n < 0 && errno == ECONNRESET);
  }

 private:
  robot::FileDescriptor socket_;
};

/// A client of the live protocol.
class Peer {
 public:
  using Json = nlohmann::json;

  explicit Peer(std::uint16_t port, const std::string& query = "") {
    const auto connected = client.connect("ws://127.0.0.1:" + std::to_string(port) + "/" + query, kPatience);
    EXPECT_TRUE(connected) << connected.error();
  }

  void send(const std::string& text) { EXPECT_TRUE(client.send(robot::net::Opcode::text, text)); }
  void subscribe(std::uint32_t channel, std::uint32_t subscription = 1) {
    send(robot::net::foxglove::to_text(robot::net::foxglove::Subscribe{{{subscription, channel}}}));
  }

  /// The next text message with this op; others are skipped. Null when the connection ended.
  Json next(const std::string& op) {
    while (auto message = receive()) {
      if (message->opcode != robot::net::Opcode::text) continue;
      Json json = Json::parse(message->payload);
      if (json["op"] == op) return json;
    }
    return nullptr;
  }
  /// The payload of the next message on a channel; nothing when the connection ended.
  std::optional<std::string> next_data() {
    while (auto message = receive()) {
      if (message->opcode != robot::net::Opcode::binary) continue;
      const auto data = robot::net::foxglove::parse_message_data(message->payload);
      if (*data) return std::string((*data)->payload);
    }
    return std::nullopt;
  }
  /// Returns the code of the server's close frame, after all other messages; 0 if it sent none.
  int wait_closed() {
    while (receive()) {
    }
    return client.closed() ? client.closed()->code : 0;
  }

  robot::net::WebSocketClient client;

 private:
  std::optional<robot::net::WebSocketClient::Message> receive() {
    auto message = client.receive(robot::monotonic_ns() + kPatience);
    return message ? std::move(*message) : std::nullopt;
  }
};

/// A server with three channels: 1 "/14/2/state" (latest), 2 "/14/2/sensor" (fifo), 3 "/14/2/events" (reliable).
class ServerTest : public testing::Test {
 protected:
  robot::SessionClock clock;
  robot::memory::Channels channels;
  robot::logging::LoggingBoard board;
  robot::net::BoardStreams streams{board};
  robot::net::Parameters parameters;
  robot::net::Services services;
  TestBackend backend;
  robot::net::ServerOptions options{.port = 0};
  std::unique_ptr<robot::net::Server> server;
  std::shared_ptr<robot::memory::RawChannel> state = add("/14/2/state", robot::memory::Delivery::latest);
  std::shared_ptr<robot::memory::RawChannel> sensor = add("/14/2/sensor", robot::memory::Delivery::fifo);
  std::shared_ptr<robot::memory::RawChannel> events = add("/14/2/events", robot::memory::Delivery::reliable);

  std::shared_ptr<robot::memory::RawChannel> add(std::string topic, robot::memory::Delivery delivery) {
    auto channel = std::make_shared<robot::memory::RawChannel>(channel_info(std::move(topic), delivery), clock);
    EXPECT_TRUE(channels.add(channel));
    return channel;
  }
  void write(robot::memory::Channel& channel, std::string_view bytes) {
    EXPECT_TRUE(channel.write_bytes(bytes, clock.now_ns()));
  }

  std::uint16_t start() {
    if (parameters.names().empty()) parameters.declare("quality", std::int64_t{75}, {.min = 1, .max = 100});
    server = std::make_unique<robot::net::Server>(options, channels, robot::net::Derive(), streams, clock, parameters,
                                                  services, backend);
    const auto started = server->start();
    EXPECT_TRUE(started) << started.error();
    return server->port();
  }

  /// Waits until the statistics are as wanted. They are taken once a second.
  template <class Condition>
  void wait_statistics(Condition&& condition) {
    ASSERT_TRUE(eventually([&] { return condition(server->statistics()); }, kLongestWait,
                           [&] {
                             const robot::net::ServerStatistics statistics = server->statistics();
                             return std::to_string(statistics.clients.size()) + " clients";
                           }));
  }
  static std::string get(std::string_view target, std::string_view headers = "") {
    return "GET " + std::string(target) + " HTTP/1.1\r\nHost: localhost\r\n" + std::string(headers) + "\r\n";
  }
};

}  // namespace tests
