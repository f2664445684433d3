#include "sim/match/step.h"

#include <gtest/gtest.h>

#include "sim/match/fields.h"
#include "sim/match/hash.h"
#include "sim/match/situation.h"
#include "sim/match/snapshot.h"
#include "tests/sim/support/allocations.h"
#include "tests/sim/support/games.h"

namespace sim {
namespace {

using test::after;
using test::begun;
using test::choice_of;
using test::setup_of;

TEST(Step, IsAFunctionOfItsArguments) {
  for (const Pace pace : {Pace::every_tick, Pace::thinned}) {
    const auto setup = setup_of(choice_of("spl2025", "baseline", "match", pace));
    const State once = after(setup.params, begun(setup.params, 7), 3000);
    const State again = after(setup.params, begun(setup.params, 7), 3000);
    EXPECT_EQ(difference(once, again), "");
    EXPECT_EQ(hash_of(once), hash_of(again));
  }
}

TEST(Step, OnlyRobotsThatRunIntoEachOtherFallByATableOfPushesAlone) {
  const auto falls_of = [](float mass) {
    auto setup = setup_of(choice_of("spl2025", "baseline", "match"));
    const motion::Toppling toppling{.slope = 6, .half = {2, 2, 2, 2, 2, 2, 2, 2}};
    const motion::ServoClass alike{.rates = {}, .standing = toppling, .walking = toppling};
    for (Team& team : setup.params.teams)
      team.models.motion.falls.table = {
          .given = true, .collisions = {.mass = mass, .bounce = 0, .soft = 0}, .stiff = alike, .soft = alike};
    State state = begun(setup.params, 3);
    int falls = 0;
    for (Tick tick = 0; tick < 6000; ++tick) {
      const World before = state.world;
      state = after(setup.params, state, 1);
      test::for_each_body(state.world, [&](int robot, const Body& body) {
        if (body.doing != Body::Doing::fallen || before.bodies[robot].doing >= Body::Doing::fallen) return;
        ++falls;
        EXPECT_GT(body.touching, 0) << "robot " << robot << " at tick " << tick;
      });
    }
    return falls;
  };
  const int light = falls_of(0.5f), heavy = falls_of(100);
  EXPECT_EQ(light, 0);
  EXPECT_GT(heavy, 10);
}

TEST(Step, ARobotWithASlowerWalkWalksSlowerAndTheOthersDoNot) {
  const auto game = [](const std::string& models) {
    io::Matchup choice = choice_of("spl2025", "baseline", models);
    choice.models[1] = "match";
    return setup_of(choice);
  };
  const auto all = game("match"), one = game("match+3=match,walk.forward=0.1,walk.turn_rate=0.5");
  const State from = begun(all.params, 7), usual = after(all.params, from, 120), slow = after(one.params, from, 120);
  const auto walked = [&](const State& to, int robot) {
    return distance(to.world.bodies[robot].position, from.world.bodies[robot].position);
  };
  for_each_robot(from.world.players, [&](int robot) {
    ASSERT_GT(walked(usual, robot), 0.3f) << robot;
    if (robot == robot_of(Side::home, 3))
      EXPECT_LT(walked(slow, robot), 0.6f * walked(usual, robot));
    else
      EXPECT_EQ(slow.world.bodies[robot].position, usual.world.bodies[robot].position) << robot;
  });
}

TEST(Step, TheTeammatesOfAPenalisedRobotKnowItAtOnce) {
  const auto setup = setup_of(choice_of("spl2025", "baseline", "match,packet_delay=off"));
  State state = begun(setup.params, 7);
  referee::Events events;
  int known = 0;
  while (!finished(state) && state.world.tick < 20000) {
    const State before = state;
    step(setup.params, state, events);
    for_each_robot(state.world.players, [&](int robot) {
      const bool penalised = before.book.penalised_until[robot] != 0 && state.book.penalised_until[robot] != 0;
      for (int mate = 0; penalised && mate + 1 < state.world.players; ++mate) {
        const int other = robot_of(side_of(robot), agent::player_of_mate(player_of(robot), mate));
        if (before.book.penalised_until[other] != 0 || state.book.penalised_until[other] != 0) continue;
        const int index = agent::index_of_mate(player_of(other), player_of(robot));
        ASSERT_FALSE(state.robots[other].beliefs.mates[index].active) << robot << " for " << other;
        ++known;
      }
    });
  }
  EXPECT_GT(known, 0);
}

TEST(Step, ModelsOfItsOwnThatAreTheSameChangeNothing) {
  const auto all = setup_of(choice_of("spl2025", "baseline", "match", Pace::thinned));
  const auto each =
      setup_of(choice_of("spl2025", "baseline", "match+1=match+2=match+3=match+4=match+5=match", Pace::thinned));
  EXPECT_EQ(hash_of(after(all.params, begun(all.params, 9), 6000)),
            hash_of(after(each.params, begun(each.params, 9), 6000)));
}

TEST(Step, AnotherKeyGivesAnotherGame) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"));
  State other = begun(setup.params, 8);
  other = after(setup.params, other, 3000);
  other.world.key.seed = 7;
  EXPECT_NE(difference(after(setup.params, begun(setup.params, 7), 3000), other), "");
}

TEST(Step, FromAnySnapshotLeadsToTheSameEnd) {
  for (const Pace pace : {Pace::every_tick, Pace::thinned}) {
    const auto setup = setup_of(choice_of("spl2012", "baseline", "match", pace), 60);
    const State end = after(setup.params, begun(setup.params, 3), kNever);
    ASSERT_TRUE(finished(end));
    State state = begun(setup.params, 3);
    while (!finished(state)) {
      const Restored restored = restore(snapshot_of(state));
      ASSERT_TRUE(restored.state) << restored.refusal;
      EXPECT_EQ(hash_of(after(setup.params, *restored.state, kNever)), hash_of(end)) << "tick " << state.world.tick;
      state = after(setup.params, state, 997);
    }
  }
}

TEST(Step, HasNoStateOutsideTheState) {
  // two games step alternately
  const auto setup = setup_of(choice_of("spl2025", "passing", "match"));
  State a = begun(setup.params, 1), b = begun(setup.params, 2);
  for (int i = 0; i < 2000; ++i) {
    a = after(setup.params, a, 1);
    b = after(setup.params, b, 1);
  }
  EXPECT_EQ(difference(a, after(setup.params, begun(setup.params, 1), 2000)), "");
  EXPECT_EQ(difference(b, after(setup.params, begun(setup.params, 2), 2000)), "");
}

TEST(Step, AllocatesNothing) {
  for (const Pace pace : {Pace::every_tick, Pace::thinned}) {
    const auto setup = setup_of(choice_of("spl2025", "baseline", "match", pace), 60);
    State state = begun(setup.params, 5);
    referee::Events events;
    const std::size_t before = test::allocations();
    while (!finished(state)) step(setup.params, state, events);
    EXPECT_EQ(test::allocations() - before, 0u);
  }
}

TEST(Step, TracesDecisionsWithoutChangingThem) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"));
  State explained = begun(setup.params, 4), plain = explained;
  referee::Events events;
  agent::Trace one, all[kMaxRobots];
  for (int i = 0; i < 1500; ++i) {
    step(setup.params, plain, events);
    State copy = explained;
    step(setup.params, copy, events, 9, &one);
    step(setup.params, explained, events, kEverybody, all);
    ASSERT_EQ(difference(plain, explained), "");
    ASSERT_EQ(difference(copy, explained), "");
    ASSERT_STREQ(one.skill, all[9].skill);
    ASSERT_EQ(one.visited.size(), all[9].visited.size());
    ASSERT_STRNE(one.skill, "");
  }
}

TEST(Step, DoesNotTouchRobotsThatDoNotPlay) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"), 60);
  const State start = begun(setup.params, 6);
  State state = after(setup.params, start, kNever);
  for (int robot = 0; robot < kMaxRobots; ++robot) {
    if (robot % kMaxPlayers >= setup.params.rules.players) continue;
    state.world.bodies[robot] = start.world.bodies[robot];
    state.robots[robot] = start.robots[robot];
  }
  State others = start;
  for (int robot = 0; robot < kMaxRobots; ++robot) {
    others.world.bodies[robot] = state.world.bodies[robot];
    others.robots[robot] = state.robots[robot];
  }
  EXPECT_EQ(difference(others, start), "");
}

TEST(Step, WithPerfectModelsBeliefsEqualTheTruth) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "perfect"));
  State state = random_situation(setup.params, {11});
  referee::Events events;
  for (int i = 0; i < 1000; ++i) {
    const World before = state.world;
    step(setup.params, state, events);
    test::for_each_body(before, [&](int robot, const Body& body) {
      if (!on_field(state.world.bodies[robot]) || state.world.home_attacks != before.home_attacks) return;
      const agent::Beliefs& beliefs = state.robots[robot].beliefs;
      const float sign = attack_sign(before, side_of(robot));
      EXPECT_LT(distance(sign * beliefs.pose.pose.position, body.position), 1e-4f) << robot;
      const Vec2 ball = turned_back(before.ball.position - body.position, body.facing);
      EXPECT_LT(distance(beliefs.ball.position, ball), 1e-4f) << robot << " in tick " << before.tick;
    });
  }
}

}  // namespace
}  // namespace sim
