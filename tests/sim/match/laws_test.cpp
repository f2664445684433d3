// Invariants of every step of whole games.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "sim/match/fields.h"
#include "sim/match/step.h"
#include "tests/sim/support/games.h"

namespace sim {
namespace {

using test::begun;
using test::choice_of;
using test::for_each_body;
using test::setup_of;

constexpr float kMillimetre = 0.001f;

class Game : public testing::TestWithParam<std::tuple<const char*, const char*, Pace>> {
 protected:
  void SetUp() override {
    const auto& [rules, strategy, pace] = GetParam();
    setup_ = setup_of(choice_of(rules, strategy, "match", pace), 90);
  }
  const Params& params() const { return setup_.params; }

  /// Plays a whole game and calls see(before, after) for each step.
  template <class See>
  void watch(std::uint64_t seed, See&& see) {
    State state = begun(params(), seed);
    referee::Events events;
    while (!finished(state) && !HasFailure()) {
      const State before = state;
      step(params(), state, events);
      see(before, state);
    }
  }

 private:
  io::PreparedGame setup_;
};

TEST_P(Game, KeepsRobotsOutOfEachOtherAndOfPosts) {
  const ContactModel& contact = params().teams[0].models.contact;
  const field::Field& field = params().rules.field;
  watch(1, [&](const State&, const State& state) {
    for_each_body(state.world, [&](int robot, const Body& body) {
      for_each_body(state.world, [&](int other, const Body& another) {
        if (other <= robot) return;
        EXPECT_GE(distance(body.position, another.position), 2 * contact.robot_radius - kMillimetre)
            << robot << " and " << other << " in tick " << state.world.tick;
      });
      for (const float x : {-1.f, 1.f})
        for (const float y : {-1.f, 1.f}) {
          const Vec2 post{x * field.length / 2, y * field.goal_width / 2};
          EXPECT_GE(distance(body.position, post), contact.robot_radius + field.post_radius - kMillimetre)
              << robot << " in tick " << state.world.tick;
        }
    });
  });
}

TEST_P(Game, HasNoRobotFasterThanItsLegs) {
  const motion::Walk& walk = params().teams[0].models.motion.walk;
  const float fastest = std::max({walk.forward, walk.backward, walk.sideward});
  watch(2, [&](const State& before, const State& state) {
    if (state.world.home_attacks != before.world.home_attacks) return;  // half time puts all robots at the touch lines
    for_each_body(state.world, [&](int robot, const Body& body) {
      EXPECT_LE(length(body.velocity), fastest * 1.0001f);
      EXPECT_LE(std::abs(body.turn_rate), walk.turn_rate * 1.0001f);
      // the way it walked, without pushes; several ticks at once when it has no turn in each
      const float walked = body.walked - before.world.bodies[robot].walked;
      const auto ticks = static_cast<float>(state.schedule.lag[robot]);
      EXPECT_LE(walked, fastest * ticks * kTickDuration * 1.001f + 1e-4f) << robot << " in tick " << state.world.tick;
    });
  });
}

TEST_P(Game, KeepsUnitVectorsAndAngles) {
  watch(3, [&](const State&, const State& state) {
    for_each_body(state.world, [&](int robot, const Body& body) {
      EXPECT_NEAR(length(body.facing), 1, 1e-5) << robot;
      EXPECT_NEAR(length(body.look), 1, 1e-5) << robot;
      EXPECT_LE(distance(body.facing, direction(body.heading)), 1e-4f) << robot;
      EXPECT_LE(std::abs(body.heading), kPi);
    });
  });
}

TEST_P(Game, HasNoBallFasterThanAKick) {
  const motion::Model& model = params().teams[0].models.motion;
  float farthest = 0;
  for (int kick = 0; kick < model.kick_count; ++kick) farthest = std::max(farthest, model.kicks[kick].range);
  // a kick's range spreads by at most six deviations of 60 %
  const float fastest = speed_for_range(farthest * (1 + 6 * 0.6f), params().teams[0].models.ball.deceleration);
  watch(4, [&](const State&, const State& state) {
    EXPECT_LE(length(state.world.ball.velocity), fastest) << "in tick " << state.world.tick;
  });
}

TEST_P(Game, IsTheSameWithoutShortcuts) {
  // the work skipped by `next` and `crowded` would change nothing
  State state = begun(params(), 4), looked_at = state;
  referee::Events events;
  while (!finished(state)) {
    looked_at.schedule.next = 0;
    looked_at.world.crowded = true;
    step(params(), looked_at, events);
    step(params(), state, events);
    State same = looked_at;
    same.world.crowded = state.world.crowded;
    ASSERT_EQ(difference(same, state), "") << state.world.tick;
  }
}

TEST_P(Game, CountsEveryTick) {
  watch(5, [&](const State& before, const State& state) {
    EXPECT_EQ(state.world.tick, before.world.tick + 1);
    EXPECT_GE(state.book.score[0], before.book.score[0]);
    EXPECT_GE(state.book.score[1], before.book.score[1]);
    EXPECT_GE(state.book.clock, state.book.half == before.book.half ? before.book.clock : 0);
  });
}

std::string name_of(const testing::TestParamInfo<Game::ParamType>& info) {
  const auto& [rules, strategy, pace] = info.param;
  return std::string(rules) + "_" + strategy + (pace == Pace::thinned ? "_thinned" : "");
}

INSTANTIATE_TEST_SUITE_P(Whole, Game,
                         testing::Values(std::tuple("spl2012", "baseline", Pace::every_tick),
                                         std::tuple("spl2012", "passing", Pace::thinned),
                                         std::tuple("spl2025", "baseline", Pace::thinned),
                                         std::tuple("spl2025", "kick_now", Pace::every_tick)),
                         name_of);

}  // namespace
}  // namespace sim
