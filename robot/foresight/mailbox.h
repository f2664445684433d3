// Passes the newest value from one thread to another without locks: neither waits, whatever their priorities.
#pragma once

#include <atomic>

namespace robot::foreseeing {

/// A triple buffer: one value is written, one is read, one lies in between. One thread writes, one reads.
template <class Value>
class Mailbox {
 public:
  /// Returns the value for the next `publish`. It holds an older value until it is written. For the writer.
  Value& draft() { return values_[writing_]; }

  /// Makes the draft the newest value. For the writer.
  void publish() { writing_ = between_.exchange(writing_ | kNew, std::memory_order_acq_rel) & kIndex; }

  /// Returns the newest published value, or a default value before the first. It stays the same
  /// until the next call. For the reader.
  const Value& newest() {
    if ((between_.load(std::memory_order_relaxed) & kNew) != 0)
      reading_ = between_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return values_[reading_];
  }

 private:
  static constexpr unsigned kIndex = 3, kNew = 4;

  Value values_[3] = {};
  unsigned writing_ = 0;
  std::atomic<unsigned> between_ = 1;
  unsigned reading_ = 2;
};

}  // namespace robot::foreseeing
