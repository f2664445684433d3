// The logging board as the server sees it.
#pragma once

#include <utility>

#include "robot/logging/board.h"
#include "robot/net/application.h"

namespace robot::app {

/// Streams to clients are loggers like those to the disk.
class BoardStreams final : public net::Streams {
 public:
  explicit BoardStreams(logging::LoggingBoard& board) : board_(board) {}

  Id start(std::shared_ptr<memory::Channel> channel, std::unique_ptr<logging::OutProvider> provider) override {
    return board_.start_logger(std::move(channel), std::move(provider));
  }
  void stop(Id id) override { board_.stop(id); }

 private:
  logging::LoggingBoard& board_;
};

}  // namespace robot::app
