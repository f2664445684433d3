// The logging board: the list of all loggers and parsers, and their memory objects.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <variant>
#include <vector>

#include "robot/core/lock.h"
#include "robot/logging/streams/logger.h"
#include "robot/logging/streams/logger_pool.h"
#include "robot/logging/streams/parser.h"

namespace robot::logging {

/// The streams of a process, which start and stop while the robot runs. Any thread.
class LoggingBoard {
 public:
  using StreamId = std::uint64_t;

  /// The bound of each queue to a slow device [bytes]. Four seconds of raw images at 30 Hz would take 74 MB, too much
  /// for a Nao. This bound holds about half a second of raw images, or 2.5 s of the images of profile `game`. It holds
  /// minutes of any other object.
  static constexpr std::size_t kQueueBytes = 8 << 20;

  /// Starts a logger that carries `channel` to `provider`. It has a thread of its own.
  StreamId start_logger(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider,
                        std::size_t queue_bytes = kQueueBytes);

  /// As start_logger(), but all streams that are started here share the few threads of a LoggerPool.
  StreamId start_pooled(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider,
                        std::size_t queue_bytes = kQueueBytes);

  /// Starts a parser that carries `provider` into the channel that `options` name.
  StreamId start_parser(std::unique_ptr<InProvider> provider, ParserOptions options);

  /// Starts the threads that the system refused before. Called once a second.
  void start_missing_threads();

  /// Closes the stream and removes it. Returns its last status, or an empty one if there is no such stream.
  StreamStatus stop(StreamId stream);

  /// Returns the status of `stream`, or an empty one if there is no such stream.
  StreamStatus status(StreamId stream) const;

  /// Returns the status of every stream, in the order in which they were started.
  std::vector<StreamStatus> statuses() const;

 private:
  using Stream = std::variant<std::unique_ptr<Logger>, std::unique_ptr<LoggerPool::Stream>, std::unique_ptr<Parser>>;

  StreamId add(Stream stream);

  // declared before the streams, because they must outlive them
  Bell bell_;
  LoggerPool pool_{bell_};
  mutable Mutex lock_;
  std::map<StreamId, std::shared_ptr<Stream>> streams_;
  StreamId last_id_ = 0;
};

}  // namespace robot::logging
