// A small blocking WebSocket client for the lab and the tests, on Boost.Beast.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "robot/net/websocket/frames.h"
#include "robot/net/websocket/web_socket_url.h"

namespace robot::net {

/// One client connection. Used by one thread, except `cancel`.
class WebSocketClient {
 public:
  struct Message {
    Opcode opcode = Opcode::text;  // text or binary
    std::string payload;
  };

  static constexpr std::size_t kMaxMessageBytes = 64 << 20;

  WebSocketClient();
  ~WebSocketClient();

  /// Connects to `url` and agrees on the Foxglove subprotocol. Call it once. cancel() and the timeout end it also while
  /// the address of a name is searched.
  Result<void> connect(std::string_view url, std::uint64_t timeout_ns);

  /// Returns the next message, or nothing when the server has closed the connection normally or cancel() was called.
  /// closed() may then give the reason. Returns an Error when monotonic_ns() reaches `deadline_ns`. Answers pings.
  Result<std::optional<Message>> receive(std::uint64_t deadline_ns = UINT64_MAX);

  /// Sends a message. `opcode` is text or binary. Waits while the server reads slowly; cancel() ends that.
  Result<void> send(Opcode opcode, std::string_view payload);

  /// Ends a waiting connect() or receive() and all later calls. Any thread.
  void cancel();

  /// Returns the server's close frame, or nothing before it came.
  const std::optional<CloseInfo>& closed() const;

  /// Returns the file descriptor of the connection, for tests that disturb it.
  int socket() const;

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;  // Boost.Beast stays out of this header: it costs seconds of compile time
};

}  // namespace robot::net
