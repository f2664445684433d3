// Packets of all cameras become worlds with our times. Old packets are dropped, a restart is not.
#include "robot/truth/feeds/ssl_vision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "robot/core/clock.h"
#include "tests/robot/truth/feeds/ssl_packets.h"

namespace robot::truth {
namespace {

using tests::PacketFrame;

constexpr std::uint64_t kStartNs = 1'700'000'000 * kSecond;

struct SslVisionPackets : testing::Test {
  SslVision vision{{.yellow = 14, .blue = 5}};

  /// Sends a packet that arrives `ms` after the start. It must be readable.
  std::optional<TimedTruth> take(const PacketFrame& frame, std::uint64_t ms) {
    auto world = vision.take(frame.bytes(), kStartNs + ms * kMillisecond);
    EXPECT_TRUE(world) << world.error();
    return *std::move(world);
  }
};

TEST_F(SslVisionPackets, TheCaptureTimeIsTheTimeOfArrivalMinusTheirDelay) {
  const auto world = take({.sent = 5000, .latency = 0.008, .balls = {{.x = 1000}}}, 20);
  ASSERT_TRUE(world);
  EXPECT_NEAR(static_cast<double>(world->capture_ns - kStartNs), 12e6, 10);
  EXPECT_EQ(world->truth.detected_ns(), kStartNs + 20 * kMillisecond);
  EXPECT_FLOAT_EQ(world->truth.ball().x(), 1);
}

TEST_F(SslVisionPackets, TeamsHaveTheNumbersOfTheOptions) {
  const auto world = take({.yellow = {{.id = 1, .x = 1000}}, .blue = {{.id = 2, .x = -1000}}}, 0);
  ASSERT_TRUE(world);
  ASSERT_EQ(world->truth.robots_size(), 2);
  EXPECT_EQ(world->truth.robots(0).team(), 14u);
  EXPECT_EQ(world->truth.robots(1).team(), 5u);
}

TEST_F(SslVisionPackets, AWorldIsCompleteWhenEachCameraHasSentOne) {
  EXPECT_TRUE(take({.camera = 0, .frame = 1}, 0));
  EXPECT_FALSE(take({.camera = 1, .frame = 1, .yellow = {{.id = 1, .x = 1000}}}, 8));  // now there are two
  const auto first = take({.camera = 0, .frame = 2, .sent = 5000.016, .yellow = {{.id = 1, .x = 1020}, {.id = 2}}}, 16);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->truth.robots_size(), 2);
  EXPECT_EQ(first->truth.robots(0).sensors(), 2u);
  EXPECT_FLOAT_EQ(first->truth.robots(0).x(), 1.01F);
  EXPECT_NEAR(static_cast<double>(first->capture_ns - kStartNs), 8e6, 10);  // that of the newest image
  for (std::uint32_t i = 3; i < 20; ++i) {
    const double sent = 5000 + 0.016 * i;
    EXPECT_FALSE(take({.camera = 1, .frame = i, .sent = sent}, 16 * i - 8));
    EXPECT_TRUE(take({.camera = 0, .frame = i, .sent = sent}, 16 * i));
  }
}

TEST_F(SslVisionPackets, CamerasInStepArePairedWithTheirImagesOfTheSameMoment) {
  for (std::uint32_t i = 1; i < 20; ++i) {
    const double sent = 5000 + 0.016 * i;
    const auto early = take({.camera = 0, .frame = i, .sent = sent, .yellow = {{.id = 1}}}, 16 * i);
    EXPECT_EQ(early.has_value(), i <= 2) << i;  // only until it is known that there are two
    const auto both = take({.camera = 1, .frame = i, .sent = sent, .blue = {{.id = 1}}}, 16 * i + 1);
    ASSERT_EQ(both.has_value(), i > 1) << i;
    EXPECT_TRUE(!both || both->truth.robots_size() == 2) << i;
  }
}

TEST_F(SslVisionPackets, ThreeCamerasOutOfStepMakeOneWorldPerTurn) {
  int worlds = 0;
  for (std::uint32_t i = 1; i <= 60; ++i)
    for (std::uint32_t camera = 0; camera < 3; ++camera)
      worlds += take({.camera = camera, .frame = i, .sent = 5000 + 0.018 * i}, 18 * i + 6 * camera).has_value();
  EXPECT_GE(worlds, 59);
  EXPECT_LE(worlds, 61);
}

TEST_F(SslVisionPackets, ThingsOfACameraThatMissedAnImageAreMissing) {
  take({.camera = 0, .frame = 1}, 0);
  take({.camera = 1, .frame = 1}, 8);
  ASSERT_TRUE(take({.camera = 0, .frame = 2, .sent = 5000.016}, 16));
  EXPECT_FALSE(take({.camera = 0, .frame = 3, .sent = 5000.032, .balls = {{.x = 500}}}, 32));
  const auto world = take({.camera = 0, .frame = 4, .sent = 5000.048, .balls = {{.x = 600}}}, 48);
  ASSERT_TRUE(world);
  EXPECT_FLOAT_EQ(world->truth.ball().x(), 0.5F);
  EXPECT_EQ(world->truth.ball().sensors(), 1u);
}

TEST_F(SslVisionPackets, ImagesOfOneWorldAreNotFartherApartThan50Ms) {
  take({.camera = 0, .frame = 1}, 0);
  EXPECT_FALSE(take({.camera = 1, .frame = 1, .balls = {{.x = 100}}}, 10));
  const auto world = take({.camera = 0, .frame = 2, .sent = 5000.070, .balls = {{.x = 110}}}, 70);
  ASSERT_TRUE(world);
  EXPECT_FLOAT_EQ(world->truth.ball().x(), 0.1F);
  EXPECT_EQ(world->truth.ball().sensors(), 1u);
}

TEST_F(SslVisionPackets, ACameraThatIsSilentForASecondIsNotWaitedFor) {
  take({.camera = 1, .frame = 1}, 0);
  take({.camera = 0, .frame = 1}, 1);
  std::uint32_t frame = 1;
  for (std::uint64_t ms = 16; ms < 1100; ms += 16) take({.camera = 0, .frame = ++frame, .sent = 5000.0 + frame}, ms);
  const auto world = take({.camera = 0, .frame = ++frame, .sent = 5000.0 + frame, .balls = {{.x = 700}}}, 1120);
  ASSERT_TRUE(world);
  EXPECT_FLOAT_EQ(world->truth.ball().x(), 0.7F);  // of this packet, not of the one before
}

TEST_F(SslVisionPackets, OldPacketsAreDroppedAndCounted) {
  EXPECT_TRUE(take({.frame = 10, .sent = 5000}, 0));
  EXPECT_FALSE(take({.frame = 9, .sent = 4999.98}, 1));
  EXPECT_FALSE(take({.frame = 10, .sent = 5000}, 2));  // twice
  EXPECT_TRUE(take({.frame = 11, .sent = 5000.016}, 16));
  EXPECT_EQ(vision.counts().old, 2u);
  EXPECT_EQ(vision.counts().restarts, 0u);
  EXPECT_EQ(vision.counts().packets, 4u);
}

TEST_F(SslVisionPackets, ARestartOfSslVisionIsFollowedAtOnceAndReported) {
  EXPECT_TRUE(take({.frame = 90000, .sent = 5000}, 0));
  EXPECT_TRUE(take({.frame = 1, .sent = 5000.5}, 500));
  EXPECT_EQ(vision.counts().restarts, 1u);
  EXPECT_EQ(vision.counts().old, 0u);
  EXPECT_EQ(vision.warning(),
            "camera 0: frame 1 comes after frame 90000: SSL-Vision was started again, or two of them use this camera "
            "number");
  EXPECT_TRUE(take({.frame = 2, .sent = 5000.516}, 516));
  EXPECT_EQ(vision.warning(), "");
}

TEST_F(SslVisionPackets, AfterASecondOfSilenceAnyPacketIsTaken) {
  EXPECT_TRUE(take({.frame = 90000, .sent = 5000}, 0));
  EXPECT_FALSE(take({.frame = 1, .sent = 20}, 999));  // their clock was set back as well
  EXPECT_TRUE(take({.frame = 2, .sent = 20.016}, 1000));
}

TEST_F(SslVisionPackets, TheFieldIsKnownFromItsOwnPackets) {
  EXPECT_FALSE(vision.field());
  const auto nothing = vision.take(tests::field_packet(9000, 6000, 250), kStartNs);
  ASSERT_TRUE(nothing) << nothing.error();
  EXPECT_FALSE(*nothing);
  ASSERT_TRUE(vision.field());
  EXPECT_EQ(vision.field()->length, 9);
  const auto world = take({.balls = {{.x = 9000, .confidence = 1}, {.x = 100, .confidence = 0.2F}}}, 1);
  EXPECT_FLOAT_EQ(world->truth.ball().x(), 0.1F);
}

TEST_F(SslVisionPackets, WrongPacketsAreCountedAndHarmNothing) {
  EXPECT_FALSE(vision.take("no packet", kStartNs));
  EXPECT_FALSE(vision.take(PacketFrame{.balls = {{.x = NAN}}}.bytes(), kStartNs));
  EXPECT_EQ(vision.counts().unreadable, 2u);
  EXPECT_TRUE(take({}, 0));
}

TEST_F(SslVisionPackets, AnIdThatIsNoPlayerIsReported) {
  take({.blue = {{.id = 0}}}, 0);
  EXPECT_EQ(vision.warning(),
            "camera 0, robots_blue[0].robot_id: expected a player 1 .. 20, got 0; this robot has no number");
}

TEST_F(SslVisionPackets, AnyTimesAndNumbersAreSurvived) {
  std::mt19937 generator(1);
  const auto random = [&] { return static_cast<std::uint32_t>(generator()); };
  for (int i = 0; i < 5000; ++i) {
    const PacketFrame frame{.camera = random() % 70,
                            .frame = random() % 5 == 0 ? random() : random() % 50,
                            .sent = static_cast<double>(random() % 100) * (random() % 9 == 0 ? -1e300 : 1),
                            .balls = {{.x = static_cast<float>(random() % 100)}}};
    const std::uint64_t received_ns = random() % 7 == 0 ? ~std::uint64_t{0} - random() : random();
    static_cast<void>(vision.take(frame.bytes(), received_ns));
  }
  EXPECT_EQ(vision.counts().packets, 5000u);
}

}  // namespace
}  // namespace robot::truth
