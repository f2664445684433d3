#include "robot/game/return_packet.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "robot/core/clock.h"

namespace robot::game {
namespace {

/// The float at byte `at`, as the GameController reads it.
float float_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number |= std::uint32_t{static_cast<unsigned char>(bytes.at(at + i))} << (8 * i);
  return std::bit_cast<float>(number);
}

struct Answer : ::testing::Test {
  Answer() {
    pose.set_x(-3.2f);
    pose.set_y(1.5f);
    pose.set_heading(0.25f);
    ball.set_x(0.5f);
    ball.set_y(-0.1f);
    ball.set_seen_ns(100 * kSecond);
    motion.set_fall(pb::MotionStatus::FALL_FALLEN);
  }
  RobotStatus status() const {
    return {.team = 14, .player = 3, .motion = &motion, .pose = &pose, .ball = &ball, .now_ns = 102 * kSecond};
  }
  pb::MotionStatus motion;
  pb::Pose pose;
  pb::Ball ball;
};

TEST_F(Answer, Has32BytesSince2022) {
  for (std::uint32_t version = 14; version <= 20; ++version) {
    const std::string packet = return_packet(version, status()).value();
    ASSERT_EQ(packet.size(), 32u);
    EXPECT_EQ(packet.substr(0, 8), std::string("RGrt\x04\x03\x0e\x01"));
    EXPECT_FLOAT_EQ(float_at(packet, 8), -3200);
    EXPECT_FLOAT_EQ(float_at(packet, 12), 1500);
    EXPECT_FLOAT_EQ(float_at(packet, 16), 0.25f);
    EXPECT_FLOAT_EQ(float_at(packet, 20), 2);
    EXPECT_FLOAT_EQ(float_at(packet, 24), 500);
    EXPECT_FLOAT_EQ(float_at(packet, 28), -100);
  }
}

TEST_F(Answer, MarksUnknownValues) {
  const std::string packet = return_packet(18, {.team = 14, .player = 3}).value();
  EXPECT_EQ(packet[7], '\0') << "not known to have fallen";
  EXPECT_EQ(float_at(packet, 20), -1) << "never saw the ball";
  for (std::size_t at : {8u, 12u, 16u, 24u, 28u}) EXPECT_EQ(float_at(packet, at), 0);
}

// the GameController drops packets with such values
TEST_F(Answer, HoldsFiniteNumbersOnly) {
  pose.set_heading(std::numeric_limits<float>::quiet_NaN());
  ball.set_x(std::numeric_limits<float>::infinity());
  const std::string packet = return_packet(18, status()).value();
  for (std::size_t at = 8; at < 32; at += 4) EXPECT_TRUE(std::isfinite(float_at(packet, at)));
  EXPECT_EQ(float_at(packet, 20), -1);
}

TEST_F(Answer, IsASignOfLifeBefore2022) {
  for (std::uint32_t version : {9u, 10u})
    EXPECT_EQ(return_packet(version, status()), std::string("RGrt\x02\x0e\x03\x02"));
  for (std::uint32_t version : {11u, 12u, 13u})
    EXPECT_EQ(return_packet(version, status()), std::string("RGrt\x03\x0e\x03\x00", 8));
}

TEST_F(Answer, IsAbsentForUnknownFormatsAndThoseWithAnotherPort) {
  for (std::uint32_t version : {0u, 7u, 8u, 21u}) EXPECT_FALSE(return_packet(version, status()));
}

}  // namespace
}  // namespace robot::game
