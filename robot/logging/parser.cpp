#include "robot/logging/parser.h"

#include <mutex>
#include <utility>

#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::logging {

Parser::Parser(std::unique_ptr<InProvider> provider, ParserOptions options)
    : provider_(std::move(provider)), options_(std::move(options)), thread_([this] { run(); }) {}

Parser::~Parser() { stop(); }

void Parser::stop() {
  {
    const std::lock_guard guard(lock_);
    stopping_ = true;
  }
  provider_->cancel();
  if (thread_.joinable()) thread_.join();
}

StreamStatus Parser::status() const {
  const std::lock_guard guard(lock_);
  StreamStatus status = status_;
  status.dropped += provider_->lost_before();
  return status;
}

void Parser::run() {
  become_background_thread("parser");
  if (const Result<void> carried = carry(); !carried) note(carried.error());
  const std::lock_guard guard(lock_);
  status_.ended = true;
}

/// Tells of something wrong with the stream, unless that is only because it is being stopped.
void Parser::note(const std::string& problem) {
  const std::lock_guard guard(lock_);
  if (stopping_) return;
  status_.failing = true;
  status_.problem = problem;
  report(Level::error, "logging", problem);
}

Result<void> Parser::carry() {
  Result<memory::ChannelInfo> info = provider_->open();
  if (!info) return Error{info.error()};
  {
    const std::lock_guard guard(lock_);
    status_.topic = info->topic;
  }
  const Result<std::shared_ptr<memory::Channel>> channel = options_.destination(*info);
  if (!channel) return Error{channel.error()};

  while (true) {
    Result<std::optional<Record>> record = provider_->read();
    if (!record) {
      note(record.error());
      continue;
    }
    if (!*record) return {};
    if (options_.pace && !options_.pace->wait_until_due((*record)->capture_ns)) return {};
    {
      const std::lock_guard guard(lock_);
      if (stopping_) return {};
    }
    count((*channel)->write_bytes((*record)->bytes, (*record)->capture_ns));
  }
}

void Parser::count(const Result<void>& entered) {
  const std::lock_guard guard(lock_);
  ++(entered ? status_.messages : status_.dropped);
  if (!entered) status_.problem = entered.error();
}

}  // namespace robot::logging
