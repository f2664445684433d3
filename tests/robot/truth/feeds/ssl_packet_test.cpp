// A packet is read with every field that counts. Anything else is refused with one sentence.
#include "robot/truth/feeds/ssl_packet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "tests/robot/truth/feeds/ssl_packets.h"

namespace robot::truth {
namespace {

using tests::PacketFrame;

/// A packet that protoc encoded from the published .proto: every field of a detection, and a geometry with a line, an arc
/// and a camera.
constexpr std::string_view kPublished =
    "0aac0108f0a2041100001040fc54d94119cdcc1040fc54d94120032a200d0000403f105a1d00509a4425009029c42d000070"
    "41350040a0433d0040704332250d0000003f10021d00007ac4250000fa432d0000c03f35000020413d0000a0414500000c43"
    "3a250d0000803f100f1d00007a452500803bc52d000050c0350000f0413d0000204245000016433a190d0000803e1d000020"
    "41250000a041350000803f3d0000004041000000000000294012a1010a6408e05d10a84618880e20b40128ac0232240a0354"
    "6f70120a0d0000803f15000000401a0a0d000040401500008040250000204128023a250a0143120a0d000000001500000000"
    "1d0000fa4325000000002dc3f5c8403500002041380140880e750000ac4112390803150000fa431d0000c34325000091432d"
    "cdcccc3d350000803f3d0000000045000000004d00000000550000803f5d0000004065000040401802";

std::string published_packet() {
  std::string bytes;
  for (std::size_t i = 0; i < kPublished.size(); i += 2)
    bytes.push_back(static_cast<char>(std::stoi(std::string(kPublished.substr(i, 2)), nullptr, 16)));
  return bytes;
}

std::string refusal_of(const std::string& bytes) {
  const auto packet = read_ssl_packet(bytes, {});
  return packet ? "" : packet.error();
}

TEST(SslPacket, OfThePublishedFormatIsReadWithAllItsFields) {
  const auto packet = read_ssl_packet(published_packet(), {.yellow = 7, .blue = 8});
  ASSERT_TRUE(packet) << packet.error();
  ASSERT_TRUE(packet->view);
  const SslView& view = *packet->view;
  EXPECT_EQ(view.camera, 3u);
  EXPECT_EQ(view.frame, 70000u);
  EXPECT_EQ(view.sent, 1700000000.2625);
  EXPECT_NEAR(static_cast<double>(view.latency_ns), 12.5e6, 300);  // as exact as a double of today's seconds is
  ASSERT_EQ(view.balls.size(), 1u);
  EXPECT_EQ(view.balls[0].x, 1.2345);
  EXPECT_EQ(view.balls[0].y, -0.67825);
  EXPECT_EQ(view.balls[0].confidence, 0.75);
  ASSERT_EQ(view.robots.size(), 3u);
  EXPECT_EQ(view.robots[0].team, 7u);
  EXPECT_EQ(view.robots[0].player, 2u);
  EXPECT_EQ(view.robots[0].x, -1);
  EXPECT_EQ(view.robots[0].y, 0.5);
  EXPECT_EQ(view.robots[0].heading, 1.5);
  EXPECT_EQ(view.robots[0].confidence, 0.5);
  EXPECT_EQ(view.robots[1].team, 8u);
  EXPECT_EQ(view.robots[1].player, 15u);
  EXPECT_EQ(view.robots[1].x, 4);
  EXPECT_EQ(view.robots[1].y, -3);
  EXPECT_NEAR(*view.robots[1].heading, -3.25 + 2 * M_PI, 1e-12);
  EXPECT_EQ(view.robots[2].team, 8u);
  EXPECT_EQ(view.robots[2].player, std::nullopt);
  EXPECT_EQ(view.robots[2].heading, std::nullopt);
  EXPECT_EQ(packet->warning, "");
  ASSERT_TRUE(packet->field);
  EXPECT_EQ(packet->field->length, 12);
  EXPECT_EQ(packet->field->width, 9);
  EXPECT_EQ(packet->field->border, 0.3);
}

TEST(SslPacket, AnIdThatIsNoPlayerIsReportedAndTheRobotHasNoPlayer) {
  for (const std::uint32_t id : {0u, 21u, 4'000'000'000u}) {
    const auto packet = read_ssl_packet(PacketFrame{.blue = {{.id = id}}}.bytes(), {});
    ASSERT_TRUE(packet) << packet.error();
    EXPECT_EQ(packet->view->robots[0].player, std::nullopt);
    EXPECT_EQ(packet->warning, "camera 0, robots_blue[0].robot_id: expected a player 1 .. 20, got " +
                                   std::to_string(id) + "; this robot has no number");
  }
  for (const std::uint32_t id : {1u, 20u})
    EXPECT_EQ(read_ssl_packet(PacketFrame{.yellow = {{.id = id}}}.bytes(), {})->view->robots[0].player, id);
}

TEST(SslPacket, AWrongNumberIsNamed) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refusal_of(PacketFrame{.balls = {{}, {.x = nan}}}.bytes()),
            "camera 0, frame 1, balls[1].x: expected -50000 .. 50000 [mm], got nan");
  EXPECT_EQ(refusal_of(PacketFrame{.balls = {{.y = 50001}}}.bytes()),
            "camera 0, frame 1, balls[0].y: expected -50000 .. 50000 [mm], got 50001");
  EXPECT_EQ(refusal_of(PacketFrame{.yellow = {{.x = -infinite}}}.bytes()),
            "camera 0, frame 1, robots_yellow[0].x: expected -50000 .. 50000 [mm], got -inf");
  EXPECT_EQ(refusal_of(PacketFrame{.camera = 2, .frame = 9, .blue = {{.orientation = nan}}}.bytes()),
            "camera 2, frame 9, robots_blue[0].orientation: expected -1000 .. 1000 [rad], got nan");
  EXPECT_EQ(refusal_of(PacketFrame{.blue = {{.confidence = nan}}}.bytes()),
            "camera 0, frame 1, robots_blue[0].confidence: expected -1e+06 .. 1e+06, got nan");
  EXPECT_EQ(refusal_of(PacketFrame{.latency = -0.5}.bytes()),
            "camera 0, frame 1: expected t_sent 0 .. 10 s after t_capture, got -0.5");
  EXPECT_EQ(refusal_of(PacketFrame{.latency = 11}.bytes()),
            "camera 0, frame 1: expected t_sent 0 .. 10 s after t_capture, got 11");
  EXPECT_EQ(refusal_of(PacketFrame{.camera = 64}.bytes()), "camera_id: expected 0 .. 63, got 64");
}

TEST(SslPacket, AConfidenceAboveOneCountsAsOne) {
  const auto packet = read_ssl_packet(PacketFrame{.balls = {{.confidence = 3}, {.confidence = -1}}}.bytes(), {});
  ASSERT_TRUE(packet) << packet.error();
  EXPECT_EQ(packet->view->balls[0].confidence, 1);
  EXPECT_EQ(packet->view->balls[1].confidence, 0);
}

TEST(SslPacket, TooManyThingsAreRefused) {
  PacketFrame frame{.balls = std::vector<tests::PacketBall>(64), .yellow = std::vector<tests::PacketRobot>(64)};
  EXPECT_EQ(refusal_of(frame.bytes()), "");
  frame.yellow.emplace_back();
  EXPECT_EQ(refusal_of(frame.bytes()), "camera 0, frame 1: expected at most 64 robots_yellow, got 65");
}

TEST(SslPacket, OtherBytesAreRefused) {
  EXPECT_EQ(refusal_of("hello"), "expected a packet of SSL-Vision, got 5 other bytes");
  EXPECT_EQ(refusal_of(""), "expected a packet with a detection or a geometry, got 0 bytes without");
  EXPECT_EQ(refusal_of(tests::message_field(1, tests::uint_field(1, 5))),
            "expected a whole detection, it lacks t_capture, t_sent, camera_id");
}

TEST(SslPacket, AGeometryOfAnotherFormatDoesNotSpoilTheDetection) {
  // until 2014 the first number was the width of the lines
  const auto packet = read_ssl_packet(PacketFrame{}.bytes() + tests::field_packet(10, 6050, 250), {});
  ASSERT_TRUE(packet) << packet.error();
  EXPECT_TRUE(packet->view);
  EXPECT_FALSE(packet->field);
  const auto incomplete = read_ssl_packet(PacketFrame{}.bytes() + tests::message_field(2, ""), {});
  ASSERT_TRUE(incomplete) << incomplete.error();
  EXPECT_FALSE(incomplete->field);
}

TEST(SslPacket, EveryTruncationAndEveryFlippedByteIsReadOrRefusedWithASentence) {
  const std::string whole = published_packet();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto packet = read_ssl_packet(whole.substr(0, size), {});
    EXPECT_TRUE(packet || !packet.error().empty());
  }
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const int change : {0x01, 0x80, 0xff}) {
      std::string bytes = whole;
      bytes[i] = static_cast<char>(bytes[i] ^ change);
      const auto packet = read_ssl_packet(bytes, {});
      EXPECT_TRUE(packet || !packet.error().empty());
    }
}

}  // namespace
}  // namespace robot::truth
