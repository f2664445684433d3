// One WebSocket connection: reads frames and writes batches from the client's queue.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "robot/net/serve/connection.h"
#include "robot/net/websocket/frames.h"

namespace robot::net {

class WebSocketConnection : public std::enable_shared_from_this<WebSocketConnection> {
 public:
  WebSocketConnection(Socket socket, ConnectionContext& context);

  /// Sends `response`, the answer to the handshake, then exchanges frames. `begun` has the first received frame bytes.
  void start(ClientIdentity identity, std::string response, std::string begun);

  /// Writes the client's queue, unless a write is in progress.
  void flush();

  /// Ends a close handshake that takes too long.
  void check_deadline(std::uint64_t now_ns);

  /// Starts the close handshake because the server stops.
  void go_away();

  /// Ends the connection at once.
  void close();

  Socket& socket() { return socket_; }

 private:
  void read();
  void take(std::string_view bytes);
  bool on_message(Opcode opcode, const std::string& payload);
  void on_written();

  Socket socket_;
  ConnectionContext& context_;
  std::shared_ptr<Client> client_;  // null once it is closed

  FrameParser parser_;
  std::array<char, 16384> input_{};
  bool peer_closed_ = false;  // it has sent its close frame

  Batch batch_;
  bool writing_ = false, sent_all_ = false;
  std::uint64_t deadline_ns_ = UINT64_MAX;
};

}  // namespace robot::net
