// The helper of the examples in C, which is also C++.
#include "sim/guest/examples/soccer.h"

#include <gtest/gtest.h>

#include <random>

namespace {

constexpr int kPlayers = 5;

ForesightPlayer facts(int player) {
  ForesightPlayer facts{};
  facts.player = player, facts.players = kPlayers;
  facts.field_length = 9, facts.field_width = 6, facts.goal_width = 1.5f;
  facts.walk_forward = 0.25f, facts.walk_sideward = 0.18f, facts.walk_turn = 1.2f;
  facts.kick_count = 2;
  facts.kicks[0] = {"long", 0.18f, 0.05f, 0.04f, 0.03f, 0.65f, 1.6f, 5, 0};
  facts.kicks[1] = {"quick", 0.18f, 0.05f, 0.04f, 0.03f, 0.2f, 0.8f, 2, 0};
  return facts;
}

/// A moment in play: nobody was heard or seen, the ball is at that place in the frame of the robot.
ForesightMoment moment(Point ball) {
  ForesightMoment moment{};
  moment.now = 3000, moment.phase = FORESIGHT_PLAYING, moment.ball_seen = 3000;
  moment.ball_x = ball.x, moment.ball_y = ball.y;
  for (ForesightMate& mate : moment.mates) mate.sent = FORESIGHT_NEVER;
  for (ForesightOpponent& opponent : moment.opponents) opponent.seen = FORESIGHT_NEVER;
  return moment;
}

SoccerMemory fresh() { return {FORESIGHT_SUPPORTER, 1, FORESIGHT_NEVER}; }

TEST(Soccer, TheWayRoundACircleStaysOutside) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> metres(-2, 2);
  int round = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point centre = point(metres(random), metres(random)), target = point(metres(random), metres(random));
    if (size(centre) < 0.5f || size(minus(target, centre)) < 0.5f) continue;
    const Point step = round_circle(centre, 0.5f, target);
    const float along = within(dot(centre, step) / dot(step, step), 0, 1);
    EXPECT_GE(size(minus(centre, times(along, step))), 0.499f) << i;
    round += step.x != target.x;
  }
  EXPECT_GT(round, 50);
}

TEST(Soccer, ATeamThatHearsEachOtherHasOneChaserAndOneDefender) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> metres(-3, 3), seconds(1, 20);
  for (int i = 0; i < 200; ++i) {
    ForesightMate team[kPlayers + 1] = {};
    for (ForesightMate& mate : team)
      mate = {3000, metres(random), metres(random), 0, 0, 0, FORESIGHT_NEVER, seconds(random), FORESIGHT_SUPPORTER, 1};
    int count[4] = {};
    for (int player = 1; player <= kPlayers; ++player) {
      const ForesightPlayer me = facts(player);
      ForesightMoment now = moment(point(1, 0));
      now.x = team[player].x, now.y = team[player].y;
      for (int other = 1; other <= kPlayers; ++other)
        if (other != player) now.mates[other - 1] = team[other];
      // as the teammates heard it
      Sight sight = look(&me, &now);
      sight.ball = point(team[player].time_to_ball * me.walk_forward, 0), sight.ball_distance = sight.ball.x;
      sight.ball_in_team = point(sight.place.x - 1, sight.place.y);
      sight.goal = add(sight.ball_in_team, point(1, 0));
      SoccerMemory memory = fresh();
      ForesightCommand command{};
      ++count[settle_role(&sight, &memory, &command)];
      EXPECT_EQ(command.role, memory.role);
      EXPECT_NEAR(command.time_to_ball, team[player].time_to_ball, 1e-3f);
    }
    EXPECT_EQ(count[FORESIGHT_KEEPER], 1);
    EXPECT_EQ(count[FORESIGHT_CHASER], 1) << i;
    EXPECT_EQ(count[FORESIGHT_DEFENDER], 1) << i;
    EXPECT_EQ(count[FORESIGHT_SUPPORTER], 2) << i;
  }
}

TEST(Soccer, TheChaserKeepsTheBallUntilAnotherIsClearlyQuicker) {
  const ForesightPlayer me = facts(2);
  ForesightMoment now = moment(point(1, 0));
  const auto role = [&](int32_t before, float lead) {
    const Sight alone = look(&me, &now);
    now.mates[2] = {3000, 0, 0, 0, 0, 0, FORESIGHT_NEVER, time_to_ball(&alone) - lead, FORESIGHT_SUPPORTER, 1};
    const Sight sight = look(&me, &now);
    SoccerMemory memory = fresh();
    memory.role = before;
    ForesightCommand command{};
    return settle_role(&sight, &memory, &command);
  };
  EXPECT_EQ(role(FORESIGHT_CHASER, 0.8f), FORESIGHT_CHASER);
  EXPECT_NE(role(FORESIGHT_CHASER, 1.2f), FORESIGHT_CHASER);
  EXPECT_NE(role(FORESIGHT_SUPPORTER, 0.8f), FORESIGHT_CHASER);
}

TEST(Soccer, KicksABallInTheGateAndWalksBehindAnyOther) {
  const ForesightPlayer me = facts(2);
  const auto asked = [&](Point ball) {
    const ForesightMoment now = moment(ball);
    const Sight sight = look(&me, &now);
    SoccerMemory memory = fresh();
    ForesightCommand command{};
    kick_to(&sight, &memory, sight.goal, 0, 0.3f, 2, &command);
    return command;
  };
  const ForesightCommand left = asked(point(0.18f, 0.05f)), right = asked(point(0.18f, -0.05f));
  EXPECT_EQ(left.body, FORESIGHT_KICK);
  EXPECT_EQ(left.kick, 1) << "the quickest that carries 2 m";
  EXPECT_TRUE(left.kick_left);
  EXPECT_EQ(right.body, FORESIGHT_KICK);
  EXPECT_FALSE(right.kick_left);
  EXPECT_EQ(asked(point(0.25f, 0.05f)).body, FORESIGHT_WALK_TO);
  // the place behind the ball: there the ball lies before the foot
  const ForesightCommand walks = asked(point(0.5f, 0.05f));
  EXPECT_NEAR(walks.x, 0.5f - 0.18f, 0.02f);
}

TEST(Soccer, WalksTowardsABallThatSeemsToLieFarAway) {
  const ForesightPlayer me = facts(2);
  const ForesightMoment now = moment(point(90, 120));
  const Sight sight = look(&me, &now);
  SoccerMemory memory = fresh();
  ForesightCommand command{};
  kick_to(&sight, &memory, sight.goal, 0, 0.3f, 2, &command);
  EXPECT_EQ(command.body, FORESIGHT_WALK_TO);
  EXPECT_NEAR(size(point(command.x, command.y)), kFarthest, 1e-3f);
  EXPECT_NEAR(command.y / command.x, 120.f / 90, 0.02f);
}

TEST(Soccer, ASupporterGoesWhereNobodyIs) {
  const ForesightPlayer me = facts(3);
  ForesightMoment now = moment(point(1, 0));
  now.opponents[1] = {2990, 0.7f, 1.9f};
  now.mates[3] = {2990, 0.7f, 1, 0, 0, 0, FORESIGHT_NEVER, 5, FORESIGHT_SUPPORTER, 1};
  const Sight sight = look(&me, &now);
  EXPECT_LT(place_in_space(&sight).y, -1);
}

TEST(Soccer, KeepsTheDistanceFromTheOpponentsKick) {
  const ForesightPlayer me = facts(3);
  for (const float y : {0.2f, 0.5f, -0.7f}) {
    ForesightMoment now = moment(point(0.3f, y));
    now.set_play = FORESIGHT_KICK_IN;
    const Sight sight = look(&me, &now);
    ForesightCommand command{};
    command.body = FORESIGHT_STAND;
    keep_clear(&sight, &command);
    ASSERT_EQ(command.body, FORESIGHT_WALK_TO);
    EXPECT_GT(size(minus(point(command.x, command.y), sight.ball)), 0.75f);
  }
}

}  // namespace
