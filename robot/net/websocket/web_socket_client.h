// A small blocking WebSocket client for the lab and the tests.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "robot/net/websocket/frames.h"

namespace robot::net {

/// "ws://10.0.14.2:8765/?delivery=lossless", parsed.
struct WebSocketUrl {
  std::string host;  // without brackets
  std::string port = "80";
  std::string target = "/";  // path and query

  std::string authority() const;  // as in the Host header
};

/// Parses a ws:// address. wss is not supported.
Result<WebSocketUrl> parse_web_socket_url(std::string_view url);

/// One client connection over plain sockets. Used by one thread, except `cancel`.
class WebSocketClient {
 public:
  struct Message {
    Opcode opcode = Opcode::text;  // text or binary
    std::string payload;
  };

  static constexpr std::size_t kMaxMessageBytes = 64 << 20;

  WebSocketClient();

  /// Connects to `url` and agrees on the Foxglove subprotocol. Call it once. cancel() ends it.
  Result<void> connect(std::string_view url, std::uint64_t timeout_ns);

  /// Returns the next message, or nothing when the server has closed the connection normally or cancel() was called.
  /// closed() may then give the reason. Returns an Error when monotonic_ns() reaches `deadline_ns`. Answers pings.
  Result<std::optional<Message>> receive(std::uint64_t deadline_ns = UINT64_MAX);

  Result<void> send(Opcode opcode, std::string_view payload);

  /// Ends a waiting connect() or receive() and all later calls. Any thread.
  void cancel();

  /// Returns the server's close frame, or nothing before it came.
  const std::optional<CloseInfo>& closed() const { return closed_; }

  /// Returns the file descriptor of the connection, for tests that disturb it.
  int socket() const { return socket_.get(); }

 private:
  Result<void> open_socket(const WebSocketUrl& url, std::uint64_t deadline_ns);
  Result<bool> wait(short events, std::uint64_t deadline_ns);
  Result<std::size_t> read_some(char* to, std::size_t size, std::uint64_t deadline_ns);
  Result<void> write_all(std::string_view bytes);
  bool on_frame(Opcode opcode, std::string payload);

  FileDescriptor socket_, wake_up_;
  std::string name_;  // the url, for error sentences
  FrameParser parser_{Sender::server, kMaxMessageBytes};
  std::deque<Message> received_;
  std::string pongs_;  // frames to send before the next wait
  std::optional<CloseInfo> closed_;
};

}  // namespace robot::net
