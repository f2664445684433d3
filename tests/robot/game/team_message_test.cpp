#include "robot/game/team_message.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "robot/core/clock.h"

namespace robot::game {
namespace {

constexpr std::uint64_t kNow = 1'700'000'000 * kSecond;

TeamMessage message() {
  TeamMessage message{.team = 14,
                      .player = 3,
                      .sender = 0xdead'beef,
                      .fallen = true,
                      .strategy = 3,
                      .epoch = 201,
                      .pose = pb::Pose(),
                      .ball = pb::Ball()};
  message.pose->set_x(-4.321f);
  message.pose->set_y(2.5f);
  message.pose->set_heading(-3.1f);
  message.pose->set_deviation_x(0.25f);
  message.pose->set_deviation_y(0.125f);
  message.pose->set_deviation_heading(1.8f);
  message.ball->set_x(1.25f);
  message.ball->set_y(-0.5f);
  message.ball->set_velocity_x(2);
  message.ball->set_velocity_y(-0.75f);
  message.ball->set_deviation(0.3f);
  message.ball->set_seen_ns(kNow - 1500 * kMillisecond);
  return message;
}

TEST(TeamMessage, ArrivesAsItWasSent) {
  const std::string bytes = to_bytes(message(), kNow);
  EXPECT_EQ(bytes.size(), 38u);
  EXPECT_LE(bytes.size(), kMaxTeamMessageBytes);
  const std::uint64_t arrival = kNow + 77 * kSecond;  // by another robot's clock
  const Result<TeamMessage> read = parse_team_message(bytes, arrival);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->team, 14u);
  EXPECT_EQ(read->player, 3u);
  EXPECT_EQ(read->sender, 0xdead'beefu);
  EXPECT_TRUE(read->fallen);
  EXPECT_EQ(read->strategy, 3);
  EXPECT_EQ(read->epoch, 201);
  ASSERT_TRUE(read->pose && read->ball);
  EXPECT_NEAR(read->pose->x(), -4.321, 0.001);
  EXPECT_NEAR(read->pose->y(), 2.5, 0.001);
  EXPECT_NEAR(read->pose->heading(), -3.1, 0.0001);
  EXPECT_NEAR(read->pose->deviation_x(), 0.25, 0.001);
  EXPECT_NEAR(read->pose->deviation_y(), 0.125, 0.001);
  EXPECT_NEAR(read->pose->deviation_heading(), 1.8, 0.0001);
  EXPECT_NEAR(read->ball->x(), 1.25, 0.001);
  EXPECT_NEAR(read->ball->y(), -0.5, 0.001);
  EXPECT_NEAR(read->ball->velocity_x(), 2, 0.001);
  EXPECT_NEAR(read->ball->velocity_y(), -0.75, 0.001);
  EXPECT_NEAR(read->ball->deviation(), 0.3, 0.001);
  EXPECT_EQ(read->ball->seen_ns(), arrival - 1500 * kMillisecond);
}

TEST(TeamMessage, LeavesOutUnknownValues) {
  TeamMessage unknown{.team = 14, .player = 3, .pose = pb::Pose()};
  unknown.pose->set_x(std::numeric_limits<float>::quiet_NaN());
  const Result<TeamMessage> read = parse_team_message(to_bytes(unknown, kNow), kNow);
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->pose);
  EXPECT_FALSE(read->ball);
}

TEST(TeamMessage, ClampsLargeValuesToTheirBounds) {
  TeamMessage far{.player = 1, .pose = pb::Pose(), .ball = pb::Ball()};
  far.pose->set_x(1e30f);
  far.pose->set_deviation_x(1e30f);
  const Result<TeamMessage> read = parse_team_message(to_bytes(far, kNow), kNow);
  EXPECT_NEAR(read->pose->x(), 32.767, 0.001);
  EXPECT_NEAR(read->pose->deviation_x(), 65.535, 0.001);
  EXPECT_EQ(read->ball->seen_ns(), kNow - 65'535 * kMillisecond) << "a ball that was never seen has the greatest age";
}

TEST(TeamMessage, RefusesEveryTruncationAndLongerMessages) {
  const std::string bytes = to_bytes(message(), kNow);
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(parse_team_message(bytes.substr(0, size), kNow));
  EXPECT_EQ(parse_team_message(bytes + "x", kNow).error(),
            "team message: expected 38 bytes that begin with FSgt, got 39 bytes");
}

TEST(TeamMessage, RefusesMessagesOfOtherPrograms) {
  std::string bytes = to_bytes(message(), kNow);
  bytes[4] = 1;
  EXPECT_EQ(parse_team_message(bytes, kNow).error(), "team message: expected version 2, got 1");
  bytes = to_bytes(message(), kNow);
  bytes[6] = 0;
  EXPECT_EQ(parse_team_message(bytes, kNow).error(),
            "team message: expected player 1 .. 20 and flags 0 .. 7, got player 0 and flags 7");
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string noise(random() % 130, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    EXPECT_FALSE(parse_team_message(noise, kNow));
  }
}

}  // namespace
}  // namespace robot::game
