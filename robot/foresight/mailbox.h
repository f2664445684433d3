// The newest value of one thread for another, without locks: neither ever waits, whatever their priorities.
#pragma once

#include <atomic>

namespace robot::foreseeing {

/// Three of them: one is written, one is read, one lies in between. One thread writes, one reads.
template <class Value>
class Mailbox {
 public:
  /// What `publish` is to give. The writer's; holds some older value until it is written.
  Value& draft() { return values_[writing_]; }

  /// The writer's. From now on the reader finds the draft.
  void publish() { writing_ = between_.exchange(writing_ | kNew, std::memory_order_acq_rel) & kIndex; }

  /// The reader's. What was published last, a default value before; stays as it is until the next call.
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
