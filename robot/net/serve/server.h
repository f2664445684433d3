// The server of viewer, API, recordings and live data at one port.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/net/foxglove/hub.h"
#include "robot/net/foxglove/parameters.h"
#include "robot/net/foxglove/services.h"
#include "robot/net/foxglove/statistics.h"
#include "robot/net/foxglove/web_socket_out_provider.h"
#include "robot/net/http/assets.h"
#include "robot/net/serve/backend.h"
#include "robot/net/serve/routes.h"

namespace robot::net {

struct ServerOptions {
  std::vector<std::string> bind = {"127.0.0.1"};  // IP addresses to listen on; "0.0.0.0" and "::" mean all
  std::uint16_t port = 8765;                      // 0: any free port
  HubOptions hub;
  AccessOptions access;
  std::vector<std::string>
      wireless;  // interfaces that stay silent during a game; empty: all except loopback and cables

  // limits of the memory and time that clients can take
  std::size_t max_clients = 64;                     // WebSocket connections
  std::size_t max_http_connections = 256;           // others; the oldest without a request goes first
  std::size_t max_message_bytes = 1 << 20;          // from a client
  std::size_t inbox_bytes = 8 << 20;                // between logger threads and the I/O thread
  std::uint64_t request_timeout_ns = 10 * kSecond;  // for a whole request header, also the first of a new connection
  std::uint64_t idle_timeout_ns = 30 * kSecond;     // between two requests, and while a write makes no progress
  std::uint64_t close_timeout_ns = 5 * kSecond;     // for the goodbye of a WebSocket
  std::uint64_t stop_timeout_ns = kSecond / 2;      // for the goodbyes of all WebSockets when the server stops

  std::span<const Asset> assets = {kViewerAssets, kViewerAssetCount};
};

/// A server of HTTP and the Foxglove protocol with an I/O thread of its own and helper threads. Each kind of Work has one.
/// Others read pieces of downloads, start and stop loggers, and run questions of clients.
///
/// Without a free file descriptor it ends the connection that waits longest without a request. If there is none, it
/// answers one client with 503 and rests until the next tick.
class Server {
 public:
  /// All references must outlive the server, and `services` must be complete. Channels may come later.
  Server(ServerOptions options, memory::Channels& channels, Derive derive, Streams& streams, const Clock& clock,
         Parameters& parameters, const Services& services, Backend& backend);

  /// Calls stop().
  ~Server();

  /// Listens and serves from now on. Returns an Error if an address is not available. Call it once.
  Result<void> start();

  /// Sends a goodbye to the clients, closes all connections and ends the threads. It uses no reference afterwards.
  void stop();

  /// Returns the port on which it listens, after start().
  std::uint16_t port() const;

  /// Returns statistics of the clients, at most a second old. Any thread.
  ServerStatistics statistics() const;

  /// Sets an entry of the metadata of all clients, see Hub::set_metadata(). Any thread.
  void set_metadata(const std::string& key, const std::string& value);

  /// Begins another time line, see Hub::restart_time(). Any thread.
  void restart_time();

 private:
  class Core;
  std::shared_ptr<Core> core_;
};

}  // namespace robot::net
