#include "robot/logging/streams/logger.h"

#include <string>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::logging {

Logger::Logger(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider, std::size_t queue_bytes,
               Bell& bell)
    : bell_(bell), carrier_(std::move(channel), std::move(provider), queue_bytes) {
  bell_.add(*this);
  carrier_.attach();
}

void Logger::stop() {
  if (std::exchange(stopped_, true)) return;
  bell_.remove(*this);  // afterwards no thread is started
  carrier_.detach();
  if (thread_.joinable()) thread_.join();
  carrier_.finish();
}

void Logger::ring(std::uint64_t now_ns) {
  if (!carrier_.due(now_ns)) return;
  if (thread_.joinable()) return carrier_.wake();
  if (now_ns < next_try_ns_) return;
  next_try_ns_ = now_ns + kSecond;
  const std::string purpose = "log " + carrier_.info().topic;
  if (const Result<void> started = start_thread(thread_, purpose, [this] { run(); }); !started)
    report(Level::error, "logging", started.error() + "; its versions wait");
}

void Logger::run() {
  const std::string& topic = carrier_.info().topic;
  become_background_thread("log " + topic.substr(topic.rfind('/') + 1));
  while (carrier_.carry()) {
  }
}

}  // namespace robot::logging
