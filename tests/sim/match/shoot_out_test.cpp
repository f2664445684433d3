#include "sim/match/shoot_out.h"

#include <gtest/gtest.h>

#include "sim/match/fields.h"
#include "tests/sim/support/games.h"

namespace sim {
namespace {

using End = PenaltyShot::End;
using referee::shoot_out::next;
using referee::shoot_out::Tally;
using referee::shoot_out::winner;
using test::setup_of;

field::Rules rules(int shots, int sudden) {
  field::Rules made = setup_of({.rules = "spl2025"}).params.rules;
  made.shoot_out_shots = shots, made.shoot_out_sudden_shots = sudden;
  return made;
}

/// Takes shots until the end; the results of each side are '1' goal, '0' none. Returns the number of shots.
int play_out(const field::Rules& rules, const char* home, const char* away, Tally& tally) {
  int shots = 0;
  while (const auto side = next(rules, tally)) {
    const int index = static_cast<int>(*side);
    tally.goals[index] += (index == 0 ? home : away)[tally.shots[index]++] == '1';
    ++shots;
  }
  return shots;
}

TEST(ShootOut, TheSidesShootInTurn) {
  for (const Side first : {Side::home, Side::away}) {
    Tally tally{.first = first};
    for (int shot = 0; shot < 6; ++shot) {
      const auto side = next(rules(3, 3), tally);
      ASSERT_TRUE(side);
      EXPECT_EQ(*side, shot % 2 == 0 ? first : other(first));
      ++tally.shots[static_cast<int>(*side)];
    }
  }
}

TEST(ShootOut, EndsAsSoonAsASideCannotCatchUp) {
  Tally tally;
  EXPECT_EQ(play_out(rules(5, 5), "111", "000", tally), 6) << "three behind with two shots left";
  EXPECT_EQ(winner(tally), Side::home);
  tally = {};
  EXPECT_EQ(play_out(rules(5, 5), "11110", "11100", tally), 10) << "the last shot could still have drawn";
  tally = {.first = Side::away};
  EXPECT_EQ(play_out(rules(3, 3), "00", "11", tally), 4);
  EXPECT_EQ(winner(tally), Side::away);
}

TEST(ShootOut, ADrawLeadsToSuddenDeathInPairs) {
  Tally tally;
  EXPECT_EQ(play_out(rules(3, 3), "10101", "01100", tally), 10) << "the second pair of the sudden death differs";
  EXPECT_EQ(winner(tally), Side::home);
  tally = {};
  EXPECT_EQ(play_out(rules(3, 3), "000000", "000000", tally), 12) << "no more than three pairs";
  EXPECT_EQ(winner(tally), std::nullopt);
  tally = {};
  EXPECT_EQ(play_out(rules(0, 0), "", "", tally), 0) << "rules without a shoot-out";
}

TEST(ShootOut, OneAttackerStandsAgainstOneKeeper) {
  const auto setup = setup_of({.rules = "spl2025"});
  for (const Side side : {Side::home, Side::away}) {
    const State state = penalty_shot(setup.params, {.seed = 4}, side);
    int on_field = 0;
    test::for_each_body(state.world, [&](int robot, const Body& body) {
      ++on_field;
      const bool attacks = robot == robot_of(side, 2);
      EXPECT_TRUE(attacks || robot == robot_of(other(side), 1)) << robot;
      EXPECT_NEAR(distance(body.position, state.world.ball.position), attacks ? kShotRun : 1.3f, 1e-5f);
    });
    EXPECT_EQ(on_field, 2);
    EXPECT_EQ(state.world.ball.position.x, attack_sign(state.world, side) * (4.5f - 1.3f));
    EXPECT_EQ(state.book.phase, agent::Game::Phase::playing);
    // nobody else enters until the end
    const State later = test::after(setup.params, state, ticks(setup.params.rules.shoot_out_duration));
    test::for_each_body(later.world, [&](int robot, const Body&) {
      EXPECT_TRUE(robot == robot_of(side, 2) || robot == robot_of(other(side), 1)) << robot;
    });
  }
}

TEST(ShootOut, AGoodAttackerBeatsAnIdleKeeperAndAnIdleOneNobody) {
  const auto attacks =
      setup_of({.rules = "spl2025", .strategies = {"baseline", "idle"}, .models = {"perfect", "perfect"}});
  const Tick longest = ticks(attacks.params.rules.shoot_out_duration);
  int goals = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PenaltyShot shot = play_shot(attacks.params, {.seed = seed}, Side::home);
    goals += shot.end == End::goal;
    EXPECT_LE(shot.ticks, longest);
    const PenaltyShot idle = play_shot(attacks.params, {.seed = seed}, Side::away);
    EXPECT_EQ(idle.end, End::time_up);
    EXPECT_EQ(idle.ticks, longest);
  }
  EXPECT_GE(goals, 12);
}

TEST(ShootOut, IsAFunctionOfParametersAndKey) {
  const auto setup = setup_of({.rules = "spl2025"});
  bool differ = false;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const ShootOut once = play_shoot_out(setup.params, {.seed = seed}),
                   again = play_shoot_out(setup.params, {.seed = seed});
    ASSERT_EQ(once.shots.size(), again.shots.size());
    int goals[2] = {0, 0};
    for (std::size_t i = 0; i < once.shots.size(); ++i) {
      EXPECT_EQ(once.shots[i].ticks, again.shots[i].ticks);
      EXPECT_EQ(once.shots[i].end, again.shots[i].end);
      goals[static_cast<int>(once.shots[i].side)] += once.shots[i].end == End::goal;
      differ |= once.shots[i].ticks != once.shots[0].ticks;
    }
    EXPECT_EQ(goals[0], once.tally.goals[0]);
    EXPECT_EQ(goals[1], once.tally.goals[1]);
    EXPECT_EQ(next(setup.params.rules, once.tally), std::nullopt);
  }
  EXPECT_TRUE(differ) << "each shot has its own luck";
}

}  // namespace
}  // namespace sim
