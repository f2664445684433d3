#include "robot/logging/streams/version_queue.h"

#include <mutex>
#include <new>
#include <utility>

#include "robot/core/clock.h"

namespace robot::logging {

void VersionQueue::on_version(const memory::VersionPtr& version) {
  const std::lock_guard guard(lock_);
  if (closed_) return;
  if (first_ == 0) first_ = version->sequence();
  last_ = version->sequence();
  while (!versions_.empty() && bytes_ + version->size_bytes() > max_bytes_) {
    bytes_ -= versions_.front()->size_bytes();
    versions_.pop_front();
    ++dropped_;
  }
  // an exception would reach the writer of the object, and no other listener would see the version
  try {
    versions_.push_back(version);
    bytes_ += version->size_bytes();
  } catch (const std::bad_alloc&) {
    ++dropped_;
  }
}

bool VersionQueue::due(std::uint64_t now_ns) {
  const std::unique_lock guard(lock_, std::try_to_lock);
  if (!guard || versions_.empty()) return false;
  if (noticed_ns_ == 0) noticed_ns_ = now_ns;
  return bytes_ >= patience_.bytes || now_ns >= noticed_ns_ + patience_.time_ns;
}

memory::VersionPtr VersionQueue::pop(std::uint64_t deadline_ns) {
  const std::lock_guard guard(lock_);
  while (versions_.empty() && !closed_ && monotonic_ns() < deadline_ns) filled_.wait_until(lock_, deadline_ns);
  if (versions_.empty()) return nullptr;
  memory::VersionPtr version = std::move(versions_.front());
  versions_.pop_front();
  bytes_ -= version->size_bytes();
  noticed_ns_ = 0;
  return version;
}

void VersionQueue::close() {
  const std::lock_guard guard(lock_);
  closed_ = true;
  filled_.notify_all();
}

bool VersionQueue::closed() const {
  const std::lock_guard guard(lock_);
  return closed_;
}

VersionQueue::State VersionQueue::state() const {
  const std::lock_guard guard(lock_);
  return {.first = first_, .last = last_, .dropped = dropped_, .waiting = versions_.size(), .bytes = bytes_};
}

}  // namespace robot::logging
