// The common part of HTTP and WebSocket connections. Only for the server's own files.
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

/// The address of a connection's client.
struct Remote {
  std::string address;  // "10.0.14.7"
  std::uint16_t port = 0;

  std::string text() const;  // "10.0.14.7:51234", "[::1]:51234"
};

/// The parts of the server that connections use. Used by the I/O thread.
struct ConnectionContext {
  const ServerOptions& options;
  const Routes& routes;
  Hub& hub;
  boost::asio::io_context& io;
  Worker &status, &files, &checksums;  // answers, see Work
  Worker& downloads;                   // pieces of answers that are recordings

  // these sets and their pending operations keep connections alive
  std::set<std::shared_ptr<HttpConnection>> http = {};
  std::set<std::shared_ptr<WebSocketConnection>> web_sockets = {};
};

/// Turns off Nagle's algorithm and limits the kernel's unsent data to 32 kB. Old data wait in our queue, where newer
/// data can replace them.
void set_low_latency(Socket& socket);

}  // namespace robot::net
