#include "robot/memory/time_shift.h"

#include <gtest/gtest.h>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/camera.pb.h"
#include "proto/foresight/runtime.pb.h"
#include "proto/foresight/team.pb.h"
#include "robot/core/clock.h"
#include "robot/core/json_library.h"
#include "robot/memory/schema.h"

namespace robot::memory {
namespace {

constexpr std::uint64_t kNow = 1'700'000'000 * kSecond;
constexpr std::int64_t kBy = -350'000'000;

template <class Message>
Message moved(const Message& message, std::int64_t by_ns = kBy) {
  TimeShift shift({.topic = "/14/2/x", .schema = schema_of(*Message::descriptor())}, by_ns);
  Message result;
  EXPECT_TRUE(result.ParseFromString(shift.moved(message.SerializeAsString(), kNow)));
  return result;
}

TEST(TimeShift, MovesTimesAndNothingElse) {
  foresight::Ball ball;
  ball.set_seen_ns(kNow - kSecond);
  ball.set_x(1.5f);
  foresight::Ball expected = ball;
  expected.set_seen_ns(kNow - kSecond - 350'000'000);
  EXPECT_EQ(moved(ball).SerializeAsString(), expected.SerializeAsString());
}

TEST(TimeShift, LeavesDurationsAndMonotonicTimes) {
  foresight::ClockSample sample;
  sample.set_monotonic_ns(5000 * kSecond);
  sample.set_system_ns(kNow);
  sample.set_offset_ns(70);
  sample.set_round_trip_ns(900);
  foresight::ClockSample expected = sample;
  expected.set_system_ns(kNow - 350'000'000);
  EXPECT_EQ(moved(sample).SerializeAsString(), expected.SerializeAsString());
}

TEST(TimeShift, AShiftAndItsReverseGiveTheOriginalBytes) {
  foresight::Team team;
  for (int player : {1, 3}) {
    auto& mate = *team.add_teammates();
    mate.set_received_ns(kNow - static_cast<std::uint64_t>(player) * kSecond);
  }
  EXPECT_EQ(moved(team).teammates(1).received_ns(), kNow - 3 * kSecond - 350'000'000);
  EXPECT_EQ(moved(moved(team), -kBy).SerializeAsString(), team.SerializeAsString());
}

TEST(TimeShift, LeavesBytesThatItCannotReadUnchanged) {
  TimeShift json({.topic = "/x", .message_encoding = "json"}, kBy);
  EXPECT_EQ(json.moved("{\"seen_ns\": 5}", kNow), "{\"seen_ns\": 5}");
  TimeShift broken({.topic = "/x", .schema = {.name = "a.B", .encoding = "protobuf", .bytes = "no"}}, kBy);
  EXPECT_EQ(broken.moved("bytes", kNow), "bytes");
  TimeShift ball({.topic = "/x", .schema = schema_of(*foresight::Ball::descriptor())}, kBy);
  EXPECT_EQ(ball.moved("\xff\xff", kNow), "\xff\xff");
  EXPECT_EQ(ball(kNow), kNow - 350'000'000);
}

}  // namespace
}  // namespace robot::memory
