#include "robot/foresight/mailbox.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace robot::foreseeing {
namespace {

TEST(Mailbox, IsEmptyBeforeSomethingIsPublished) {
  Mailbox<int> mailbox;
  mailbox.draft() = 3;
  EXPECT_EQ(mailbox.newest(), 0);
}

TEST(Mailbox, GivesTheNewestRepeatedly) {
  Mailbox<int> mailbox;
  for (int value = 1; value < 10; ++value) {
    mailbox.draft() = value;
    mailbox.publish();
    if (value % 3 == 0) {
      EXPECT_EQ(mailbox.newest(), value);
      EXPECT_EQ(mailbox.newest(), value);
    }
  }
}

/// In any interleaving of the two threads, values are whole and never older than the one before, and the last arrives.
TEST(Mailbox, ValuesOfAnotherThreadAreWholeAndInOrder) {
  constexpr int kLast = 100'000;
  Mailbox<std::array<int, 64>> mailbox;
  std::thread writer([&mailbox] {
    for (int value = 1; value <= kLast; ++value) {
      mailbox.draft().fill(value);
      mailbox.publish();
    }
  });
  int last = 0;
  while (last < kLast) {
    const std::array<int, 64>& newest = mailbox.newest();
    const int value = newest[0];
    EXPECT_GE(value, last);
    for (const int one : newest) EXPECT_EQ(one, value);
    last = value;
    if (::testing::Test::HasFailure()) break;
  }
  writer.join();
}

}  // namespace
}  // namespace robot::foreseeing
