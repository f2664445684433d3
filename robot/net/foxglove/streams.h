// The hub's interface to the logging board, which carries channels to providers.
#pragma once

#include <cstdint>
#include <memory>

#include "robot/logging/streams/provider.h"
#include "robot/memory/channel.h"

namespace robot::net {

/// The carrier of channels: the logging board. Called by one thread of the server, never by its I/O thread.
class Streams {
 public:
  using Id = std::uint64_t;

  virtual ~Streams() = default;

  /// Carries every version of `channel` to `provider` from now on, beginning with the newest version, on a thread of the
  /// logging board.
  virtual Id start(std::shared_ptr<memory::Channel> channel, std::unique_ptr<logging::OutProvider> provider) = 0;

  /// Ends the stream. After the return the provider is no longer used.
  virtual void stop(Id id) = 0;
};

}  // namespace robot::net
