// A channel for tests of streams, and a provider that keeps its records.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "robot/logging/streams/provider.h"
#include "robot/memory/channel.h"
#include "tests/support/eventually.h"

namespace tests {

inline std::shared_ptr<robot::memory::RawChannel> make_channel(const robot::Clock& clock,
                                                               std::string topic = "/14/2/test") {
  return std::make_shared<robot::memory::RawChannel>(
      robot::memory::ChannelInfo{.topic = std::move(topic),
                                 .schema = {.name = "test.Thing", .encoding = "protobuf", .bytes = "schema"},
                                 .delivery = robot::memory::Delivery::fifo},
      clock);
}

/// The records of a `KeepingProvider`; outlives it. Any thread.
struct Arrivals {
  std::mutex lock;
  std::condition_variable changed;
  std::vector<robot::logging::Record> records;
  bool closed = false;
  bool refuse = false;   // write() fails
  bool blocked = false;  // write() waits until this is false or it is cancelled

  /// Waits until `count` records are there.
  void wait_for(std::size_t count) {
    const auto arrived = [&] {
      const std::lock_guard guard(lock);
      return records.size();
    };
    ASSERT_TRUE(eventually([&] { return arrived() >= count; }, kLongestWait, arrived))
        << "expected " << count << " records";
  }
  void set(bool Arrivals::*flag, bool value) {
    const std::lock_guard guard(lock);
    this->*flag = value;
    changed.notify_all();
  }
};

class KeepingProvider final : public robot::logging::OutProvider {
 public:
  explicit KeepingProvider(std::shared_ptr<Arrivals> arrivals) : arrivals_(std::move(arrivals)) {}

  robot::Result<void> open(const robot::memory::ChannelInfo&) override { return {}; }

  robot::Result<void> write(const robot::memory::VersionPtr& version) override {
    std::unique_lock guard(arrivals_->lock);
    arrivals_->changed.wait(guard, [&] { return !arrivals_->blocked || cancelled_; });
    if (arrivals_->refuse) return robot::Error{"test device: expected to work, was told to fail"};
    arrivals_->records.push_back({.sequence = version->sequence(),
                                  .capture_ns = version->capture_ns(),
                                  .publish_ns = version->publish_ns(),
                                  .bytes = std::string(version->bytes())});
    arrivals_->changed.notify_all();
    return {};
  }

  robot::Result<void> close() override {
    arrivals_->set(&Arrivals::closed, true);
    return {};
  }

  void cancel() override {
    const std::lock_guard guard(arrivals_->lock);
    cancelled_ = true;
    arrivals_->changed.notify_all();
  }

 private:
  const std::shared_ptr<Arrivals> arrivals_;
  bool cancelled_ = false;
};

}  // namespace tests
