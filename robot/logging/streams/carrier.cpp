#include "robot/logging/streams/carrier.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/clock.h"
#include "robot/core/report.h"

namespace robot::logging {

Carrier::Carrier(std::shared_ptr<memory::Channel> channel, std::unique_ptr<OutProvider> provider,
                 std::size_t queue_bytes)
    : channel_(std::move(channel)),
      provider_(std::move(provider)),
      queue_(queue_bytes, provider_->patience()),
      gate_(*provider_, queue_),
      status_{.topic = channel_->info().topic} {}

void Carrier::detach() {
  channel_->detach(gate_);
  queue_.close();
  provider_->cancel();
}

bool Carrier::carry() {
  const memory::VersionPtr version = queue_.pop(provider_->flush_due_ns());
  if (version) write(version);
  if (open_ && monotonic_ns() >= provider_->flush_due_ns()) succeeds([&] { return provider_->flush(); });
  return version || !queue_.closed();
}

bool Carrier::carry_queued() {
  if (const memory::VersionPtr version = queue_.pop(0)) write(version);
  return queue_.state().waiting > 0;
}

void Carrier::finish() {
  open();
  while (carry_queued()) {
  }
  // a second attempt, so that one failure leaves no file without an end
  if (open_ && !succeeds([&] { return provider_->close(); })) succeeds([&] { return provider_->close(); });
  open_ = false;
  const std::lock_guard guard(lock_);
  status_.ended = true;
}

StreamStatus Carrier::status() const {
  const std::lock_guard guard(lock_);
  StreamStatus status = status_;
  const std::uint64_t lost = std::min(provider_->lost_afterwards(), status.messages);
  const std::uint64_t buffered = std::min(buffered_, status.messages - lost);
  const VersionQueue::State queue = queue_.state();
  status.messages -= lost + buffered;
  status.dropped += lost + queue.dropped;
  status.waiting = buffered + queue.waiting;
  status.queued_bytes = queue.bytes;
  status.first = queue.first;
  status.newest = queue.last;
  return status;
}

bool Carrier::open() {
  if (open_ || monotonic_ns() < next_open_ns_) return open_;
  next_open_ns_ = monotonic_ns() + kSecond;
  return open_ = succeeds([&] { return provider_->open(channel_->info()); });
}

void Carrier::write(const memory::VersionPtr& version) {
  const bool written = open() && succeeds([&] { return provider_->write(version); });
  const std::lock_guard guard(lock_);
  ++(written ? status_.messages : status_.dropped);
  buffered_ = provider_->buffered();
}

/// Calls a function of the device and stores the outcome in the status. Reports a failure when it begins, not with every
/// message. A success that only fills the provider's buffer ends no failure.
bool Carrier::succeeds(const std::function<Result<void>()>& call) {
  const Result<void> outcome = attempt("writing to a device", call);
  const bool delivered = outcome && provider_->flush_due_ns() == OutProvider::kNever;
  const std::lock_guard guard(lock_);
  buffered_ = provider_->buffered();
  if (!outcome) {
    if (!status_.failing) report(Level::error, "logging", outcome.error());
    status_.failing = true;
    status_.problem = outcome.error();
    status_.failed_ns = monotonic_ns();
  } else if (delivered) {
    status_.failing = false;
    status_.problem.clear();
    status_.delivered_ns = monotonic_ns();
  }
  return bool(outcome);
}

}  // namespace robot::logging
