// A server on loopback for one client. It answers as a test wants, well or badly.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "robot/core/files.h"
#include "robot/net/http/http_parser.h"
#include "robot/net/websocket/frames.h"
#include "robot/net/websocket/handshake.h"

namespace tests {

/// The server's end of the connection. Used by the script.
class ScriptedPeer {
 public:
  explicit ScriptedPeer(int socket) : socket_(socket) {
    const timeval patience{.tv_sec = 60, .tv_usec = 0};
    ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }

  /// Returns false when the client has closed the connection.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t n = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (n <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  }

  /// Reads the request. Returns the response of a correct server.
  std::string read_request() {
    robot::net::HttpParser parser;
    while (true) {
      auto request = parser.next();
      if (!request) return "";
      if (*request) {
        const auto upgrade = robot::net::accept_web_socket(**request);
        return upgrade ? upgrade->response : "";
      }
      const std::string bytes = read();
      if (bytes.empty()) return "";
      parser.add(bytes);
    }
  }

  /// Returns the next frame of the client as "opcode:payload", or "end" when it has closed the connection.
  std::string next_frame() {
    while (frames_.empty()) {
      const std::string bytes = read();
      if (bytes.empty()) return "end";
      parser_.feed(bytes, [this](robot::net::Opcode opcode, const std::string& payload) {
        frames_.push_back(std::to_string(static_cast<int>(opcode)) + ":" + payload);
        return true;
      });
    }
    std::string frame = std::move(frames_.front());
    frames_.erase(frames_.begin());
    return frame;
  }

  /// Waits until the client has closed the connection.
  void wait_closed() {
    while (!read().empty()) {
    }
  }

 private:
  std::string read() {
    std::string bytes(65536, '\0');
    const ssize_t n = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
    bytes.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    return bytes;
  }

  robot::FileDescriptor socket_;
  robot::net::FrameParser parser_{robot::net::Sender::client, 64 << 20};
  std::vector<std::string> frames_;
};

/// A server whose thread runs `script` with its first client. Destroy the client first: scripts may wait for its end.
class ScriptedServer {
 public:
  explicit ScriptedServer(std::function<void(ScriptedPeer&)> script)
      : listening_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{.sin_family = AF_INET, .sin_addr = {htonl(INADDR_LOOPBACK)}};
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listening_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listening_.get(), 1), 0);
    ::getsockname(listening_.get(), reinterpret_cast<sockaddr*>(&address), &size);
    url_ = "ws://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/";
    thread_ = std::thread([this, script = std::move(script)] {
      ScriptedPeer peer(::accept4(listening_.get(), nullptr, nullptr, SOCK_CLOEXEC));
      script(peer);
    });
  }
  ~ScriptedServer() {
    ::shutdown(listening_.get(), SHUT_RDWR);  // ends accept() if no client came
    thread_.join();
  }

  const std::string& url() const { return url_; }

 private:
  robot::FileDescriptor listening_;
  std::string url_;
  std::thread thread_;
};

/// Returns a frame of a server, which needs no mask. `final` is false for all but the last fragment of a message.
inline std::string server_frame(robot::net::Opcode opcode, std::string_view payload, bool final = true) {
  std::string frame;
  robot::net::append_frame(frame, opcode, payload);
  if (!final) frame[0] = static_cast<char>(frame[0] & 0x7f);
  return frame;
}

/// Returns the beginning of a server's frame: its header and the first bytes of a payload of `announced_bytes`.
inline std::string begun_frame(robot::net::Opcode opcode, std::uint64_t announced_bytes, std::string_view first) {
  std::string frame;
  robot::net::append_frame_header(frame, opcode, announced_bytes);
  return frame.append(first);
}

}  // namespace tests
