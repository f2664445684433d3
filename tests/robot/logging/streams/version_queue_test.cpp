#include "robot/logging/streams/version_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "robot/core/clock.h"
#include "robot/logging/streams/provider.h"
#include "tests/support/eventually.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

constexpr std::uint64_t kNever = OutProvider::kNever;

struct Queue : ::testing::Test {
  void write(std::size_t bytes) { ASSERT_TRUE(channel->write_bytes(std::string(bytes, 'x'), 1)); }

  ManualClock clock;
  std::shared_ptr<memory::RawChannel> channel = tests::make_channel(clock);
  VersionQueue queue{100};
};

TEST_F(Queue, ReturnsVersionsInOrder) {
  channel->attach(queue);
  for (int i = 0; i < 3; ++i) write(10);
  channel->detach(queue);
  for (std::uint64_t expected = 1; expected <= 3; ++expected) EXPECT_EQ(queue.pop(kNever)->sequence(), expected);
  EXPECT_EQ(queue.pop(0), nullptr);
}

TEST_F(Queue, DropsTheOldestWhenFullAndCountsThem) {
  channel->attach(queue);
  for (int i = 0; i < 13; ++i) write(10);
  channel->detach(queue);
  EXPECT_EQ(queue.state().dropped, 3u);
  EXPECT_EQ(queue.state().bytes, 100u);
  EXPECT_EQ(queue.pop(kNever)->sequence(), 4u);
}

TEST_F(Queue, PassesOneTooLargeVersionAlone) {
  channel->attach(queue);
  write(10);
  write(1000);
  channel->detach(queue);
  EXPECT_EQ(queue.state().dropped, 1u);
  EXPECT_EQ(queue.pop(kNever)->size_bytes(), 1000u);
}

TEST_F(Queue, ReturnsTheRestAfterClosingAndAcceptsNothingMore) {
  channel->attach(queue);
  write(10);
  queue.close();
  write(10);
  channel->detach(queue);
  EXPECT_NE(queue.pop(kNever), nullptr);
  EXPECT_EQ(queue.pop(kNever), nullptr);
  EXPECT_EQ(queue.state().dropped, 0u);
}

TEST_F(Queue, WakeWakesAWaitingReader) {
  std::atomic<bool> woken = false;
  std::thread reader([&] {
    EXPECT_NE(queue.pop(kNever), nullptr);
    woken = true;
  });
  channel->attach(queue);
  write(10);
  EXPECT_TRUE(tests::eventually([&] {
    queue.wake();  // a call before the reader waits has no effect
    return woken.load();
  }));
  queue.close();
  reader.join();
  channel->detach(queue);
}

TEST_F(Queue, VersionsAreDueWhenThePatienceIsOver) {
  VersionQueue patient{1000, Patience{.time_ns = 50, .bytes = 100}};
  channel->attach(patient);
  EXPECT_FALSE(patient.due(900)) << "empty";
  write(10);
  EXPECT_FALSE(patient.due(1000)) << "the waiting time begins here";
  EXPECT_FALSE(patient.due(1049));
  EXPECT_TRUE(patient.due(1050));
  EXPECT_NE(patient.pop(0), nullptr);
  write(10);
  EXPECT_FALSE(patient.due(1060)) << "the next version waits anew";
  channel->detach(patient);
}

TEST_F(Queue, ManyWaitingBytesAreDueAtOnce) {
  VersionQueue patient{1000, Patience{.time_ns = kSecond, .bytes = 100}};
  channel->attach(patient);
  write(99);
  EXPECT_FALSE(patient.due(1));
  write(1);
  EXPECT_TRUE(patient.due(2));
  channel->detach(patient);
}

TEST_F(Queue, ClosingWakesAWaitingReader) {
  std::thread reader([&] { EXPECT_EQ(queue.pop(kNever), nullptr); });
  queue.close();
  reader.join();
}

// every version is either popped or counted as dropped, in any order of the threads
TEST_F(Queue, CountsEveryLostVersion) {
  constexpr std::uint64_t kWrites = 20'000;
  channel->attach(queue);
  std::uint64_t popped = 0;
  std::thread reader([&] {
    while (queue.pop(kNever)) ++popped;
  });
  for (std::uint64_t i = 0; i < kWrites; ++i) write(10);
  channel->detach(queue);
  queue.close();
  reader.join();
  EXPECT_EQ(popped + queue.state().dropped, kWrites);
}

}  // namespace
}  // namespace robot::logging
