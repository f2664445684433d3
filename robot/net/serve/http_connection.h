// One HTTP connection: reads requests and writes responses until it becomes a WebSocket or ends.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <string>

#include "robot/net/http/http_parser.h"
#include "robot/net/serve/connection.h"
#include "robot/net/websocket/handshake.h"

namespace robot::net {

class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Socket socket, Remote remote, ConnectionContext& context);

  void start();

  /// Ends the connection if its deadline has passed.
  void check_deadline(std::uint64_t now_ns);

  /// Returns whether it waits without a request. The server drops the oldest such connection first.
  bool waits_for_request() const { return state_ == State::waiting; }
  std::uint64_t made_ns() const { return made_ns_; }

  /// Ends the connection at once.
  void close();

  Socket& socket() { return socket_; }

 private:
  enum class State { waiting, answering, leaving, closed };

  void wait_for_request(std::uint64_t timeout_ns);
  void read();
  void take_requests();
  void handle(HttpRequest request);
  void answer_on(Worker& worker);
  void watch_client();
  void upgrade(const HttpRequest& request);
  Result<Upgrade> agree(const HttpRequest& request, const Target& target, HttpResponse& refusal) const;
  void respond(HttpResponse response);
  void read_piece();
  void write(std::string_view head, std::string_view body);
  void on_written();
  void leave();

  Socket socket_;
  const Remote remote_;
  ConnectionContext& context_;
  const std::uint64_t made_ns_;

  State state_ = State::waiting;
  std::atomic<bool> left_ = false;  // the connection has ended; read by the threads that prepare answers
  bool watched_ = false;            // an answer takes long: the client may leave before
  std::uint64_t deadline_ns_ = 0;
  HttpParser parser_;
  std::array<char, 8192> input_{};

  // the answer being sent
  HttpRequest request_;
  HttpResponse response_;
  std::string head_;
  std::uint64_t body_sent_ = 0;
  std::shared_ptr<std::string> piece_;  // filled by the thread of downloads, which may outlive this connection
};

}  // namespace robot::net
