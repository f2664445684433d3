#include "sim/io/situation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/json_library.h"
#include "sim/io/source.h"
#include "sim/match/fields.h"
#include "sim/match/step.h"

namespace sim::io {
namespace {

const PreparedGame& setup() {
  static const PreparedGame made = prepare({}).value();
  return made;
}

State parsed(std::string_view text) {
  const auto state = parse_situation(text, "situation", setup().params);
  EXPECT_TRUE(state) << state.error();
  return *state;
}

std::string error_of_situation(std::string_view text) {
  const auto state = parse_situation(text, "situation 'duel'", setup().params);
  return state ? "" : state.error();
}

constexpr std::string_view kDuel = R"({
  "about": "one against the keeper", "seed": 7, "half": 2, "clock": 300, "score": {"home": 1, "away": 2},
  "kicking": "away",
  "ball": {"x": 1.25, "y": -0.5, "velocity_x": 0.5, "velocity_y": 0.25},
  "robots": [{"side": "home", "player": 2, "x": 0.5, "y": -0.5, "heading": 0.5},
             {"side": "home", "player": 4, "x": 0, "y": 3, "penalised": 12},
             {"side": "away", "player": 1, "x": 2.9, "y": 0, "heading": 3.1}]})";

TEST(Situation, EqualsItsDescription) {
  const State state = parsed(kDuel);
  const World& world = state.world;
  EXPECT_EQ(world.key.seed, 7u);
  EXPECT_EQ(world.ball.position, (Vec2{1.25f, -0.5f}));
  EXPECT_EQ(world.ball.velocity, (Vec2{0.5f, 0.25f}));
  EXPECT_EQ(world.bodies[robot_of(Side::home, 2)].position, (Vec2{0.5f, -0.5f}));
  EXPECT_EQ(world.bodies[robot_of(Side::home, 2)].heading, 0.5f);
  EXPECT_EQ(world.bodies[robot_of(Side::away, 1)].doing, Body::Doing::standing);
  EXPECT_EQ(world.home_attacks, -1);
  EXPECT_EQ(state.book.phase, agent::Game::Phase::playing);
  EXPECT_EQ(state.book.half, 2);
  EXPECT_EQ(state.book.clock, ticks(300));
  EXPECT_EQ(state.book.score[0], 1);
  EXPECT_EQ(state.book.score[1], 2);
  EXPECT_EQ(state.book.kicking, Side::away);
}

TEST(Situation, TheNumbersOfTheTeamsChangeNothing) {
  const std::string numbered = std::string(R"({"teams": {"home": 14, "away": 5}, )") + std::string(kDuel.substr(4));
  EXPECT_EQ(save_situation(parsed(numbered)), save_situation(parsed(kDuel)));
  EXPECT_EQ(error_of_situation(R"({"teams": {"home": 14, "away": 14}, "ball": {"x": 0, "y": 0}, "robots": []})"),
            "situation 'duel': teams must have different numbers, got 14 twice");
  EXPECT_EQ(error_of_situation(R"({"teams": {"home": 0, "away": 14}, "ball": {"x": 0, "y": 0}, "robots": []})"),
            "situation 'duel': teams.home must be a whole number, 1 .. 999, got 0");
  EXPECT_EQ(error_of_situation(R"({"teams": {"home": 14}, "ball": {"x": 0, "y": 0}, "robots": []})"),
            "situation 'duel': teams.away is missing, expected 1 .. 999");
}

TEST(Situation, TheClockMayBeTheTimeThatRemains) {
  const auto with = [](const std::string& entry) {
    return "{" + entry + R"("ball": {"x": 0, "y": 0}, "robots": [{"side": "home", "player": 2, "x": 1, "y": 1}]})";
  };
  EXPECT_EQ(parsed(with(R"("remaining": 200, )")).book.clock, ticks(400));
  EXPECT_EQ(error_of_situation(with(R"("remaining": 601, )")),
            "situation 'duel': remaining must be at most 600 [s] by these rules, got 601");
  EXPECT_EQ(error_of_situation(with(R"("remaining": 200, "clock": 400, )")),
            "situation 'duel': expected clock or remaining, got both");
}

TEST(Situation, ARobotThatIsNotListedDoesNotPlay) {
  State state = parsed(kDuel);
  referee::Events events;
  for (int i = 0; i < 300; ++i) step(setup().params, state, events);
  for (const int player : {1, 3}) {
    EXPECT_EQ(state.world.bodies[robot_of(Side::home, player)].doing, Body::Doing::removed);
    EXPECT_EQ(state.book.penalised_until[robot_of(Side::home, player)], kNever);
  }
}

TEST(Situation, APenaltyEnds) {
  State state = parsed(kDuel);
  const int robot = robot_of(Side::home, 4);
  EXPECT_EQ(state.world.bodies[robot].doing, Body::Doing::removed);
  referee::Events events;
  for (int i = 0; i < 20 * 30; ++i) step(setup().params, state, events);
  EXPECT_NE(state.world.bodies[robot].doing, Body::Doing::removed);
}

TEST(Situation, AllRobotsHaveJustSeenAndReportedTheBall) {
  const State state = parsed(R"({"ball": {"x": 1, "y": 0.5},
    "robots": [{"side": "home", "player": 2, "x": 0, "y": 0.5}, {"side": "home", "player": 3, "x": 1, "y": 0,
                "heading": 1.5707964}]})");
  const agent::Beliefs& second = state.robots[robot_of(Side::home, 2)].beliefs;
  EXPECT_NEAR(second.ball.position.x, 1, 1e-5);
  EXPECT_NEAR(second.ball.position.y, 0, 1e-5);
  EXPECT_EQ(second.ball.seen, state.world.tick);
  const agent::Beliefs& third = state.robots[robot_of(Side::home, 3)].beliefs;
  EXPECT_NEAR(third.ball.position.x, 0.5, 1e-5);
  EXPECT_NEAR(third.ball.position.y, 0, 1e-5);
  EXPECT_EQ(second.mates[1].sent, state.world.tick);  // player 3
  EXPECT_EQ(third.mates[1].sent, state.world.tick);   // player 2
  EXPECT_EQ(second.mates[0].sent, kNever);            // player 1 does not play
}

TEST(Situation, ASavedSituationReadsBackIdentically) {
  State state = parsed(kDuel);
  referee::Events events;
  for (int i = 0; i < 100; ++i) {
    const std::string saved = save_situation(state);
    EXPECT_EQ(save_situation(parsed(saved)), saved) << "after " << i << " seconds";
    for (int tick = 0; tick < 30; ++tick) step(setup().params, state, events);
  }
}

TEST(Situation, NamesTheError) {
  EXPECT_EQ(error_of_situation("{}"), "situation 'duel': ball is missing");
  EXPECT_EQ(error_of_situation(R"({"ball": {"x": 1}, "robots": []})"),
            "situation 'duel': ball.y is missing, expected -20 .. 20");
  EXPECT_EQ(error_of_situation(R"({"ball": {"x": 0, "y": 0, "z": 0}, "robots": []})"),
            "situation 'duel': ball.z is unknown; there are: x, y, velocity_x, velocity_y, deviation, "
            "velocity_deviation");
  EXPECT_EQ(error_of_situation(R"({"ball": {"x": 0, "y": 0, "deviation": -1}, "robots": []})"),
            "situation 'duel': ball.deviation must be 0 .. 10, got -1");
  EXPECT_EQ(error_of_situation(R"({"ball": {"x": 0, "y": 0}, "robots": {}})"),
            "situation 'duel': robots must be a list, got {}");
  EXPECT_EQ(error_of_situation(R"({"ball": {"x": 0, "y": 0}, "robots": [], "seed": -1})"),
            "situation 'duel': seed must be a whole number from 0, got -1");
  EXPECT_EQ(error_of_situation(R"({"ball": {"x": 0, "y": 0}, "robots": [], "phase": "paused"})"),
            "situation 'duel': phase must be one of initial, ready, set, playing, finished, got \"paused\"");
  EXPECT_EQ(error_of_situation(R"({"ball": {"x": 0, "y": 0}, "robots": [], "half": 3})"),
            "situation 'duel': half must be at most 2 by these rules, got 3");
  EXPECT_EQ(error_of_situation(R"({"ball": {"x": 0, "y": 0}, "robots": [], "clock": 601})"),
            "situation 'duel': clock must be at most 600 [s] by these rules, got 601");
  const auto robots = [](const std::string& list) {
    return error_of_situation(R"({"ball": {"x": 0, "y": 0}, "robots": [)" + list + "]}");
  };
  const std::string one = R"({"side": "home", "player": 1, "x": 0, "y": 0})";
  EXPECT_EQ(robots(one), "");
  EXPECT_EQ(robots(one + "," + one), "situation 'duel': robots[1] names the same robot as one before it");
  EXPECT_EQ(robots(R"({"side": "home", "player": 5, "x": 0, "y": 0})"),
            "situation 'duel': robots[0].player must be at most 4 in this game, got 5");
  EXPECT_EQ(robots(R"({"side": "ours", "player": 1, "x": 0, "y": 0})"),
            "situation 'duel': robots[0].side must be one of home, away, got \"ours\"");
  EXPECT_EQ(robots(R"({"player": 1, "x": 0, "y": 0})"), "situation 'duel': robots[0].side is missing");
  EXPECT_EQ(robots("7"), "situation 'duel': robots[0] must be an object, got 7");
}

TEST(Situation, EveryTruncationIsRefused) {
  for (std::size_t size = 0; size < kDuel.size(); ++size)
    EXPECT_NE(error_of_situation(kDuel.substr(0, size)), "") << size;
}

TEST(Situation, TurnedGivesEachSideTheMomentOfTheOther) {
  const State plain = parsed(kDuel);
  const State turned = parse_situation(kDuel, "situation", setup().params, nullptr, true).value();
  EXPECT_EQ(turned.world.ball.position, -plain.world.ball.position);
  EXPECT_EQ(turned.world.ball.velocity, -plain.world.ball.velocity);
  EXPECT_EQ(turned.world.home_attacks, plain.world.home_attacks);
  EXPECT_EQ(turned.book.score[0], plain.book.score[1]);
  EXPECT_EQ(turned.book.score[1], plain.book.score[0]);
  EXPECT_EQ(turned.book.kicking, other(plain.book.kicking));
  for_each_robot(plain.world.players, [&](int robot) {
    const int image = robot_of(other(side_of(robot)), player_of(robot));
    const Body &was = plain.world.bodies[robot], &is = turned.world.bodies[image];
    EXPECT_EQ(is.doing, was.doing);
    EXPECT_EQ(turned.book.penalised_until[image], plain.book.penalised_until[robot]);
    if (!on_field(was)) return;
    EXPECT_EQ(is.position, -was.position);
    EXPECT_NEAR(std::cos(is.heading), -std::cos(was.heading), 1e-5);
    EXPECT_NEAR(std::sin(is.heading), -std::sin(was.heading), 1e-5);
    // each sees what the other saw: in its own frame the ball is where it was
    const agent::Beliefs &believed = plain.robots[robot].beliefs, &believes = turned.robots[image].beliefs;
    EXPECT_NEAR(length(believes.ball.position - believed.ball.position), 0, 1e-5);
  });
}

TEST(Situation, ShakingMovesAllRobotsALittleByTheGamesRandomNumbers) {
  for (const std::string_view name : names_of("situations")) {
    const auto source = find_source("situations", "situation", std::string(name));
    const State plain = parse_situation(source->text, "situation", setup().params).value();
    const auto shaken = [&](std::uint64_t seed) {
      const RandomKey luck{seed};
      return parse_situation(source->text, "situation", setup().params, &luck).value();
    };
    EXPECT_EQ(difference(shaken(1), shaken(1)), "");
    EXPECT_NE(difference(shaken(1), shaken(2)), "");
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const World world = shaken(seed).world;
      const auto stands = [&](int robot) { return on_field(world.bodies[robot]); };
      EXPECT_LE(length(world.ball.position - plain.world.ball.position), 0.3f * 1.415f);
      for_each_robot(world.players, [&](int robot) {
        EXPECT_EQ(world.bodies[robot].doing, plain.world.bodies[robot].doing);
        if (!stands(robot)) return;
        EXPECT_LE(length(world.bodies[robot].position - plain.world.bodies[robot].position), 0.3f * 1.415f);
        for_each_robot(world.players, [&](int other) {
          if (other != robot && stands(other)) {
            EXPECT_GT(length(world.bodies[robot].position - world.bodies[other].position), 0.3f) << name << " " << seed;
          }
        });
      });
    }
  }
}

constexpr std::string_view kDoubted = R"({
  "ball": {"x": 0, "y": 1, "velocity_x": 0.5, "deviation": 0.4, "velocity_deviation": 0.2},
  "robots": [{"side": "home", "player": 2, "x": -2, "y": -1, "heading": 0.5, "deviation": 0.2, "heading_deviation": 0.1},
             {"side": "away", "player": 3, "x": 2, "y": -1, "deviation": 0}]})";

TEST(Situation, ShakingFollowsTheDeviationsOfTheDescription) {
  constexpr int kDraws = 4000;
  struct Moments {
    double sum = 0, squares = 0;
    void add(double value) { sum += value, squares += value * value; }
    double mean() const { return sum / kDraws; }
    double deviation() const { return std::sqrt(squares / kDraws - mean() * mean()); }
  };
  Moments ball_x, ball_y, speed, robot_x, heading, other_x;
  for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
    const RandomKey luck{seed};
    const World world = parse_situation(kDoubted, "situation", setup().params, &luck).value().world;
    ball_x.add(world.ball.position.x), ball_y.add(world.ball.position.y), speed.add(world.ball.velocity.x);
    robot_x.add(world.bodies[robot_of(Side::home, 2)].position.x);
    heading.add(world.bodies[robot_of(Side::home, 2)].heading);
    other_x.add(world.bodies[robot_of(Side::away, 3)].position.x);
  }
  // five standard errors of 4000 draws
  EXPECT_NEAR(ball_x.mean(), 0, 0.032);
  EXPECT_NEAR(ball_x.deviation(), 0.4, 0.023);
  EXPECT_NEAR(ball_y.deviation(), 0.4, 0.03) << "a ball beyond the line is drawn again, which narrows it a little";
  EXPECT_NEAR(speed.mean(), 0.5, 0.016);
  EXPECT_NEAR(speed.deviation(), 0.2, 0.012);
  EXPECT_NEAR(robot_x.mean(), -2, 0.016);
  EXPECT_NEAR(robot_x.deviation(), 0.2, 0.012);
  EXPECT_NEAR(heading.mean(), 0.5, 0.008);
  EXPECT_NEAR(heading.deviation(), 0.1, 0.006);
  EXPECT_NEAR(other_x.deviation(), 0, 1e-6) << "a place without uncertainty stays";
}

TEST(Situation, ADeviationMattersOnlyWhereAStartIsShaken) {
  const std::string_view certain = R"({"ball": {"x": 0, "y": 1, "velocity_x": 0.5},
    "robots": [{"side": "home", "player": 2, "x": -2, "y": -1, "heading": 0.5},
               {"side": "away", "player": 3, "x": 2, "y": -1}]})";
  EXPECT_EQ(difference(parsed(kDoubted), parsed(certain)), "");
}

TEST(Situation, ABelievedMomentIsSavedInTheFieldsFrameWithItsDeviations) {
  for (const int half : {1, 2}) {
    const Params& params = setup().params;
    referee::Events events;
    State game = begin(params, {.seed = 11}, events);
    game.book.half = static_cast<std::uint8_t>(half);
    game.world.home_attacks = half == 1 ? 1.f : -1.f;
    for (int i = 0; i < 1200; ++i) step(params, game, events);
    const int robot = robot_of(Side::home, 2);
    const auto believed = foresight::believe(params, foresight::knowledge_of(params, game, robot));
    ASSERT_EQ(believed.refusal, "");
    const std::string text = save_situation(believed.situation, {.home = 14, .away = 5}, "a belief");
    const State read = parsed(text);
    const float sign = half == 1 ? 1 : -1;  // from team_field to field
    const World &world = read.world, &guessed = believed.situation.state.world;
    EXPECT_EQ(read.book.half, half);
    EXPECT_EQ(world.home_attacks, sign);
    EXPECT_NEAR(length(world.ball.position - sign * guessed.ball.position), 0, 1e-3);
    for_each_robot(world.players, [&](int other) {
      if (!on_field(guessed.bodies[other])) return;
      EXPECT_NEAR(length(world.bodies[other].position - sign * guessed.bodies[other].position), 0, 1e-3) << other;
    });
    const Json json = Json::parse(text);
    EXPECT_EQ(json["teams"]["home"], 14);
    EXPECT_GE(json["ball"]["deviation"].get<float>(), believed.situation.doubt.ball - 1e-3f);
    EXPECT_NEAR(json["robots"][1]["deviation"].get<float>(), believed.situation.doubt.position[robot], 1e-3);
    EXPECT_FALSE(Json::parse(save_situation(believed.situation, {.home = 14, .away = 0}, "")).contains("teams"));
  }
}

TEST(Situation, TheEmbeddedOnesAreFoundByName) {
  for (const std::string_view name : names_of("situations"))
    EXPECT_TRUE(load_situation(std::string(name), setup().params));
  const auto unknown = load_situation("blockd", setup().params);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().find("no situation 'blockd'; did you mean 'blocked'?"), 0u) << unknown.error();
}

TEST(Situation, AMissingFileIsNamedInTheError) {
  const auto state = load_situation("no/such.json", setup().params);
  ASSERT_FALSE(state);
  EXPECT_EQ(state.error().substr(0, 26), "situation 'no/such.json': ");
}

}  // namespace
}  // namespace sim::io
