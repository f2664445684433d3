// The socket side of the server: what HTTP and WebSocket connections share. Only for the server's own files.
#pragma once

#include <utility>  // before Asio: Boost 1.74 uses std::exchange without it

#define BOOST_ERROR_CODE_HEADER_ONLY
#include <boost/asio/basic_stream_socket.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "robot/net/foxglove/hub.h"
#include "robot/net/foxglove/worker.h"
#include "robot/net/serve/routes.h"
#include "robot/net/serve/server.h"

namespace robot::net {

// one thread, no strands: executors are concrete, so no call is virtual
using Socket = boost::asio::basic_stream_socket<boost::asio::ip::tcp, boost::asio::io_context::executor_type>;

class HttpConnection;
class WebSocketConnection;

/// The other end of a connection.
struct Remote {
  std::string address;  // "10.0.14.7"
  std::uint16_t port = 0;

  std::string text() const;  // "10.0.14.7:51234", "[::1]:51234"
};

/// What connections need of the server. Used by the I/O thread.
struct ConnectionContext {
  const ServerOptions& options;
  const Routes& routes;
  Hub& hub;
  boost::asio::io_context& io;
  Worker& disk;

  // connections are kept alive by these and by their pending operations
  std::set<std::shared_ptr<HttpConnection>> http = {};
  std::set<std::shared_ptr<WebSocketConnection>> web_sockets = {};
};

/// Turns off Nagle's algorithm and keeps what the kernel holds back unsent at 32 kB: old data wait with us, where newer
/// ones can replace them.
void set_low_latency(Socket& socket);

}  // namespace robot::net
