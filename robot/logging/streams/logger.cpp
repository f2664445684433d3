#include "robot/logging/streams/logger.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::logging {

Logger::Logger(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider, std::size_t queue_bytes,
               Bell* bell)
    : channel_(std::move(channel)),
      provider_(std::move(provider)),
      bell_(bell),
      queue_(queue_bytes, bell ? std::optional(provider_->patience()) : std::nullopt),
      gate_(*provider_, queue_),
      status_{.topic = channel_->info().topic},
      thread_([this] { run(); }) {
  if (bell_) bell_->add(queue_);
  channel_->attach(gate_);
}

Logger::~Logger() { stop(); }

void Logger::stop() {
  channel_->detach(gate_);
  if (bell_) bell_->remove(queue_);
  queue_.close();
  provider_->cancel();
  if (thread_.joinable()) thread_.join();
}

StreamStatus Logger::status() const {
  const std::lock_guard guard(lock_);
  StreamStatus status = status_;
  const std::uint64_t lost = std::min(provider_->lost_afterwards(), status.messages);
  status.messages -= lost;
  status.dropped += lost + queue_.dropped();
  status.queued_bytes = queue_.queued_bytes();
  return status;
}

void Logger::run() {
  become_background_thread("log " + channel_->info().topic.substr(channel_->info().topic.rfind('/') + 1));
  open();
  while (true) {
    const memory::VersionPtr version = queue_.pop(provider_->flush_due_ns());
    if (version) write(version);
    if (open_ && monotonic_ns() >= provider_->flush_due_ns()) succeeded(provider_->flush());
    if (!version && queue_.closed()) break;
  }
  if (open_) succeeded(provider_->close());
  const std::lock_guard guard(lock_);
  status_.ended = true;
}

bool Logger::open() {
  if (open_ || monotonic_ns() < next_open_ns_) return open_;
  next_open_ns_ = monotonic_ns() + kSecond;
  return open_ = succeeded(provider_->open(channel_->info()));
}

void Logger::write(const memory::VersionPtr& version) {
  const bool written = open() && succeeded(provider_->write(version));
  const std::lock_guard guard(lock_);
  ++(written ? status_.messages : status_.dropped);
}

/// Stores the outcome in the status. Reports a failure when it begins, not with every message.
bool Logger::succeeded(const Result<void>& outcome) {
  const std::lock_guard guard(lock_);
  if (!outcome && !status_.failing) report(Level::error, "logging", outcome.error());
  status_.failing = !outcome;
  status_.problem = outcome ? "" : outcome.error();
  return !status_.failing;
}

}  // namespace robot::logging
