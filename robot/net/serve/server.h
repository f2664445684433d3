// The server: viewer, API, recordings and live data at one port.
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
  std::vector<std::string> bind = {"127.0.0.1"};  // IP addresses to listen on; "0.0.0.0" and "::" are all
  std::uint16_t port = 8765;                      // 0: any that is free
  HubOptions hub;
  AccessOptions access;
  std::vector<std::string>
      wireless;  // interfaces that stay silent during a game; empty: those the system calls wireless

  // bounds on what others can make us hold
  std::size_t max_clients = 64;                     // WebSocket connections
  std::size_t max_http_connections = 256;           // others; the oldest without a request goes first
  std::size_t max_message_bytes = 1 << 20;          // from a client
  std::size_t inbox_bytes = 8 << 20;                // between logger threads and the I/O thread
  std::uint64_t request_timeout_ns = 10 * kSecond;  // for a whole request header, also the first of a new connection
  std::uint64_t idle_timeout_ns = 30 * kSecond;     // between two requests, and while a write makes no progress
  std::uint64_t close_timeout_ns = 5 * kSecond;     // for the goodbye of a WebSocket

  std::span<const Asset> assets = {kViewerAssets, kViewerAssetCount};
};

/// Serves HTTP and the Foxglove protocol on one thread of its own, with three helpers: one waits for the disk, one for
/// loggers that start and stop, one does what people ask for.
class Server {
 public:
  /// What is referenced outlives the server, and `services` are complete. Channels may come later.
  Server(ServerOptions options, memory::Channels& channels, Derive derive, Streams& streams, const Clock& clock,
         Parameters& parameters, const Services& services, Backend& backend);

  /// As stop().
  ~Server();

  /// Listens and serves from now on; an Error if an address cannot be had. Once.
  Result<void> start();

  /// Tells the clients, closes all connections and ends the threads. Nothing of it is used any more afterwards.
  void stop();

  /// The port it listens on, after start().
  std::uint16_t port() const;

  /// How the clients are doing, at most a second ago. Any thread.
  ServerStatistics statistics() const;

  /// Another time line begins, see Hub::restart_time(). Any thread.
  void restart_time();

 private:
  class Core;
  std::shared_ptr<Core> core_;
};

}  // namespace robot::net
