#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/perception/scene.h"

namespace sim::perception {
namespace {

field::Rules rules_of(int players, int budget) {
  field::Rules rules{};
  rules.players = players;
  rules.message_budget = budget;
  rules.message_interval = 1;
  return rules;
}

/// Returns the number of packets of a team whose robots send as often as allowed, in a game of `duration` [s].
int play(const field::Rules& rules, float duration) {
  const Effects effects = all_effects();
  Tick due[kMaxPlayers] = {}, last[kMaxPlayers];
  std::fill_n(last, kMaxPlayers, kNever);
  int sent = 0;
  for (Tick now = 0; now < ticks(duration); ++now) {
    const float remaining = duration - static_cast<float>(now) * kTickDuration;
    for (int i = 0; i < rules.players; ++i) {
      if (now < due[i]) continue;
      if (last[i] != kNever) {
        EXPECT_GE(now - last[i], ticks(rules.message_interval));
      }
      last[i] = now;
      ++sent;
      due[i] = next_packet(rules, effects, now, sent, remaining);
    }
  }
  return sent;
}

TEST(Radio, SpendsTheBudgetEvenlyAndNeverMore) {
  for (const int players : {4, 5, 7}) {
    const int sent = play(rules_of(players, 1200), 1200);
    EXPECT_LE(sent, 1200 - 30 + players);
    EXPECT_GT(sent, 1100) << players;
  }
  // in a shorter game the interval is the limit
  EXPECT_NEAR(play(rules_of(4, 1200), 120), 4 * 120, 8);
}

TEST(Radio, WithoutABudgetOnlyTheIntervalLimits) { EXPECT_NEAR(play(rules_of(4, 0), 60), 4 * 60, 4); }

TEST(Radio, WithoutLimitsEveryDecisionIsSent) {
  Effects effects = all_effects();
  effects.packet_limit = false;
  EXPECT_EQ(next_packet(rules_of(4, 1200), effects, 99, 5000, 0), 100u);
}

TEST(Radio, ATeamWithoutBudgetIsSilent) {
  EXPECT_EQ(next_packet(rules_of(4, 1200), all_effects(), 99, 1200, 600), kNever);
}

TEST(Radio, APacketHoldsTheRobotsBeliefs) {
  agent::Beliefs beliefs;
  beliefs.pose.pose = {{1, 2}, kPi / 2};
  agent::Mind mind;
  mind.role = agent::Role::defender;
  mind.time_to_ball_cs = agent::centiseconds(4.5f);
  agent::Mate packet = packet_of(beliefs, mind, false, 100);
  EXPECT_EQ(packet.ball_age, 0xffff);

  beliefs.ball.position = {0.5f, 0.25f};
  beliefs.ball.seen = 70;
  packet = packet_of(beliefs, mind, false, 100);
  EXPECT_EQ(packet.pose, beliefs.pose.pose);
  EXPECT_NEAR(distance(packet.ball, {0.75f, 2.5f}), 0, 1e-6f);
  EXPECT_EQ(packet.ball_age, 30);
  EXPECT_EQ(packet.time_to_ball(), 4.5f);
  EXPECT_EQ(packet.role, static_cast<std::uint8_t>(agent::Role::defender));
  EXPECT_EQ(packet.sent, 100u);
  EXPECT_TRUE(packet.active);
  EXPECT_FALSE(packet_of(beliefs, mind, true, 100).active);
  EXPECT_EQ(packet_of(beliefs, mind, false, 1'000'000).ball_age, 0xfffe);
}

TEST(Radio, IsFiledUnderTheSender) {
  for (const Side side : {Side::home, Side::away})
    for (int receiver = 1; receiver <= kMaxPlayers; ++receiver) {
      agent::Beliefs beliefs;
      for (int sender = 1; sender <= kMaxPlayers; ++sender) {
        if (sender == receiver) continue;
        agent::Mate packet;
        packet.sent = static_cast<Tick>(sender);
        receive(packet, robot_of(side, sender), robot_of(side, receiver), beliefs);
      }
      for (int i = 0; i < agent::kMaxMates; ++i)
        EXPECT_EQ(beliefs.mates[i].sent, static_cast<Tick>(i + 1 < receiver ? i + 1 : i + 2));
    }
}

TEST(Radio, LosesPacketsIndependentlyForEachMate) {
  Scene scene;
  scene.model.radio.loss = 0.2f;
  const int packets = 5000;
  int lost[agent::kMaxMates] = {}, both[agent::kMaxMates][agent::kMaxMates] = {};
  for (int i = 0; i < packets; ++i) {
    ++scene.world.tick;
    const std::uint32_t deaf = transmit(scene.model, scene.effects, scene.world, 0).lost;
    EXPECT_EQ(deaf >> agent::kMaxMates, 0u);
    for (int one = 0; one < agent::kMaxMates; ++one) {
      lost[one] += deaf >> one & 1;
      for (int two = 0; two < one; ++two) both[one][two] += deaf >> one & deaf >> two & 1;
    }
  }
  for (int one = 0; one < agent::kMaxMates; ++one) {
    EXPECT_NEAR(static_cast<float>(lost[one]) / packets, 0.2f, 0.02f);
    for (int two = 0; two < one; ++two) EXPECT_NEAR(static_cast<float>(both[one][two]) / packets, 0.04f, 0.01f);
  }
  scene.effects.packet_loss = false;
  EXPECT_EQ(transmit(scene.model, scene.effects, scene.world, 0).lost, 0u);
}

TEST(Radio, DelaysAreExponentiallyDistributed) {
  Scene scene;
  scene.model.radio.delay = 0.5f;
  double sum = 0;
  int longer = 0;
  const int packets = 5000;
  for (int i = 0; i < packets; ++i) {
    ++scene.world.tick;
    const Tick delay = transmit(scene.model, scene.effects, scene.world, 2).delay;
    ASSERT_LE(delay, ticks(5 * 0.5f));
    sum += delay;
    longer += delay > 15 ? 1 : 0;
  }
  EXPECT_NEAR(sum / packets, 15, 0.7);
  EXPECT_NEAR(static_cast<double>(longer) / packets, std::exp(-15.5 / 15), 0.03);
  scene.effects.packet_delay = false;
  EXPECT_EQ(transmit(scene.model, scene.effects, scene.world, 2).delay, 0u);
}

}  // namespace
}  // namespace sim::perception
