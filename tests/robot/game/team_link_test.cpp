// The link over loopback: a GameController and teammates that are sockets of the test.
#include "robot/game/team_link.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/support/eventually.h"

namespace robot::game {
namespace {

constexpr std::uint32_t kHere = 0x7f000001, kEverybodyHere = 0x7fffffff;

/// Returns the next packet at `socket`, or nothing if none comes within `patience_ns`.
std::optional<Datagram> next(UdpSocket& socket, std::uint64_t patience_ns = 60 * kSecond) {
  return socket.receive(monotonic_ns() + patience_ns);
}

struct Link : ::testing::Test {
  void open(TeamLinkOptions options) {
    options.team = 14;
    options.player = 3;
    options.broadcast = kEverybodyHere;
    options.port = mate->port();
    options.return_port = referee->port();
    auto opened = TeamLink::open(options, memory, clock, [this] {
      return std::optional<Endpoint>({kHere, referee->port()});
    });
    ASSERT_TRUE(opened) << opened.error();
    link = std::move(*opened);
  }

  void hear(pb::GameState::State state, std::uint32_t budget = 1200) {
    pb::GameState game;
    game.set_source(pb::GameState::SOURCE_GAME_CONTROLLER);
    game.set_packet_version(18);
    game.set_received_ns(clock.now_ns());
    game.set_state(state);
    game.set_half(1);
    game.set_seconds_remaining(600);
    game.set_players_per_team(7);
    for (int i = 0; i < 7; ++i) game.mutable_own()->add_players();
    game.mutable_own()->set_message_budget(budget);
    memory.game.write(game, clock.now_ns());
  }

  /// Sends from a teammate until `done`, because UDP may lose packets.
  template <class Done>
  void say_until(const std::string& bytes, Done&& done) {
    EXPECT_TRUE(tests::eventually([&] {
      EXPECT_TRUE(mate->send({kEverybodyHere, mate->port()}, bytes));
      std::this_thread::sleep_for(std::chrono::milliseconds(30));  // the pace of the packets
      return done();
    }));
  }

  SessionClock clock;
  memory::Memory memory{"14/3", clock};
  Result<UdpSocket> referee = UdpSocket::open(kHere, 0);
  Result<UdpSocket> mate = UdpSocket::open(0, 0);  // shares the team's port with the link; each receives every packet
  std::unique_ptr<TeamLink> link;
};

TEST_F(Link, AnswersTheGameControllerOnceASecond) {
  pb::Pose pose;
  pose.set_x(1);
  memory.pose.write(pose, clock.now_ns());
  hear(pb::GameState::STATE_INITIAL);
  const std::uint64_t before_ns = monotonic_ns();
  open({.return_packets = true});
  const auto first = next(*referee);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->bytes.size(), 32u);
  EXPECT_EQ(first->bytes.substr(0, 7), "RGrt\x04\x03\x0e");
  ASSERT_TRUE(next(*referee));
  EXPECT_GT(monotonic_ns() - before_ns, kSecond / 2) << "since the link was opened, for two answers";
}

TEST_F(Link, SendsNothingThatItsOptionsDoNotAskFor) {
  hear(pb::GameState::STATE_PLAYING);
  open({});
  EXPECT_FALSE(next(*mate, kSecond / 2));
  EXPECT_FALSE(next(*referee, kSecond / 2));
}

TEST_F(Link, ASilentGameControllerGetsNoAnswer) {
  open({.return_packets = true, .team_messages = true});
  EXPECT_FALSE(next(*referee, kSecond / 2));
}

TEST_F(Link, SendsTeamMessagesThatTheRulesAllow) {
  pb::Ball ball;
  ball.set_x(2);
  memory.ball.write(ball, clock.now_ns());
  hear(pb::GameState::STATE_PLAYING);
  pb::Strategy strategy;
  strategy.set_chosen(true);
  strategy.set_number(1);
  strategy.set_epoch(5);
  memory.strategy.write(strategy, clock.now_ns());
  open({.team_messages = true});
  const auto heard = next(*mate);
  ASSERT_TRUE(heard);
  EXPECT_LE(heard->bytes.size(), kMaxTeamMessageBytes);
  const Result<TeamMessage> message = parse_team_message(heard->bytes, clock.now_ns());
  ASSERT_TRUE(message) << message.error();
  EXPECT_EQ(message->team, 14u);
  EXPECT_EQ(message->player, 3u);
  EXPECT_FALSE(message->pose);
  EXPECT_EQ(message->strategy, 1);
  EXPECT_EQ(message->epoch, 5);
  EXPECT_NEAR(message->ball->x(), 2, 0.001);
  EXPECT_FALSE(next(*mate, 2 * kSecond)) << "one in several seconds";
  ASSERT_TRUE(memory.team.read());
  EXPECT_EQ((*memory.team.read())->messages_sent(), 1u);
  EXPECT_EQ(link->stopped(), "") << "its own message does not count as another sender's";
}

TEST_F(Link, ReceivesItsTeammatesMessages) {
  open({.team_messages = true});
  TeamMessage message{
      .team = 14, .player = 5, .sender = 1, .fallen = true, .strategy = 2, .epoch = 9, .pose = pb::Pose()};
  message.pose->set_x(-2);
  say_until(to_bytes(message, clock.now_ns()),
            [&] { return memory.team.read() && (*memory.team.read())->teammates_size() == 1; });
  const auto team = memory.team.read();
  EXPECT_EQ((*team)->teammates(0).player(), 5u);
  EXPECT_NEAR((*team)->teammates(0).pose().x(), -2, 0.001);
  EXPECT_FALSE((*team)->teammates(0).has_ball());
  EXPECT_TRUE((*team)->teammates(0).fallen());
  EXPECT_EQ((*team)->teammates(0).strategy(), 2u);
  EXPECT_EQ((*team)->teammates(0).epoch(), 9u);
  EXPECT_TRUE((*team)->teammates(0).active());
}

TEST_F(Link, StopsWhenAnotherProgramSendsWithOurNumber) {
  hear(pb::GameState::STATE_PLAYING);
  open({.return_packets = true, .team_messages = true});
  say_until(to_bytes({.team = 14, .player = 3, .sender = 1}, clock.now_ns()), [&] { return !link->stopped().empty(); });
  EXPECT_EQ(link->stopped(),
            "sending has stopped: " + text_of({kHere, mate->port()}) + " also sends as our player; only one of us may");
  while (next(*referee, kSecond / 10)) {
  }
  EXPECT_FALSE(next(*referee, 2 * kSecond)) << "no answers either";
}

TEST_F(Link, StopsWhenTheTeamsOwnFrameworkSends) {
  open({.team_messages = true});
  say_until("a message of another framework", [&] { return !link->stopped().empty(); });
  EXPECT_EQ(link->stopped(),
            "sending has stopped: another program of this robot also sends as our player; only one of us may");
}

TEST_F(Link, StopsWhenTheBudgetFallsTooFast) {
  hear(pb::GameState::STATE_PLAYING, 1200);
  open({.return_packets = true, .team_messages = true});
  ASSERT_TRUE(next(*referee)) << "the link has read the first budget before it answers";
  hear(pb::GameState::STATE_PLAYING, 1100);
  ASSERT_TRUE(tests::eventually([&] { return !link->stopped().empty(); }));
  EXPECT_NE(link->stopped().find("message budget fell by 100"), std::string::npos) << link->stopped();
}

}  // namespace
}  // namespace robot::game
