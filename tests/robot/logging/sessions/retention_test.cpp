#include "robot/logging/sessions/retention.h"

#include <gtest/gtest.h>

#include "robot/core/clock.h"
#include "tests/support/times.h"

namespace robot::logging {
namespace {

using tests::kHour, tests::kNow;

constexpr std::uint64_t kIn1970 = 300 * kSecond;

/// A session of ten minutes that ended `age_ns` before kNow, with files of that time.
Session session_of_age(std::uint64_t age_ns) {
  Session session{.folder = "logs/s", .info = {.number = 3, .boot = "before"}};
  session.end_ns = session.changed_ns = kNow - age_ns;
  session.start_ns = session.end_ns - 600 * kSecond;
  return session;
}

TEST(Retention, KeepsTheSessionsOfTheLastDay) {
  const Now now{.times_ns = {kNow}, .boot = "this"};
  EXPECT_FALSE(is_deletable(session_of_age(0), now));
  EXPECT_FALSE(is_deletable(session_of_age(24 * kHour - 1), now));
  EXPECT_TRUE(is_deletable(session_of_age(24 * kHour), now));
}

TEST(Retention, KeepsMarkedAndLiveSessions) {
  const Now now{.times_ns = {kNow}, .boot = "this"};
  Session session = session_of_age(48 * kHour);
  session.info.kept = true;
  EXPECT_FALSE(is_deletable(session, now));
  session.info.kept = false;
  session.state = SessionState::recording;
  EXPECT_FALSE(is_deletable(session, now));
}

// a robot without a network starts in 1970; the network sets its clock later
TEST(Retention, KeepsTheSessionsOfThisBootWithAnyClock) {
  Session session = session_of_age(0);
  session.start_ns = session.end_ns = session.changed_ns = kIn1970;
  session.info.boot = "this";
  EXPECT_FALSE(is_deletable(session, {.times_ns = {kNow}, .boot = "this"}));
  EXPECT_FALSE(is_deletable(session_of_age(0), {.times_ns = {kIn1970, kNow}, .boot = "this"}));
  EXPECT_TRUE(is_deletable(session, {.times_ns = {kNow}, .boot = "next"}));
}

TEST(Retention, ASessionThatIsYoungByOneClockStays) {
  Session session = session_of_age(48 * kHour);
  EXPECT_TRUE(is_deletable(session, {.times_ns = {kNow, kIn1970}, .boot = "this"}));
  EXPECT_FALSE(is_deletable(session, {.times_ns = {kNow, kNow - 47 * kHour}, .boot = "this"}));
  session.changed_ns = kNow - kHour;
  EXPECT_FALSE(is_deletable(session, {.times_ns = {kNow}, .boot = "this"})) << "its files are young";
}

// otherwise nothing could be deleted, and the recording would be refused
TEST(Retention, AnOldSessionIsDeletableWithAClockIn1970) {
  EXPECT_TRUE(is_deletable(session_of_age(40 * 24 * kHour), {.times_ns = {kIn1970}, .boot = "this"}));
}

TEST(Retention, AnUnknownBootIsNotThisBoot) {
  Session session = session_of_age(48 * kHour);
  session.info.boot = "";
  EXPECT_TRUE(is_deletable(session, {.times_ns = {kNow}, .boot = ""}));
}

TEST(Retention, TheOrderIsThatOfTheNumbersAndNotOfTheClock) {
  Session first = session_of_age(0), second = session_of_age(0);
  second.info.number = 4;
  second.start_ns = kIn1970;
  EXPECT_TRUE(is_older(first, second));
  EXPECT_FALSE(is_older(second, first));
  first.info.number = 0;
  first.start_ns = kNow + kHour;
  EXPECT_TRUE(is_older(first, second)) << "a session without a number is older";
  second.info.number = 0;
  EXPECT_TRUE(is_older(second, first)) << "without numbers the time decides";
}

}  // namespace
}  // namespace robot::logging
