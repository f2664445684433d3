// The logging board as an implementation of Streams.
#pragma once

#include <memory>
#include <utility>

#include "robot/logging/streams/board.h"
#include "robot/net/foxglove/streams.h"

namespace robot::net {

/// Streams of watched channels, which share a few threads of the board.
class BoardStreams final : public Streams {
 public:
  /// `board` must outlive it.
  explicit BoardStreams(logging::LoggingBoard& board) : board_(board) {}

  Id start(std::shared_ptr<memory::Channel> channel, std::unique_ptr<logging::OutProvider> provider) override {
    return board_.start_pooled(std::move(channel), std::move(provider));
  }
  void stop(Id id) override { board_.stop(id); }

 private:
  logging::LoggingBoard& board_;
};

}  // namespace robot::net
