#include "robot/net/foxglove/inbox.h"

#include <mutex>
#include <utility>

namespace robot::net {

bool Inbox::put(Item item, const bool& cancelled) {
  const std::size_t size = item.version->size_bytes();
  std::unique_lock guard(lock_);
  // one message beyond the bound still passes, alone
  while (!closed_ && !cancelled && !contents_.items.empty() && bytes_ + size > max_bytes_) room_.wait(lock_);
  if (closed_ || cancelled) return false;
  bytes_ += size;
  contents_.items.push_back(std::move(item));
  wake_reader();
  return true;
}

void Inbox::cancel(bool& cancelled) {
  const std::lock_guard guard(lock_);
  cancelled = true;
  room_.notify_all();
}

void Inbox::post(Task task) {
  const std::lock_guard guard(lock_);
  if (closed_) return;
  contents_.tasks.push_back(std::move(task));
  wake_reader();
}

void Inbox::take(Contents& contents) {
  contents.items.clear();
  contents.tasks.clear();
  const std::lock_guard guard(lock_);
  std::swap(contents, contents_);
  bytes_ = 0;
  woken_ = false;
  room_.notify_all();
}

void Inbox::close() {
  const std::lock_guard guard(lock_);
  closed_ = true;
  wake_ = nullptr;
  room_.notify_all();
}

void Inbox::wake_reader() {
  if (!std::exchange(woken_, true)) wake_();
}

}  // namespace robot::net
