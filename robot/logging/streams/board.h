// The logging board: which memory object is carried by which logger or parser.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <variant>
#include <vector>

#include "robot/core/lock.h"
#include "robot/logging/streams/logger.h"
#include "robot/logging/streams/parser.h"

namespace robot::logging {

/// Starts and stops streams while the robot runs. Any thread.
class LoggingBoard {
 public:
  using StreamId = std::uint64_t;

  /// What may wait for a slow device [bytes]: four seconds of raw images at 30 Hz would be 74 MB, too much for a Nao;
  /// this is about half a second of them, two and a half of the images of profile `game`, minutes of anything else.
  static constexpr std::size_t kQueueBytes = 8 << 20;

  /// Carries `channel` to `provider` from now on.
  StreamId start_logger(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider,
                        std::size_t queue_bytes = kQueueBytes);

  /// Carries `provider` into the channel that `options` name, from now on.
  StreamId start_parser(std::unique_ptr<InProvider> provider, ParserOptions options);

  /// Ends the stream in good order and forgets it; returns how it ended. A stream that is not there: an empty status.
  StreamStatus stop(StreamId stream);

  /// How `stream` is doing; empty if it is not there.
  StreamStatus status(StreamId stream) const;

  /// How all streams are doing, in the order in which they were started.
  std::vector<StreamStatus> statuses() const;

 private:
  using Stream = std::variant<std::unique_ptr<Logger>, std::unique_ptr<Parser>>;

  StreamId add(Stream stream);

  Bell bell_;  // before the loggers: it outlives them
  mutable Mutex lock_;
  std::map<StreamId, std::shared_ptr<Stream>> streams_;
  StreamId last_id_ = 0;
};

}  // namespace robot::logging
