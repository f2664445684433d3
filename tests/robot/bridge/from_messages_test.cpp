#include "robot/bridge/from_messages.h"

#include <gtest/gtest.h>

#include "sim/match/hash.h"
#include "sim/referee/referee.h"
#include "tests/robot/bridge/played.h"

namespace robot::bridge {
namespace {

using test::Played;

sim::foresight::Knowledge known(const Played& game, const Recollection& from) {
  const auto knowledge = knowledge_of(from, game.setup.params);
  if (!knowledge) {
    ADD_FAILURE() << knowledge.error();
    return {};
  }
  return *knowledge;
}
std::string why_not(const Played& game, const Recollection& from) {
  const auto knowledge = knowledge_of(from, game.setup.params);
  return knowledge ? "" : knowledge.error();
}

TEST(Knowledge, ThroughMemoryEqualsThatOfTheSimulatedRobot) {
  // of a simulation that runs fast, too, whose capture times lie close together
  for (const auto& [seconds, speed] : {std::pair{20.f, 1.}, {60.f, 10.}, {80.f, 1.}, {200.f, 1.}, {333.f, 0.5}}) {
    Played game("match", seconds);
    game.timeline.speed = speed;
    game.write();
    const auto direct = sim::foresight::knowledge_of(game.setup.params, game.state, 1);
    const auto told = known(game, game.recollection());
    const auto age = [](sim::Tick now, sim::Tick then) {
      return then == sim::kNever ? -1 : static_cast<int>(now - then);
    };

    EXPECT_LT(sim::distance(told.beliefs.pose.pose.position, direct.beliefs.pose.pose.position), 1e-5f);
    EXPECT_NEAR(told.beliefs.pose.deviation, direct.beliefs.pose.deviation, 1e-5);
    if (direct.beliefs.ball.seen != sim::kNever) {
      EXPECT_LT(sim::distance(told.beliefs.ball.position, direct.beliefs.ball.position), 1e-5f);
      EXPECT_NEAR(told.beliefs.ball.variance, direct.beliefs.ball.variance, 1e-4f * direct.beliefs.ball.variance);
      EXPECT_EQ(age(told.now, told.beliefs.ball.seen), age(direct.now, direct.beliefs.ball.seen));
    }
    for (int i = 0; i < sim::agent::kMaxMates; ++i) {
      const sim::agent::Mate &a = told.beliefs.mates[i], &b = direct.beliefs.mates[i];
      EXPECT_EQ(age(told.now, a.sent), age(direct.now, b.sent)) << i;
      if (b.sent == sim::kNever) continue;
      EXPECT_EQ(a.ball_age, b.ball_age);
      EXPECT_EQ(a.role, b.role);
      EXPECT_LT(sim::distance(a.pose.position, b.pose.position), 1e-5f);
      if (b.ball_age != 0xffff) {
        EXPECT_LT(sim::distance(a.ball, b.ball), 1e-4f);
      }
    }
    for (int i = 0; i < sim::kMaxPlayers; ++i) {
      EXPECT_EQ(age(told.now, told.beliefs.opponents[i].seen), age(direct.now, direct.beliefs.opponents[i].seen));
      EXPECT_LT(sim::distance(told.beliefs.opponents[i].position, direct.beliefs.opponents[i].position), 1e-5f);
    }
    EXPECT_EQ(told.game.phase, direct.game.phase);
    EXPECT_EQ(told.game.set_play, direct.game.set_play);
    const bool counts =
        sim::referee::countdown_of(game.setup.params.rules, direct.game.phase, direct.game.set_play) > 0;
    EXPECT_NEAR(told.game.since_phase, counts ? direct.game.since_phase : 0, 1e-3);
    EXPECT_EQ(told.game.half, direct.game.half);
    EXPECT_EQ(told.game.own_score, direct.game.own_score);
    EXPECT_EQ(told.game.player, direct.game.player);
    EXPECT_NEAR(told.game.remaining, direct.game.remaining, 1e-3);
    for (const int side : {0, 1})
      for (int i = 0; i < sim::kMaxPlayers; ++i) EXPECT_NEAR(told.away[side][i], direct.away[side][i], 1);
  }
}

TEST(Knowledge, JerseyNumbersMakeNoDifference) {
  for (const float seconds : {60.f, 80.f, 200.f}) {
    const Played game("match", seconds);
    const auto believed = [&](const Recollection& from) {
      return sim::foresight::believe(game.setup.params, known(game, from));
    };
    const auto plain = believed(game.recollection()), numbered = believed(test::renumbered(game.recollection()));
    EXPECT_EQ(numbered.refusal, plain.refusal);
    EXPECT_EQ(sim::hash_of(numbered.situation.state), sim::hash_of(plain.situation.state));
  }
}

TEST(Knowledge, ASubstituteHasNoForecast) {
  const Played game;
  Recollection from = test::renumbered(game.recollection());
  from.game->value.set_own_player(5);
  EXPECT_EQ(why_not(game, from), "player 5 does not play: players are 9, 12, 14, 20");
}

TEST(Knowledge, APlaceOfAnIncompleteTeamStaysEmpty) {
  const Played game;
  Recollection from = test::renumbered(game.recollection());
  from.game->value.mutable_opponent()->mutable_players(19)->set_penalty(pb::PlayerState::PENALTY_SUBSTITUTE);
  EXPECT_EQ(known(game, from).away[1][3], sim::kNever);
}

TEST(Knowledge, CountdownsGiveTheDurationOfASetPlay) {
  auto prepared = sim::io::prepare({.rules = "spl2025"});
  ASSERT_TRUE(prepared) << prepared.error();
  const Played game;
  Recollection from = game.recollection();
  pb::GameState& told = from.game->value;
  const auto since = [&] { return knowledge_of(from, prepared->params)->game; };
  told.set_state(pb::GameState::STATE_PLAYING);
  told.set_set_play(pb::GameState::SET_PLAY_KICK_IN);
  told.set_secondary_seconds(5);
  EXPECT_FLOAT_EQ(since().since_phase, 25) << "of 30 s";
  told.clear_set_play();
  told.set_kicking_team(14);
  EXPECT_EQ(since().set_play, sim::agent::Game::SetPlay::kick_off) << "the ball is not free yet";
  EXPECT_FLOAT_EQ(since().since_phase, 5) << "of 10 s";
  told.set_secondary_seconds(0);
  EXPECT_EQ(since().set_play, sim::agent::Game::SetPlay::none);
  told.set_state(pb::GameState::STATE_READY);
  told.set_secondary_seconds(44);
  EXPECT_FLOAT_EQ(since().since_phase, 1) << "of 45 s";
}

TEST(Knowledge, OutsideOfPlayThereIsNoForecast) {
  const Played game;
  Recollection from = game.recollection();
  from.game->value.set_phase(pb::GameState::PHASE_PENALTY_SHOOT_OUT);
  EXPECT_EQ(why_not(game, from), "the game is in a penalty shoot-out");
  from.game->value.set_phase(pb::GameState::PHASE_TIMEOUT);
  EXPECT_EQ(why_not(game, from), "the game is in a time-out");
}

TEST(Knowledge, LaterMessagesAreNotRecollected) {
  const Played game;
  const Recollection before = recollect(game.channels, "14/2", game.now_ns() - 5'000'000'000);
  EXPECT_FALSE(before.ball || before.pose || before.game || before.team);
  EXPECT_TRUE(game.recollection().pose);
}

TEST(Knowledge, NamesTheMissingObject) {
  const Played game;
  Recollection from = game.recollection();
  from.game.reset();
  EXPECT_EQ(why_not(game, from), "the robot does not know of a game: there is no object game yet");
  from = game.recollection();
  from.pose.reset();
  EXPECT_EQ(why_not(game, from), "the robot does not know where it is: there is no object pose yet");
  from = game.recollection();
  from.now_ns += 7'200'000'000;
  EXPECT_EQ(why_not(game, from), "the robot does not know where it is: its pose is 7 s old");
  // all else may be absent
  Recollection least{.now_ns = game.now_ns()};
  least.game = game.recollection().game;
  least.pose = game.recollection().pose;
  EXPECT_EQ(why_not(game, least), "");
}

TEST(Knowledge, NotANumberDoesNoHarm) {
  const Played game;
  Recollection from = game.recollection();
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  from.ball.emplace();
  from.ball->value.set_x(nan);
  from.ball->value.set_velocity_y(inf);
  from.ball->value.set_deviation(nan);
  from.ball->value.set_seen_ns(from.now_ns + 1'000'000'000'000);
  from.game->value.set_seconds_remaining(-inf);
  from.game->value.mutable_own()->mutable_players(0)->set_penalised(true);
  from.game->value.mutable_own()->mutable_players(0)->set_seconds_till_unpenalised(nan);
  const auto knowledge = known(game, from);
  EXPECT_EQ(knowledge.beliefs.ball.position, sim::Vec2{});
  EXPECT_EQ(knowledge.beliefs.ball.seen, kNow);
  EXPECT_EQ(knowledge.game.remaining, 0);
  EXPECT_EQ(knowledge.away[0][0], 1u);
}

TEST(Knowledge, WithoutATrackerOpponentsComeFromTheVision) {
  const Played game("perfect");
  Recollection from = game.recollection();
  from.opponents.reset();
  from.vision.emplace();
  from.vision->capture_ns = from.now_ns - 1'000'000'000;
  const auto add = [&](float x, float y, pb::VisualRobot::Side side) {
    pb::VisualRobot& robot = *from.vision->value.add_robots();
    robot.mutable_detection()->set_x(x);
    robot.mutable_detection()->set_y(y);
    robot.set_side(side);
  };
  add(1, 0.5f, pb::VisualRobot::SIDE_OPPONENT);
  add(1.2f, 0.4f, pb::VisualRobot::SIDE_UNSPECIFIED);  // a second time
  add(2.5f, -1, pb::VisualRobot::SIDE_UNSPECIFIED);
  add(0.5f, 0, pb::VisualRobot::SIDE_OWN);
  const auto knowledge = known(game, from);
  const sim::Pose2 own = knowledge.beliefs.pose.pose;
  int seen = 0;
  for (const sim::agent::Opponent& opponent : knowledge.beliefs.opponents) {
    if (opponent.seen == sim::kNever) continue;
    ++seen;
    EXPECT_EQ(kNow - opponent.seen, sim::ticks(1));
    const sim::Vec2 at = sim::turned_back(opponent.position - own.position, sim::direction(own.heading));
    EXPECT_GT(at.x, 0.9f);
  }
  EXPECT_EQ(seen, 2);
  EXPECT_EQ(knowledge.beliefs.opponents[0].seen, sim::kNever) << "the keeper's place is filled last";
}

TEST(Knowledge, AMotionThatHasBegunContinues) {
  const Played game;
  const sim::motion::Model& model = game.setup.params.teams[0].models.motion;
  Recollection from = game.recollection();
  from.motion->value.Clear();
  from.motion->value.set_running(model.kicks[0].name);
  from.motion->value.set_remaining(model.kicks[0].duration - 0.2f);
  EXPECT_EQ(known(game, from).body.doing, sim::Body::Doing::kicking);
  EXPECT_EQ(known(game, from).body.since, kNow - sim::ticks(0.2f));
  from.motion->value.Clear();
  from.motion->value.set_walking(true);
  from.motion->value.set_velocity_x(99);
  EXPECT_EQ(known(game, from).body.doing, sim::Body::Doing::walking);
  EXPECT_EQ(known(game, from).body.velocity.x, model.walk.forward) << "no robot is faster than its limit";
  from.motion->value.set_fall(pb::MotionStatus::FALL_FALLEN);
  EXPECT_EQ(known(game, from).body.doing, sim::Body::Doing::fallen);
}

TEST(Knowledge, ARobotOnTheGroundKnowsItsSide) {
  const Played game;
  Recollection from = game.recollection();
  from.motion.emplace();
  for (const auto fall : {pb::MotionStatus::FALL_FALLEN, pb::MotionStatus::FALL_GETTING_UP})
    for (const auto& [side, lying] : {std::pair{pb::MotionStatus::FALL_SIDE_BACK, sim::Lying::on_back},
                                      {pb::MotionStatus::FALL_SIDE_FRONT, sim::Lying::on_front},
                                      {pb::MotionStatus::FALL_SIDE_LEFT, sim::Lying::on_left},
                                      {pb::MotionStatus::FALL_SIDE_RIGHT, sim::Lying::on_right},
                                      {pb::MotionStatus::FALL_SIDE_UNSPECIFIED, sim::Lying::on_back}}) {
      from.motion->value.set_fall(fall);
      from.motion->value.set_fall_side(side);
      EXPECT_EQ(sim::Lying{known(game, from).body.kind}, lying) << side;
    }
}

TEST(Knowledge, ARobotReportedOrSeenOnTheGroundLies) {
  const Played game;
  Recollection from = game.recollection();
  ASSERT_GT(from.team->value.teammates_size(), 0);
  pb::Teammate& mate = *from.team->value.mutable_teammates(0);
  const auto lies = [&](int side, std::uint32_t player) { return known(game, from).down[side][player - 1] != 0; };
  EXPECT_FALSE(lies(0, mate.player()));
  mate.set_fallen(true);
  EXPECT_TRUE(lies(0, mate.player()));

  from.opponents.reset();
  from.vision.emplace(Remembered<pb::Vision>{.value = {}, .capture_ns = from.now_ns});
  pb::VisualRobot& seen = *from.vision->value.add_robots();
  seen.mutable_detection()->set_x(1);
  seen.set_side(pb::VisualRobot::SIDE_OPPONENT);
  seen.set_player(3);
  EXPECT_FALSE(lies(1, 3));
  seen.set_fallen(true);
  EXPECT_EQ(known(game, from).down[1][2], kNow);
}

}  // namespace
}  // namespace robot::bridge
