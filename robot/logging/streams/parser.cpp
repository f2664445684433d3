#include "robot/logging/streams/parser.h"

#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::logging {

Parser::Parser(std::unique_ptr<InProvider> provider, ParserOptions options)
    : provider_(std::move(provider)), options_(std::move(options)) {
  if (const Result<void> started = start_thread(thread_, "parser", [this] { run(); }); !started) {
    note(started.error());
    status_.ended = true;
  }
}

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
  if (const Result<void> carried = attempt("parsing a stream", [&] { return carry(); }); !carried)
    note(carried.error());
  const std::lock_guard guard(lock_);
  status_.ended = true;
}

/// Reports a problem of the stream, unless stop() caused it.
void Parser::note(const std::string& problem) {
  const std::lock_guard guard(lock_);
  if (stopping_) return;
  status_.failing = true;
  status_.problem = problem;
  report(Level::error, "logging", problem);
}

Result<void> Parser::carry() {
  Result<memory::ChannelInfo> info = provider_->open();
  if (!info) return info.failure();
  {
    const std::lock_guard guard(lock_);
    status_.topic = info->topic;
  }
  const Result<std::shared_ptr<memory::Channel>> channel = options_.destination(*info);
  if (!channel) return channel.failure();

  std::uint64_t moves = 0;
  while (true) {
    Result<std::optional<Record>> record = provider_->read();
    if (!record) {
      note(record.error());
      continue;
    }
    const Result<Pace::Due> due = keep_pace(*record, moves);
    if (!due) return due.failure();
    if (*due == Pace::Due::never) return {};
    if (*due == Pace::Due::elsewhere) continue;
    {
      const std::lock_guard guard(lock_);
      if (stopping_) return {};
    }
    count(attempt("a message", [&] { return (*channel)->write_bytes((*record)->bytes, (*record)->capture_ns); }));
  }
}

/// Waits until `record` is due; at the end of the stream, waits for a move. Follows a move with a seek.
Result<Pace::Due> Parser::keep_pace(const std::optional<Record>& record, std::uint64_t& moves) {
  if (!options_.pace) return record ? Pace::Due::now : Pace::Due::never;
  const Pace::Due due =
      record ? options_.pace->wait_until_due(record->capture_ns, moves) : options_.pace->wait_for_move(moves);
  if (due != Pace::Due::elsewhere) return due;
  const Pace::Move move = options_.pace->last_move();
  moves = move.count;
  if (const Result<void> sought = provider_->seek(move.to_ns); !sought) return sought.failure();
  return due;
}

void Parser::count(const Result<void>& entered) {
  const std::lock_guard guard(lock_);
  ++(entered ? status_.messages : status_.dropped);
  if (!entered) status_.problem = entered.error();
}

}  // namespace robot::logging
