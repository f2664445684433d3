// The referee's decisions are symmetric: in a mirrored game, and with the sides exchanged.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/sim/referee/scene.h"

namespace sim::referee {
namespace {

/// The script of one tick, from the home side's view, before mirroring.
struct Step {
  Vec2 ball;
  int touched;  // index or kNobody
  Vec2 places[kMaxRobots];
  bool pushes[kMaxRobots];
};

std::vector<Step> script(std::uint32_t seed, const field::Rules& rules, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> share(-1, 1);
  std::uniform_int_distribution<int> percent(0, 99), player(1, rules.players);
  const Vec2 reach{rules.field.length / 2 + 0.2f, rules.field.width / 2 + 0.2f};
  std::vector<Step> steps(static_cast<std::size_t>(count));
  for (Step& step : steps) {
    step.ball = {reach.x * share(random), reach.y * share(random)};
    step.touched = percent(random) < 70 ? robot_of(percent(random) < 50 ? Side::home : Side::away, player(random))
                                        : static_cast<int>(kNobody);
    for_each_robot(rules.players, [&](int robot) {
      step.places[robot] = {1.25f * reach.x * share(random), 1.25f * reach.y * share(random)};
      step.pushes[robot] = percent(random) < 2;
    });
  }
  return steps;
}

/// A symmetry of the game: y negated, sides exchanged (the field turned round).
struct Symmetry {
  float mirror = 1;
  bool exchanged = false;

  Vec2 of(Vec2 a) const { return {exchanged ? -a.x : a.x, exchanged ? -mirror * a.y : mirror * a.y}; }
  Side of(Side side) const { return exchanged ? other(side) : side; }
  int of(int robot) const { return robot == kNobody ? robot : robot_of(of(side_of(robot)), player_of(robot)); }
};

Scene play(const field::Rules& rules, const std::vector<Step>& steps, const Symmetry& symmetry) {
  Scene scene(rules);
  const Side kicking = symmetry.of(Side::home);
  scene.book.first_kick_off = scene.book.kicking = scene.book.last_touch = kicking;
  scene.events.clear();
  int used = 0;
  for (const Step& step : steps) {
    // acts rarely outside PLAYING, so that the other phases pass too
    const bool acts = used++ % 40 == 0 || scene.book.phase == agent::Game::Phase::playing;
    if (acts) {
      scene.ball().position = symmetry.of(step.ball);
      scene.world.touched = static_cast<std::uint8_t>(symmetry.of(step.touched));
    }
    for_each_robot(rules.players, [&](int robot) {
      Body& body = scene.world.bodies[symmetry.of(robot)];
      if (!acts || !on_field(body)) return;
      body.position = symmetry.of(step.places[robot]);
      body.facing = symmetry.of(Vec2{0.6f, 0.8f});
      body.pushing = step.pushes[robot] ? 200 : 0;
    });
    scene.pass();
  }
  return scene;
}

void expect_same(const Scene& one, const Scene& two, const Symmetry& symmetry) {
  ASSERT_EQ(one.events.size(), two.events.size());
  const int players = one.rules.players;

  // events of one tick may have another order
  auto key = [](const Event& event) { return std::tuple(event.tick, event.kind, event.robot); };
  std::vector<Event> first, second = two.events;
  for (Event event : one.events) {
    event.robot = static_cast<std::uint8_t>(symmetry.of(static_cast<int>(event.robot)));
    if (event.kind != Event::Kind::half_time && event.kind != Event::Kind::end) event.side = symmetry.of(event.side);
    event.at = symmetry.of(event.at);
    first.push_back(event);
  }
  std::sort(first.begin(), first.end(), [&](const Event& a, const Event& b) { return key(a) < key(b); });
  std::sort(second.begin(), second.end(), [&](const Event& a, const Event& b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(key(first[i]), key(second[i])) << i;
    ASSERT_EQ(first[i].side, second[i].side) << name_of(first[i].kind);
    ASSERT_EQ(first[i].at, second[i].at) << name_of(first[i].kind);
  }
  EXPECT_EQ(symmetry.of(one.world.ball.position), two.world.ball.position);
  for_each_robot(players, [&](int robot) {
    const Body& a = one.world.bodies[robot];
    const Body& b = two.world.bodies[symmetry.of(robot)];
    EXPECT_EQ(a.doing, b.doing);
    if (on_field(a)) {
      EXPECT_EQ(symmetry.of(a.position), b.position);
    }
  });
  for (const Side side : {Side::home, Side::away}) {
    const auto from = static_cast<std::size_t>(side), to = static_cast<std::size_t>(symmetry.of(side));
    EXPECT_EQ(one.book.score[from], two.book.score[to]);
    EXPECT_EQ(one.counts.possession[from], two.counts.possession[to]);
  }
}

void check(const Symmetry& symmetry) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    int decided = 0;
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      field::Rules shorter = rules;
      shorter.half_duration = 60;
      shorter.mercy_goals = 0;
      shorter.goal_message_delay = 1;
      const auto steps = script(seed, shorter, 5000);
      const Scene one = play(shorter, steps, {}), two = play(shorter, steps, symmetry);
      expect_same(one, two, symmetry);
      decided += static_cast<int>(one.events.size());
    }
    EXPECT_GT(decided, 1000);
  }
}

TEST(Laws, AMirroredGameIsJudgedMirrored) { check({.mirror = -1}); }
TEST(Laws, ExchangedSidesAreJudgedTheSame) { check({.exchanged = true}); }

TEST(Laws, AllEventsOfATickFit) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    scene.start_play();
    for_each_robot(rules.players, [&](int robot) { scene.world.bodies[robot].pushing = 255; });
    Events now;
    while (now.count == 0) {
      judge(scene.params(), scene.world, scene.book, scene.counts, now);
      ++scene.world.tick;
    }
    EXPECT_EQ(now.count, 2 * rules.players);
  }
}

}  // namespace
}  // namespace sim::referee
