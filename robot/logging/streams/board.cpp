#include "robot/logging/streams/board.h"

#include <mutex>
#include <utility>

namespace robot::logging {

LoggingBoard::StreamId LoggingBoard::start_logger(std::shared_ptr<memory::Channel> channel,
                                                  std::unique_ptr<OutProvider> provider, std::size_t queue_bytes) {
  return add(std::make_unique<Logger>(std::move(channel), std::move(provider), queue_bytes, bell_));
}

LoggingBoard::StreamId LoggingBoard::start_pooled(std::shared_ptr<memory::Channel> channel,
                                                  std::unique_ptr<OutProvider> provider, std::size_t queue_bytes) {
  return add(std::make_unique<LoggerPool::Stream>(pool_, std::move(channel), std::move(provider), queue_bytes));
}

LoggingBoard::StreamId LoggingBoard::start_parser(std::unique_ptr<InProvider> provider, ParserOptions options) {
  return add(std::make_unique<Parser>(std::move(provider), std::move(options)));
}

void LoggingBoard::start_missing_threads() {
  bell_.start_missing_thread();
  pool_.start_missing_threads();
}

LoggingBoard::StreamId LoggingBoard::add(Stream stream) {
  const std::lock_guard guard(lock_);
  streams_.emplace(++last_id_, std::make_shared<Stream>(std::move(stream)));
  return last_id_;
}

StreamStatus LoggingBoard::stop(StreamId id) {
  std::shared_ptr<Stream> stream;  // stopped outside the lock, so that a slow device does not delay other streams
  {
    const std::lock_guard guard(lock_);
    const auto found = streams_.find(id);
    if (found == streams_.end()) return {};
    stream = std::move(found->second);
    streams_.erase(found);
  }
  return std::visit(
      [](auto& one) {
        one->stop();
        return one->status();
      },
      *stream);
}

StreamStatus LoggingBoard::status(StreamId id) const {
  const std::lock_guard guard(lock_);
  const auto found = streams_.find(id);
  if (found == streams_.end()) return {};
  return std::visit([](const auto& one) { return one->status(); }, *found->second);
}

std::vector<StreamStatus> LoggingBoard::statuses() const {
  const std::lock_guard guard(lock_);
  std::vector<StreamStatus> statuses;
  for (const auto& [id, stream] : streams_)
    statuses.push_back(std::visit([](const auto& one) { return one->status(); }, *stream));
  return statuses;
}

}  // namespace robot::logging
