// Packets that are really sent to a multicast group over the loopback interface become worlds.
#include "robot/truth/feeds/ssl_vision_feed.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "robot/core/files.h"
#include "tests/robot/truth/feeds/ssl_packets.h"

namespace robot::truth {
namespace {

/// A program that sends to the group over the loopback interface.
class Sender {
 public:
  explicit Sender(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    ip_mreqn over{};
    over.imr_ifindex = static_cast<int>(::if_nametoindex("lo"));
    EXPECT_EQ(::setsockopt(socket_.get(), IPPROTO_IP, IP_MULTICAST_IF, &over, sizeof over), 0);
    to_.sin_family = AF_INET;
    to_.sin_port = htons(port);
  }
  void send(const std::string& bytes, const char* address = "224.5.23.2") {
    ::inet_pton(AF_INET, address, &to_.sin_addr);
    const auto* const generic = reinterpret_cast<const sockaddr*>(&to_);
    EXPECT_EQ(::sendto(socket_.get(), bytes.data(), bytes.size(), 0, generic, sizeof to_),
              static_cast<ssize_t>(bytes.size()));
  }

 private:
  const FileDescriptor socket_;
  sockaddr_in to_{};
};

struct SslVisionOnTheNetwork : testing::Test {
  const SessionClock clock{5 * kSecond};
  Result<SslVisionFeed> feed = SslVisionFeed::open({.port = 0, .interface = "lo"}, {}, clock);

  void SetUp() override { ASSERT_TRUE(feed) << feed.error(); }
};

TEST_F(SslVisionOnTheNetwork, APacketIsReceivedWithItsTimeOnOurClock) {
  Sender sender(feed->port());
  const std::uint64_t before_ns = clock.now_ns();
  sender.send(tests::PacketFrame{.latency = 0.25, .balls = {{.x = 1500}}}.bytes());
  const auto world = feed->next();
  const std::uint64_t after_ns = clock.now_ns();
  ASSERT_TRUE(world) << world.error();
  EXPECT_FLOAT_EQ(world->truth.ball().x(), 1.5F);
  // the system clock, in which the kernel counts, may be adjusted meanwhile
  EXPECT_GE(world->capture_ns + 250 * kMillisecond + kMillisecond, before_ns);
  EXPECT_LE(world->capture_ns + 250 * kMillisecond, after_ns + kMillisecond);
  EXPECT_EQ(feed->counts().packets, 1u);
}

TEST_F(SslVisionOnTheNetwork, WorldsComeInTheirOrderAndWrongPacketsBetweenThemAreLeftOut) {
  Sender sender(feed->port());
  for (std::uint32_t i = 1; i <= 20; ++i) {
    sender.send("noise");
    sender.send(
        tests::PacketFrame{.frame = i, .sent = 5000.0 + i, .balls = {{.x = 100.0F * static_cast<float>(i)}}}.bytes());
  }
  for (int i = 1; i <= 20; ++i) {
    const auto world = feed->next();
    ASSERT_TRUE(world) << world.error();
    EXPECT_FLOAT_EQ(world->truth.ball().x(), 0.1F * static_cast<float>(i));
  }
  EXPECT_EQ(feed->counts().unreadable, 20u);
}

TEST_F(SslVisionOnTheNetwork, ASecondWithoutPacketsIsAnError) {
  const auto world = feed->next();
  ASSERT_FALSE(world);
  EXPECT_EQ(world.error(),
            "SSL-Vision 224.5.23.2:" + std::to_string(feed->port()) + ": expected packets, got none for a second");
}

TEST_F(SslVisionOnTheNetwork, ASecondWithoutImagesNamesTheFault) {
  Sender sender(feed->port());
  sender.send("noise");
  sender.send("hello");
  const auto world = feed->next();
  ASSERT_FALSE(world);
  EXPECT_EQ(world.error(), "SSL-Vision 224.5.23.2:" + std::to_string(feed->port()) +
                               ": expected images, got packets of no use for a second; the last one: expected a packet "
                               "of SSL-Vision, got 5 other bytes");
}

TEST_F(SslVisionOnTheNetwork, AnotherGroupOnTheSamePortIsNotReceived) {
  auto other = SslVisionFeed::open({.group = "224.5.23.9", .port = feed->port(), .interface = "lo"}, {}, clock);
  ASSERT_TRUE(other) << other.error();
  Sender sender(feed->port());
  sender.send(tests::PacketFrame{.balls = {{.x = 100}}}.bytes(), "224.5.23.9");
  sender.send(tests::PacketFrame{.frame = 2, .sent = 5001, .balls = {{.x = 200}}}.bytes());
  EXPECT_FLOAT_EQ(feed->next()->truth.ball().x(), 0.2F);
  EXPECT_FLOAT_EQ(other->next()->truth.ball().x(), 0.1F);
  EXPECT_EQ(feed->counts().packets, 1u);
}

TEST(SslVisionFeed, ListensOnAllInterfacesWithoutAName) {
  const SessionClock clock;
  auto feed = SslVisionFeed::open({.port = 0}, {}, clock);
  ASSERT_TRUE(feed) << feed.error();
  Sender(feed->port()).send(tests::PacketFrame{}.bytes());
  EXPECT_TRUE(feed->next());
}

TEST(SslVisionFeed, AWrongAddressIsRefused) {
  const SessionClock clock;
  const auto refusal = [&](const MulticastAddress& address) { return SslVisionFeed::open(address, {}, clock).error(); };
  EXPECT_EQ(refusal({.group = "192.168.1.1"}),
            "SSL-Vision: expected a multicast address 224.0.0.0 .. 239.255.255.255, got '192.168.1.1'");
  EXPECT_EQ(refusal({.group = "vision"}),
            "SSL-Vision: expected a multicast address 224.0.0.0 .. 239.255.255.255, got 'vision'");
  EXPECT_EQ(refusal({.port = 0, .interface = "moon0"}),
            "SSL-Vision: expected a network interface, none is called 'moon0'");
}

}  // namespace
}  // namespace robot::truth
