#include "sim/foresight/situation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "sim/foresight/guess.h"
#include "sim/match/hash.h"
#include "sim/match/situation.h"
#include "tests/sim/support/fields.h"
#include "tests/sim/support/games.h"

namespace sim::foresight {
namespace {

using Phase = agent::Game::Phase;
using Doing = Body::Doing;

constexpr int kOwn = 1;  // home 2

/// A game with `models`, 20 s after its kick-off or later, with the ball on the field.
struct Fixture {
  io::PreparedGame setup;
  State state;

  explicit Fixture(const std::string& models = "match", std::uint64_t seed = 3)
      : setup(test::setup_of(test::choice_of("spl2012", "baseline", models))), state(test::begun(setup.params, seed)) {
    while (state.book.phase != Phase::playing || age(state.world.tick, state.book.phase_since) < 20 ||
           !field::inside_field(setup.params.rules.field, state.world.ball.position))
      state = test::after(setup.params, state, 1);
  }
  const Params& params() const { return setup.params; }
  Knowledge knowledge() const { return knowledge_of(setup.params, state, kOwn); }
};

TEST(Believe, WithFullKnowledgeBeliefEqualsTruth) {
  const Fixture game("perfect");
  const Believed believed = believe(game.params(), game.knowledge());
  ASSERT_EQ(believed.refusal, "");
  const World& is = game.state.world;
  const World& thought = believed.situation.state.world;
  // as it saw the ball with its last turn
  EXPECT_LT(distance(thought.ball.position, is.ball.position), 0.05f);
  for (int player = 1; player <= is.players; ++player) {
    const int mate = robot_of(Side::home, player);
    // a report has an error, so the guess is shifted towards the usual place; and the mate has walked on since
    const float drawn = mate == kOwn ? 0.05f : 0.12f;
    EXPECT_LT(distance(thought.bodies[mate].position, is.home_attacks * is.bodies[mate].position), drawn) << player;
  }
  EXPECT_EQ(believed.situation.state.book.score[0], game.state.book.score[0]);
  EXPECT_NEAR(static_cast<double>(believed.situation.state.book.clock), game.state.book.clock, 1);
  EXPECT_EQ(believed.situation.state.book.phase, Phase::playing);
}

TEST(Believe, TheSecondHalfLooksLikeTheFirstToTheRobot) {
  Fixture game;
  Knowledge knowledge = game.knowledge();
  const Believed first = believe(game.params(), knowledge);
  knowledge.game.half = 2;
  const Believed second = believe(game.params(), knowledge);
  EXPECT_EQ(second.situation.state.book.half, 2);
  EXPECT_EQ(second.situation.state.world.home_attacks, 1);
  EXPECT_EQ(second.situation.state.world.ball.position, first.situation.state.world.ball.position);
}

TEST(Believe, GivesTheReasonForARefusal) {
  const Fixture game;
  const auto why = [&](auto&& change) {
    Knowledge knowledge = game.knowledge();
    change(knowledge);
    return believe(game.params(), knowledge).refusal;
  };
  EXPECT_EQ(why([](Knowledge&) {}), "");
  EXPECT_EQ(why([](Knowledge& k) { k.game.phase = Phase::initial; }), "the game has not begun");
  EXPECT_EQ(why([](Knowledge& k) { k.game.phase = Phase::finished; }), "the game is over");
  EXPECT_EQ(why([](Knowledge& k) { k.game.player = 6; }), "player 6 does not play in such a game");
  EXPECT_EQ(why([](Knowledge& k) { k.beliefs.pose.deviation = 2.04f; }),
            "the robot does not know where it is: its position is off by 2.0 m");
  EXPECT_NE(why([](Knowledge& k) { k.beliefs.pose.deviation = NAN; }), "");
  const auto nobody_saw = [](Knowledge& k) {
    k.beliefs.ball.seen = kNever;
    for (agent::Mate& mate : k.beliefs.mates) mate.ball_age = 0xffff;
  };
  EXPECT_EQ(why(nobody_saw), "nobody has seen the ball yet");
  EXPECT_EQ(why([&](Knowledge& k) {
              nobody_saw(k);
              k.beliefs.ball.seen = k.now;
              k.now += ticks(31);
            }),
            "nobody has seen the ball for 31 s");
}

TEST(Believe, AnOldSightIsLessCertain) {
  const Fixture game;
  Knowledge knowledge = game.knowledge();
  const int mate = robot_of(Side::home, 3), opponent = robot_of(Side::away, 2);
  knowledge.beliefs.mates[1].sent = knowledge.beliefs.opponents[1].seen = knowledge.beliefs.ball.seen = knowledge.now;
  for (agent::Mate& told : knowledge.beliefs.mates) told.ball_age = 0xffff;
  const Doubt fresh = believe(game.params(), knowledge).situation.doubt;
  Doubt last = fresh;
  for (int seconds = 3; seconds < 30; seconds += 3) {
    Knowledge later = knowledge;
    later.now += ticks(static_cast<float>(seconds));
    const Doubt doubt = believe(game.params(), later).situation.doubt;
    EXPECT_GE(doubt.position[mate], last.position[mate]);
    EXPECT_GE(doubt.position[opponent], last.position[opponent]);
    EXPECT_GE(doubt.ball_elsewhere, last.ball_elsewhere);
    last = doubt;
  }
  EXPECT_EQ(fresh.ball_elsewhere, 0);
  EXPECT_GT(last.ball_elsewhere, 0.99f);
  EXPECT_GT(last.position[mate], fresh.position[mate]);
}

TEST(Believe, TheNewestReportCountsWhenOwnEyesAreOld) {
  const Fixture game;
  Knowledge knowledge = game.knowledge();
  knowledge.now += ticks(10);
  knowledge.beliefs.mates[1] = {.ball = {1.5f, -0.5f}, .sent = knowledge.now - ticks(1), .ball_age = 0};
  const BallGuess guess = guess_ball(kField2012, knowledge);
  EXPECT_EQ(guess.position, (Vec2{1.5f, -0.5f}));
  EXPECT_FALSE(guess.by_own_eyes);
}

TEST(Believe, AnUncertainVelocityIsReduced) {
  const Fixture game;
  Knowledge knowledge = game.knowledge();
  knowledge.beliefs.ball.seen = knowledge.now;
  knowledge.beliefs.ball.velocity = {1, 0};
  const auto guess_with = [&](float variance) {
    knowledge.beliefs.ball.velocity_variance = variance;
    return guess_ball(kField2012, knowledge);
  };
  EXPECT_FLOAT_EQ(length(guess_with(0).velocity), 1);
  EXPECT_EQ(guess_with(0).velocity_deviation, 0);
  EXPECT_FLOAT_EQ(length(guess_with(0.25f).velocity), 0.5f);  // as uncertain as balls in general
  EXPECT_LT(length(guess_with(1).velocity), 0.25f);
  EXPECT_LT(guess_with(1).velocity_deviation, 0.5f);  // never less certain than balls in general

  knowledge.beliefs.ball.velocity = {};
  EXPECT_LT(guess_with(0.25f).velocity_deviation, 0.2f);
}

TEST(Believe, OfUnseenOpponentsOneIsAtTheBallAndTheOthersDefend) {
  const Fixture game;
  Knowledge knowledge = game.knowledge();
  for (agent::Opponent& opponent : knowledge.beliefs.opponents) opponent = {};
  const Vec2 ball{1, 0.5f}, goal{game.params().rules.field.length / 2, 0};
  const auto place_of_player = [&](int player) {
    return guess_robot(game.params(), knowledge, ball, robot_of(Side::away, player)).pose.position;
  };
  int near = 0;
  for (int player = 2; player <= game.params().rules.players; ++player) {
    const Vec2 place = place_of_player(player);
    EXPECT_NEAR(cross(place - goal, ball - goal), 0, 1e-3f);  // on the way between ball and goal
    EXPECT_LT(distance(place, goal), distance(ball, goal));
    near += distance(place, ball) < 0.25f * distance(ball, goal) ? 1 : 0;
  }
  EXPECT_EQ(near, 1);
  EXPECT_LT(distance(place_of_player(1), goal), 0.8f);

  // the robot seen at the ball is the chaser
  knowledge.beliefs.opponents[3] = {.position = ball, .seen = knowledge.now};
  EXPECT_LT(distance(place_of_player(4), ball), 0.3f);
  EXPECT_GT(distance(place_of_player(2), ball), 0.3f);
}

TEST(Believe, APenalisedRobotComesBackWhenItsTimeIsUp) {
  const Fixture game;
  Knowledge knowledge = game.knowledge();
  knowledge.away[1][2] = ticks(12);
  knowledge.away[0][3] = kNever;
  const State state = believe(game.params(), knowledge).situation.state;
  const int opponent = robot_of(Side::away, 3), mate = robot_of(Side::home, 4);
  EXPECT_EQ(state.world.bodies[opponent].doing, Doing::removed);
  EXPECT_EQ(test::after(game.params(), state, ticks(11)).world.bodies[opponent].doing, Doing::removed);
  const State later = test::after(game.params(), state, ticks(13));
  EXPECT_NE(later.world.bodies[opponent].doing, Doing::removed);
  EXPECT_EQ(later.world.bodies[mate].doing, Doing::removed);
}

TEST(Believe, AFallenRobotLiesUntilItMustBeUpAgain) {
  const Fixture game;
  const motion::Falls& falls = game.params().teams[1].models.motion.falls;
  const int fallen = robot_of(Side::away, 3);
  const auto doing = [&](float seconds_ago) {
    Knowledge knowledge = game.knowledge();
    knowledge.down[1][2] = knowledge.now - ticks(seconds_ago);
    return believe(game.params(), knowledge).situation.state.world.bodies[fallen].doing;
  };
  EXPECT_EQ(doing(0), Doing::fallen);
  EXPECT_EQ(doing(falls.usual_time() - 0.1f), Doing::fallen);
  EXPECT_EQ(doing(falls.usual_time()), Doing::standing);

  // and gets up by itself
  Knowledge knowledge = game.knowledge();
  knowledge.down[1][2] = knowledge.now;
  const State start = sample(game.params(), believe(game.params(), knowledge).situation, {.seed = 1});
  EXPECT_TRUE(lies(test::after(game.params(), start, ticks(falls.lying)).world.bodies[fallen]));
  const float long_enough = 10 * falls.usual_time();
  EXPECT_FALSE(lies(test::after(game.params(), start, ticks(long_enough)).world.bodies[fallen]));
}

TEST(Believe, TheRobotKeepsItsKnowledge) {
  const Fixture game;
  const Knowledge knowledge = game.knowledge();
  const State state = believe(game.params(), knowledge).situation.state;
  const Robot& self = state.robots[kOwn];
  EXPECT_EQ(self.beliefs.ball.position, knowledge.beliefs.ball.position);
  EXPECT_EQ(self.beliefs.pose.pose, knowledge.beliefs.pose.pose);
  EXPECT_EQ(self.mind.role, knowledge.mind.role);
  EXPECT_EQ(state.world.bodies[kOwn].doing, knowledge.body.doing);
  EXPECT_EQ(state.world.bodies[kOwn].velocity, knowledge.body.velocity);
}

TEST(KnowledgeOf, IsTheSameFromBothSides) {
  const Fixture game;
  const Knowledge away = knowledge_of(game.params(), game.state, robot_of(Side::away, 2));
  EXPECT_EQ(away.game.own_score, game.state.book.score[1]);
  const Believed believed = believe(game.params(), away);
  EXPECT_EQ(believed.refusal, "");
  // its own side is home now, and attacks +x
  EXPECT_EQ(believed.situation.state.world.bodies[robot_of(Side::home, 2)].position, away.beliefs.pose.pose.position);
}

TEST(Tell, WithTheWholeTruthThereIsOneWorld) {
  const Fixture game;
  for (const Side own : {Side::home, Side::away}) {
    Situation situation = believe(game.params(), knowledge_of(game.params(), game.state, robot_of(own, 2))).situation;
    tell(game.state.world, own, {.ball = true, .own_side = true, .opponents = true}, situation);
    const float sign = attack_sign(game.state.world, own);
    for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{2}}) {
      const World world = sample(game.params(), situation, {.seed = seed}).world;
      for_each_robot(world.players, [&](int robot) {
        const Side side = side_of(robot) == Side::home ? own : other(own);
        const Body& is = game.state.world.bodies[robot_of(side, player_of(robot))];
        const Body& thought = world.bodies[robot];
        EXPECT_LT(distance(thought.position, sign * is.position), 1e-4f) << robot;
        EXPECT_LT(distance(thought.facing, sign * is.facing), 1e-3f) << robot;
        EXPECT_EQ(thought.doing, is.doing) << robot;
        EXPECT_EQ(thought.velocity, is.velocity) << robot;
      });
      EXPECT_EQ(world.ball.position, sign * game.state.world.ball.position);
      EXPECT_EQ(world.ball.velocity, sign * game.state.world.ball.velocity);
    }
  }
}

TEST(Tell, ChangesOnlyTheRevealedPart) {
  Fixture game;
  const Situation believed = believe(game.params(), game.knowledge()).situation;
  Situation situation = believed;
  tell(game.state.world, Side::home, {}, situation);
  EXPECT_EQ(hash_of(situation.state), hash_of(believed.state));

  tell(game.state.world, Side::home, {.opponents = true}, situation);
  EXPECT_EQ(situation.state.world.ball.position, believed.state.world.ball.position);
  EXPECT_EQ(situation.doubt.ball, believed.doubt.ball);
  for (int player = 1; player <= believed.state.world.players; ++player) {
    const int mate = robot_of(Side::home, player), opponent = robot_of(Side::away, player);
    EXPECT_EQ(situation.state.world.bodies[mate].position, believed.state.world.bodies[mate].position);
    EXPECT_EQ(situation.doubt.position[mate], believed.doubt.position[mate]);
    EXPECT_EQ(situation.state.world.bodies[opponent].position, game.state.world.bodies[opponent].position);
    EXPECT_EQ(situation.doubt.position[opponent], 0);
  }
}

TEST(Tell, ARobotOffTheFieldStaysThere) {
  Fixture game;
  const int gone = robot_of(Side::away, 3);
  game.state.world.bodies[gone].doing = Doing::removed;
  Situation situation = believe(game.params(), game.knowledge()).situation;
  const Vec2 believed = situation.state.world.bodies[gone].position;
  tell(game.state.world, Side::home, {.opponents = true}, situation);
  EXPECT_EQ(situation.state.world.bodies[gone].position, believed);
}

TEST(Sample, WithoutUncertaintyThereIsOneWorld) {
  const Fixture game;
  const Situation sure{.state = game.state, .doubt = {}};
  const State one = sample(game.params(), sure, {.seed = 1}), other = sample(game.params(), sure, {.seed = 2});
  for_each_robot(one.world.players, [&](int robot) {
    EXPECT_EQ(one.world.bodies[robot].position, game.state.world.bodies[robot].position);
    EXPECT_EQ(one.world.bodies[robot].position, other.world.bodies[robot].position);
  });
  EXPECT_EQ(one.world.ball.position, game.state.world.ball.position);
}

TEST(Sample, TheSameKeyIsTheSameWorld) {
  const Fixture game;
  const Situation situation = believe(game.params(), game.knowledge()).situation;
  EXPECT_EQ(hash_of(sample(game.params(), situation, {.seed = 9})),
            hash_of(sample(game.params(), situation, {.seed = 9})));
  EXPECT_NE(hash_of(sample(game.params(), situation, {.seed = 9})),
            hash_of(sample(game.params(), situation, {.seed = 10})));
}

TEST(Sample, WorldsScatterAsTheUncertaintyStates) {
  const Fixture game;
  Situation situation{.state = game.state, .doubt = {}};
  situation.state.world.bodies[kOwn].position = {};
  situation.doubt.position[kOwn] = 0.3f;
  situation.doubt.heading[kOwn] = 0.2f;
  const float heading = situation.state.world.bodies[kOwn].heading;
  constexpr int kWorlds = 4000;
  double x = 0, xx = 0, turns = 0;
  for (int i = 0; i < kWorlds; ++i) {
    const State world = sample(game.params(), situation, {.seed = static_cast<std::uint64_t>(i)});
    const Body& body = world.world.bodies[kOwn];
    x += static_cast<double>(body.position.x);
    xx += static_cast<double>(body.position.x * body.position.x);
    const auto turn = static_cast<double>(normalized(body.heading - heading));
    turns += turn * turn;
  }
  EXPECT_NEAR(x / kWorlds, 0, 0.02);
  EXPECT_NEAR(std::sqrt(xx / kWorlds), 0.3, 0.012);
  EXPECT_NEAR(std::sqrt(turns / kWorlds), 0.2, 0.008);
}

TEST(Sample, TheBallIsWhereTheRobotSeesIt) {
  const Fixture game;
  Situation situation = believe(game.params(), game.knowledge()).situation;
  situation.doubt.ball = situation.doubt.ball_velocity = situation.doubt.ball_elsewhere = 0;
  situation.doubt.ball_by_own_eyes = true;
  situation.state.world.ball.position = {0.3f, 0.2f};
  situation.state.world.bodies[kOwn].position = {-0.4f, 0.1f};
  const auto seen = [](const State& state) {
    const Body& body = state.world.bodies[kOwn];
    return turned_back(state.world.ball.position - body.position, body.facing);
  };
  const Vec2 as_believed = seen(situation.state);
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    EXPECT_LT(distance(seen(sample(game.params(), situation, {.seed = seed})), as_believed), 1e-4f);
}

TEST(Sample, TheBallIsElsewhereAsOftenAsTheUncertaintyStates) {
  const Fixture game;
  Situation situation{.state = game.state, .doubt = {}};
  situation.doubt.ball_elsewhere = 0.25f;
  constexpr int kWorlds = 4000;
  int elsewhere = 0;
  double x = 0;
  for (int i = 0; i < kWorlds; ++i) {
    const State world = sample(game.params(), situation, {.seed = static_cast<std::uint64_t>(i)});
    const Vec2 ball = world.world.ball.position;
    if (ball == situation.state.world.ball.position) continue;
    ++elsewhere;
    x += static_cast<double>(ball.x);
    EXPECT_TRUE(field::inside_field(game.params().rules.field, ball));
  }
  EXPECT_NEAR(static_cast<double>(elsewhere) / kWorlds, 0.25, 0.02);
  EXPECT_NEAR(x / elsewhere, 0, 0.2);
}

TEST(Believe, ABallBelievedOutIsSoonPutBack) {
  const Fixture game;
  Knowledge knowledge = game.knowledge();
  knowledge.beliefs.pose.pose = {};
  for (agent::Mate& told : knowledge.beliefs.mates) told.ball_age = 0xffff;
  const auto elsewhere = [&](Vec2 position, float seconds) {
    knowledge.beliefs.ball.position = position;
    knowledge.beliefs.ball.seen = knowledge.now - ticks(seconds);
    return guess_ball(kField2012, knowledge).elsewhere;
  };
  const Vec2 inside{2, 1}, over_goal_line{3.2f, 0}, over_touch_line{-1, -2.3f};
  for (const float seconds : {0.3f, 0.7f, 1.5f}) {
    EXPECT_GT(elsewhere(over_goal_line, seconds), 2 * elsewhere(inside, seconds)) << seconds;
    EXPECT_EQ(elsewhere(over_goal_line, seconds), elsewhere(over_touch_line, seconds)) << seconds;
  }
  EXPECT_EQ(elsewhere(over_goal_line, 0), 0) << "the referee takes his time";
  knowledge.beliefs.mates[0] = {.ball = over_goal_line, .sent = knowledge.now - ticks(3), .ball_age = 0};
  EXPECT_GT(elsewhere(inside, 10), 0.7f) << "told of, just as well";
}

/// A ball in play is on the field: the referee has placed back a ball believed beyond a line, also in the goal.
TEST(Sample, ABallBelievedOutLiesWhereTheRefereePutsIt) {
  const Fixture game;
  const field::Rules& rules = game.params().rules;
  const float line = rules.field.width / 2 - rules.out_inset, corner = rules.field.length / 2 - 1;
  Situation situation{.state = game.state, .doubt = {}};
  const auto places_after = [&](Vec2 believed) {
    situation.state.world.ball.position = believed;
    std::map<float, int> places;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
      const Ball ball = sample(game.params(), situation, {.seed = seed}).world.ball;
      EXPECT_EQ(ball.velocity, Vec2{});
      EXPECT_EQ(ball.position.y, believed.y < 0 ? -line : line);
      ++places[ball.position.x];
    }
    return places;
  };
  situation.state.world.ball.velocity = {1, 0};
  struct Out {
    Vec2 believed;
    float first, second;  // [m] along the field
  };
  const float back = rules.out_set_back, goal_line = rules.field.length / 2, touch_line = rules.field.width / 2;
  for (const Out& out : {Out{{goal_line + 1, 0.4f}, 0, corner}, Out{{-goal_line - 1, -1}, -corner, 0},
                         Out{{0.5f, touch_line + 0.5f}, 0.5f - back, 0.5f + back},
                         Out{{2.5f, -touch_line - 0.5f}, 2.5f - back, corner}}) {
    const auto found = places_after(out.believed);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_FLOAT_EQ(found.begin()->first, out.first);
    EXPECT_FLOAT_EQ(found.rbegin()->first, out.second);
    EXPECT_NEAR(found.begin()->second, 500, 60);
  }
}

/// With set plays no ball is placed back inside the touch line.
TEST(Sample, WithSetPlaysABallElsewhereIsAnywhere) {
  const io::PreparedGame setup = test::setup_of(test::choice_of("spl2025:5", "baseline", "match"), 60);
  Situation situation{.state = test::begun(setup.params, 1), .doubt = {}};
  situation.doubt.ball_elsewhere = 1;
  std::set<float> across;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    across.insert(sample(setup.params, situation, {.seed = seed}).world.ball.position.y);
  EXPECT_EQ(across.size(), 200u);
}

/// One near the line is there, on this side of it.
TEST(Sample, ABallBelievedAtTheLineLiesThere) {
  const Fixture game;
  const field::Field& field = game.params().rules.field;
  Situation situation{.state = game.state, .doubt = {}};
  situation.state.world.ball.position = {0, field.width / 2 - 0.05f};
  situation.doubt.ball = 0.1f;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Vec2 ball = sample(game.params(), situation, {.seed = seed}).world.ball.position;
    EXPECT_TRUE(field::inside_field(field, ball));
    EXPECT_LT(distance(ball, situation.state.world.ball.position), 0.7f);
  }
}

/// The others do not share the uncertainty of the robot: they know their places, and the opponents see the ball.
TEST(Sample, TheOthersKnowTheirPlaces) {
  const Fixture game;
  const Situation situation = believe(game.params(), game.knowledge()).situation;
  const State one = sample(game.params(), situation, {.seed = 3});
  test::for_each_body(one.world, [&](int robot, const Body& body) {
    const agent::Beliefs& beliefs = one.robots[robot].beliefs;
    if (robot == kOwn) {
      EXPECT_EQ(beliefs.pose.pose.position, situation.state.robots[kOwn].beliefs.pose.pose.position);
      return;
    }
    const Vec2 position = side_of(robot) == Side::home ? body.position : -body.position;
    EXPECT_LT(distance(beliefs.pose.pose.position, position), 1e-5f);
    const Vec2 ball = body.position + turned(beliefs.ball.position, body.facing);
    const Vec2 known = side_of(robot) == Side::home ? situation.state.world.ball.position : one.world.ball.position;
    EXPECT_LT(distance(ball, known), 1e-5f);
  });
}

TEST(Sample, NobodyLeavesTheCarpet) {
  const Fixture game;
  Situation situation{.state = game.state, .doubt = {}};
  for (float& deviation : situation.doubt.position) deviation = 3;
  situation.doubt.ball = 3;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const State state = sample(game.params(), situation, {.seed = seed});
    EXPECT_TRUE(field::inside_field(game.params().rules.field, state.world.ball.position));
    test::for_each_body(state.world, [&](int, const Body& body) {
      EXPECT_TRUE(field::inside_field(game.params().rules.field, body.position, 0.3f));
    });
  }
}

}  // namespace
}  // namespace sim::foresight
