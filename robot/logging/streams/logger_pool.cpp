#include "robot/logging/streams/logger_pool.h"

#include <mutex>
#include <utility>

#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::logging {

LoggerPool::~LoggerPool() {
  if (rung_) bell_.remove(*this);
  {
    const std::lock_guard guard(lock_);
    ended_ = true;
    work_.notify_all();
  }
  for (std::thread& thread : threads_) thread.join();
}

LoggerPool::Stream::Stream(LoggerPool& pool, std::shared_ptr<memory::Channel> channel,
                           std::unique_ptr<OutProvider> provider, std::size_t queue_bytes)
    : pool_(pool), carrier_(std::move(channel), std::move(provider), queue_bytes) {
  carrier_.attach();
  pool_.add(*this);
}

void LoggerPool::Stream::stop() {
  if (std::exchange(stopped_, true)) return;
  carrier_.detach();  // ends a blocked write, so that remove() does not wait for the device
  pool_.remove(*this);
  carrier_.finish();
}

void LoggerPool::add(Stream& stream) {
  bool first = false;
  {
    const std::lock_guard guard(lock_);
    streams_.push_back(&stream);
    first = !std::exchange(rung_, true);
    start_threads();
  }
  if (first) bell_.add(*this);  // outside the lock, because the bell holds its own lock when it calls ring()
}

void LoggerPool::start_missing_threads() {
  const std::lock_guard guard(lock_);
  if (!streams_.empty()) start_threads();
}

/// Starts threads until there are kThreads or the system refuses one. Called with the lock.
void LoggerPool::start_threads() {
  while (threads_.size() < kThreads) {
    std::thread thread;
    if (const Result<void> started = start_thread(thread, "log watched", [this] { run(); }); !started)
      return report(Level::error, "logging", started.error());
    threads_.push_back(std::move(thread));
  }
}

/// After the return no thread uses `stream`.
void LoggerPool::remove(Stream& stream) {
  const std::lock_guard guard(lock_);
  while (stream.state_ == Stream::State::busy) done_.wait(lock_);
  std::erase(streams_, &stream);
  std::erase(ready_, &stream);
}

void LoggerPool::ring(std::uint64_t now_ns) {
  const std::lock_guard guard(lock_);
  for (Stream* stream : streams_) {
    if (stream->state_ != Stream::State::resting || !stream->carrier_.due(now_ns)) continue;
    stream->state_ = Stream::State::ready;
    ready_.push_back(stream);
  }
  if (ready_.empty()) return;
  if (busy_ == 0 || behind_) work_.notify_one();
  behind_ = true;
}

void LoggerPool::run() {
  become_background_thread("log watched");
  std::unique_lock guard(lock_);
  while (true) {
    while (ready_.empty() && !ended_) work_.wait(lock_);
    if (ended_) return;
    Stream& stream = *ready_.front();
    ready_.pop_front();
    stream.state_ = Stream::State::busy;
    ++busy_;

    guard.unlock();
    const bool more = stream.carrier_.carry_queued();
    guard.lock();

    --busy_;
    stream.state_ = more ? Stream::State::ready : Stream::State::resting;
    if (more) ready_.push_back(&stream);
    if (ready_.empty()) behind_ = false;
    done_.notify_all();
  }
}

}  // namespace robot::logging
