#include <gtest/gtest.h>

#include "tests/sim/referee/scene.h"

namespace sim::referee {
namespace {

using Phase = agent::Game::Phase;

std::string with(const char* name, Side side) { return std::string(name) + (side == Side::home ? " home" : " away"); }

TEST(Phases, AllRobotsBeginAtTheTouchLinesOfTheirOwnHalf) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    EXPECT_EQ(scene.book.phase, Phase::ready);
    EXPECT_EQ(scene.told(), Names{with("ready", scene.book.first_kick_off)});
    for_each_robot(rules.players, [&](int robot) {
      const Body& body = scene.world.bodies[robot];
      EXPECT_LT(attack_sign(scene.world, side_of(robot)) * body.position.x, 0);
      EXPECT_EQ(std::abs(body.position.y), rules.field.width / 2);
      EXPECT_LT(body.position.y * body.facing.y, 0) << "looks across the field";
      EXPECT_NEAR(body.heading, angle_of(body.facing), 1e-6f);
      for_each_robot(rules.players, [&](int another) {
        if (another == robot) return;
        EXPECT_GT(distance(body.position, scene.world.bodies[another].position), 0.3f);
      });
    });
  }
}

TEST(Phases, HomeAndAwayBeginSymmetrically) {
  Scene scene(rules_2025());
  for (int player = 1; player <= 7; ++player)
    EXPECT_EQ(scene.robot(Side::home, player).position, -scene.robot(Side::away, player).position);
}

TEST(Phases, TheKeySettlesTheKickOff) {
  int home = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) home += Scene(rules_2012(), seed).book.first_kick_off == Side::home;
  EXPECT_NEAR(home, 500, 50);
}

TEST(Phases, ReadyEndsTwoSecondsAfterAllRobotsStand) {
  Scene scene(rules_2012());
  scene.told();
  const Side side = scene.book.kicking;
  scene.robot(Side::away, 3).doing = Body::Doing::walking;
  scene.pass_seconds(10);
  EXPECT_EQ(scene.told(), Names{});
  scene.robot(Side::away, 3).doing = Body::Doing::standing;
  scene.pass(59);
  EXPECT_EQ(scene.told(), Names{});
  scene.pass();
  EXPECT_EQ(scene.told(), Names{with("set", side)});
  scene.pass_seconds(5);
  EXPECT_EQ(scene.told(), Names{with("playing", side)});
  scene.pass_seconds(10);
  EXPECT_EQ(scene.told(), Names{with("ball free", side)});
}

TEST(Phases, ReadyLastsNoLongerThanItsDuration) {
  Scene scene(rules_2012());
  scene.told();
  scene.robot(Side::away, 3).doing = Body::Doing::walking;
  scene.pass_seconds(45);
  EXPECT_EQ(scene.told(), Names{});
  scene.pass();
  EXPECT_EQ(scene.book.phase, Phase::set);
}

TEST(Phases, TheKickingSideFreesTheBallByTouchingIt) {
  Scene scene(rules_2012());
  while (scene.book.phase != Phase::playing) scene.pass();
  EXPECT_EQ(scene.ball().position, Vec2{});
  EXPECT_FALSE(scene.book.ball_free);
  scene.told();
  scene.touch(scene.book.kicking, 2);
  EXPECT_TRUE(scene.book.ball_free);
  EXPECT_EQ(scene.told(), Names{with("ball free", scene.book.kicking)});
}

TEST(Phases, InSetNoRobotIsAtAnIllegalPlace) {
  Scene scene(rules_2025());
  const Side kicking = scene.book.kicking;
  const float ahead = attack_sign(scene.world, kicking);
  scene.stand(kicking, 2, {-0.3f * ahead, 0.1f});        // may be in the circle
  scene.stand(kicking, 3, {0.5f * ahead, 2});            // in the wrong half
  scene.stand(other(kicking), 2, {0.3f * ahead, 0.1f});  // in the circle
  scene.stand(other(kicking), 3, {-2 * ahead, -1});      // in the wrong half
  scene.told();
  scene.pass_seconds(2);
  scene.pass();

  Names expected{with("set", kicking), with("placed", kicking), with("placed", other(kicking)),
                 with("placed", other(kicking))};
  if (kicking == Side::away) expected = {"set away", "placed home", "placed home", "placed away"};
  EXPECT_EQ(scene.told(), expected);
  EXPECT_EQ(scene.robot(kicking, 2).position, (Vec2{-0.3f * ahead, 0.1f}));
  EXPECT_EQ(scene.robot(kicking, 3).position, (Vec2{-0.15f * ahead, 2}));
  EXPECT_EQ(scene.robot(other(kicking), 3).position, (Vec2{0.15f * ahead, -1}));
  EXPECT_NEAR(length(scene.robot(other(kicking), 2).position), 0.9f, 1e-5f);
  EXPECT_GT(scene.robot(other(kicking), 2).position.x * ahead, 0);
}

TEST(Phases, EventsOfTheBallBeforePlayAreIgnored) {
  Scene scene(rules_2012());
  scene.told();
  scene.pass();
  scene.ball().position = {5, 0};
  scene.touch(Side::home, 1);
  EXPECT_EQ(scene.told(), Names{});
  while (scene.book.phase != Phase::set) scene.pass();
  scene.ball().position = {-5, 0};
  scene.touch(Side::home, 1);
  scene.pass_seconds(5);
  EXPECT_EQ(scene.book.score[0] + scene.book.score[1], 0);
  EXPECT_EQ(scene.ball().position, Vec2{});
}

TEST(Phases, AHalfLastsExactlyItsDurationAfterTheFirstPlaying) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    while (scene.book.phase != Phase::finished) scene.pass();
    std::vector<Tick> begins, ends;
    int half = 1;
    for (const Event& event : scene.events) {
      if (event.kind == Event::Kind::playing && static_cast<int>(begins.size()) < half) begins.push_back(event.tick);
      if (event.kind == Event::Kind::half_time) ++half;
      if (event.kind == Event::Kind::half_time || event.kind == Event::Kind::end) ends.push_back(event.tick);
    }
    ASSERT_EQ(begins.size(), 2u);
    ASSERT_EQ(ends.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(ends[i] - begins[i], 18000u);
  }
}

TEST(Phases, TicksOfAGameAreLinearInItsLength) {
  std::vector<Tick> lengths;
  for (const float half : {100.f, 200.f, 300.f}) {
    field::Rules rules = rules_2012();
    rules.half_duration = half;
    Scene scene(rules);
    while (scene.book.phase != Phase::finished) scene.pass();
    lengths.push_back(scene.world.tick);
  }
  EXPECT_EQ(lengths[2] - lengths[1], lengths[1] - lengths[0]);
  EXPECT_EQ(lengths[1] - lengths[0], 2 * ticks(100));
}

TEST(Phases, AtHalfTimeSidesChangeAndTheOtherSideKicksOff) {
  Scene scene(rules_2025());
  scene.start_play();
  const float line = scene.robot(Side::home, 4).position.y;
  scene.world.bodies[0].pushing = 15;
  scene.touch(Side::home, 1);
  while (scene.told() != Names{"pushing home"}) scene.pass();
  scene.book.clock = ticks(scene.rules.half_duration) - 1;
  scene.pass();

  const Side second = other(scene.book.first_kick_off);
  EXPECT_EQ(scene.told(), (Names{"half time", with("ready", second)}));
  EXPECT_EQ(scene.world.home_attacks, -1);
  EXPECT_EQ(scene.book.half, 2);
  EXPECT_EQ(scene.ball().position, Vec2{});
  EXPECT_EQ(scene.robot(Side::home, 4).position.y, line);
  for_each_robot(7, [&](int robot) {
    EXPECT_EQ(scene.world.bodies[robot].doing, Body::Doing::standing);
    EXPECT_EQ(scene.book.penalised_until[robot], 0u);
    EXPECT_LT(attack_sign(scene.world, side_of(robot)) * scene.world.bodies[robot].position.x, 0);
  });
}

TEST(Phases, MercyEndsAGame) {
  field::Rules rules = rules_2012();
  rules.mercy_goals = 2;
  Scene scene(rules);
  for (int goal = 1; goal <= 2; ++goal) {
    scene.start_play();
    scene.carry(Side::away, 2, {-2.9f, 0.2f}, {-3.1f, 0.2f});
  }
  EXPECT_EQ(scene.told(), (Names{"goal away", "ready home", "end"}));
  EXPECT_EQ(scene.book.phase, Phase::finished);
  scene.pass_seconds(100);
  EXPECT_EQ(scene.told(), Names{});
}

TEST(Phases, AllEventNamesDiffer) {
  std::vector<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(Event::Kind::placed); ++kind)
    names.emplace_back(name_of(static_cast<Event::Kind>(kind)));
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_NE(names[i], "");
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(names[i], names[j]);
  }
}

}  // namespace
}  // namespace sim::referee
