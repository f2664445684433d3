// Real packets over loopback, from a socket that plays the GameController.
#include "robot/game/control_listener.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "robot/memory/memory.h"
#include "tests/support/control_packets.h"
#include "tests/support/eventually.h"

namespace robot::game {
namespace {

using tests::ControlPacketText;

constexpr std::uint32_t kLoopback = 0x7f000001;

struct Listening : ::testing::Test {
  /// Sends until the listener has counted one more packet: UDP may lose packets, even on loopback.
  void send(const std::string& bytes) { send(*referee, bytes); }
  void send(UdpSocket& sender, const std::string& bytes) {
    const std::uint64_t before = all();
    ASSERT_TRUE(tests::eventually([&] {
      EXPECT_TRUE(sender.send({kLoopback, listener->port()}, bytes));
      std::this_thread::sleep_for(std::chrono::milliseconds(20));  // the pace of the packets
      return all() != before;
    }));
  }
  std::uint64_t all() const {
    const ListenerCounts counts = listener->counts();
    return counts.told + counts.foreign + counts.second + counts.refused;
  }

  ManualClock clock{1'700'000'000 * kSecond};
  memory::Memory memory{"14/3", clock};
  Result<UdpSocket> referee = UdpSocket::open(kLoopback, 0);
  std::unique_ptr<ControlListener> listener =
      std::move(*ControlListener::open({.team = 14, .player = 3, .address = kLoopback, .port = 0}, memory.game, clock));
};

TEST_F(Listening, WritesThePacketsIntoMemory) {
  EXPECT_EQ(memory.game.read(), nullptr);
  EXPECT_FALSE(listener->game_controller());
  send(ControlPacketText{.state = 1}.bytes(18));
  ASSERT_TRUE(memory.game.read());
  EXPECT_EQ((*memory.game.read())->state(), pb::GameState::STATE_READY);
  EXPECT_EQ((*memory.game.read())->received_ns(), clock.now_ns());
  EXPECT_EQ(memory.game.read()->capture_ns(), clock.now_ns());
  EXPECT_EQ(listener->game_controller(), (Endpoint{kLoopback, referee->port()}));
}

TEST_F(Listening, TheFormatMayChangeFromPacketToPacket) {
  for (int version = 7; version <= 20; ++version) {
    send(ControlPacketText().bytes(version));
    EXPECT_EQ((*memory.game.read())->packet_version(), static_cast<std::uint32_t>(version));
  }
}

TEST_F(Listening, IgnoresGamesOfOtherTeams) {
  send(ControlPacketText{.first = {.number = 20}}.bytes(18));
  EXPECT_EQ(memory.game.read(), nullptr);
  EXPECT_GE(listener->counts().foreign, 1u);
  EXPECT_FALSE(listener->game_controller());
}

TEST_F(Listening, CountsRefusedPacketsAndContinues) {
  send("not a packet");
  send("");
  send(std::string(60'000, 'x'));
  EXPECT_EQ(memory.game.read(), nullptr);
  EXPECT_GE(listener->counts().refused, 3u);
  send(ControlPacketText().bytes(18));
  EXPECT_TRUE(memory.game.read());
}

TEST_F(Listening, FollowsTheFirstGameControllerUntilItIsSilent) {
  // all of 127.0.0.0/8 is this machine
  Result<UdpSocket> laptop = UdpSocket::open(kLoopback + 1, 0);
  const std::string first = "127.0.0.1:" + std::to_string(referee->port());
  const std::string second = "127.0.0.2:" + std::to_string(laptop->port());
  send(ControlPacketText{.state = 3}.bytes(18));
  EXPECT_EQ(listener->warning(), "");

  clock.set(clock.now_ns() + kFollowedSilenceNs - 1);
  send(*laptop, ControlPacketText{.state = 0}.bytes(18));
  EXPECT_EQ((*memory.game.read())->state(), pb::GameState::STATE_PLAYING);
  EXPECT_EQ(listener->game_controller(), (Endpoint{kLoopback, referee->port()}));
  EXPECT_GE(listener->counts().second, 1u);
  EXPECT_EQ(listener->warning(), "two GameControllers send for team 14: " + first + " is followed, " + second +
                                     " is ignored until the first is silent");

  send(ControlPacketText{.state = 3}.bytes(18));  // it was not silent for long enough
  clock.set(clock.now_ns() + kFollowedSilenceNs - 1);
  send(*laptop, ControlPacketText{.state = 0}.bytes(18));
  EXPECT_EQ((*memory.game.read())->state(), pb::GameState::STATE_PLAYING);

  clock.set(clock.now_ns() + kFollowedSilenceNs);
  EXPECT_EQ(listener->warning(), "") << "an old warning is gone";
  send(*laptop, ControlPacketText{.state = 0}.bytes(18));
  EXPECT_EQ((*memory.game.read())->state(), pb::GameState::STATE_INITIAL);
  EXPECT_EQ(listener->game_controller(), (Endpoint{kLoopback + 1, laptop->port()}));
}

TEST_F(Listening, FollowsARestartedGameControllerSooner) {
  Result<UdpSocket> again = UdpSocket::open(kLoopback, 0);
  send(ControlPacketText{.state = 3}.bytes(18));
  clock.set(clock.now_ns() + kRestartSilenceNs - 1);
  send(*again, ControlPacketText{.state = 1}.bytes(18));
  EXPECT_EQ((*memory.game.read())->state(), pb::GameState::STATE_PLAYING) << "both may be alive";
  clock.set(clock.now_ns() + 1);
  send(*again, ControlPacketText{.state = 1}.bytes(18));
  EXPECT_EQ((*memory.game.read())->state(), pb::GameState::STATE_READY);
}

TEST_F(Listening, AGameOfOtherTeamsDoesNotTakeThePlace) {
  Result<UdpSocket> other_field = UdpSocket::open(kLoopback, 0);
  send(*other_field, ControlPacketText{.first = {.number = 20}}.bytes(18));
  send(ControlPacketText{.state = 1}.bytes(18));
  EXPECT_EQ((*memory.game.read())->state(), pb::GameState::STATE_READY);
  EXPECT_EQ(listener->warning(), "");
}

TEST_F(Listening, ANewerFormatCountsAndIsNamed) {
  std::string bytes = ControlPacketText{.state = 3}.bytes(20);
  bytes[4] = 21;
  send(bytes);
  ASSERT_TRUE(memory.game.read());
  EXPECT_TRUE((*memory.game.read())->unreadable());
  EXPECT_EQ((*memory.game.read())->received_ns(), clock.now_ns());
  EXPECT_EQ(listener->warning(),
            "GameController format 21 is newer than this program (7 .. 20); it comes from 127.0.0.1:" +
                std::to_string(referee->port()) + ", and a match counts as in progress");
}

// the number of our team may be any byte of an unreadable packet: a readable GameController is followed instead
TEST_F(Listening, AReadableGameControllerIsPreferred) {
  Result<UdpSocket> newer = UdpSocket::open(kLoopback, 0);
  std::string bytes = ControlPacketText().bytes(20);
  bytes[4] = 21;
  send(*newer, bytes);
  send(ControlPacketText{.state = 1}.bytes(18));
  EXPECT_EQ((*memory.game.read())->state(), pb::GameState::STATE_READY);
  send(*newer, bytes);
  EXPECT_FALSE((*memory.game.read())->unreadable());
  EXPECT_GE(listener->counts().second, 1u);
}

TEST_F(Listening, SharesItsPortWithTheTeamsOwnFramework) { EXPECT_TRUE(UdpSocket::open(kLoopback, listener->port())); }

TEST_F(Listening, NamesThePortThatCannotBeOpened) {
  // an address that no machine has: TEST-NET-1
  const auto other = ControlListener::open({.address = *parse_address("192.0.2.1"), .port = 3838}, memory.game, clock);
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error(), "GameController: cannot listen on UDP 192.0.2.1:3838: Cannot assign requested address");
}

TEST(Address, IsReadAndWritten) {
  EXPECT_EQ(text_of({*parse_address("192.168.14.2"), 3838}), "192.168.14.2:3838");
  for (const char* wrong : {"", "localhost", "1.2.3", "1.2.3.4.5", "::1"})
    EXPECT_EQ(parse_address(wrong).error(),
              "address: expected one such as 192.168.14.2, got '" + std::string(wrong) + "'");
}

}  // namespace
}  // namespace robot::game
