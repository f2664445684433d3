#include "robot/logging/streams/bell.h"

#include <gtest/gtest.h>

#include "robot/logging/streams/provider.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

TEST(Bell, WakesTheReadersOfAllItsQueues) {
  ManualClock clock;
  const auto channel = tests::make_channel(clock);
  VersionQueue first{100, Patience{}}, second{100, Patience{}};
  Bell bell;
  for (VersionQueue* queue : {&first, &second}) {
    bell.add(*queue);
    channel->attach(*queue);
  }
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(channel->write_bytes("x", 1));
    for (VersionQueue* queue : {&first, &second}) EXPECT_NE(queue->pop(OutProvider::kNever), nullptr);
  }
  for (VersionQueue* queue : {&first, &second}) {
    channel->detach(*queue);
    bell.remove(*queue);
  }
}

TEST(Bell, SleepsWithoutQueuesAndStartsAgain) {
  ManualClock clock;
  const auto channel = tests::make_channel(clock);
  Bell bell;
  for (int i = 0; i < 3; ++i) {
    VersionQueue queue{100, Patience{}};
    bell.add(queue);
    channel->attach(queue);
    ASSERT_TRUE(channel->write_bytes("x", 1));
    EXPECT_NE(queue.pop(OutProvider::kNever), nullptr);
    channel->detach(queue);
    bell.remove(queue);
  }
}

}  // namespace
}  // namespace robot::logging
