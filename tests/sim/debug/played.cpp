#include "tests/sim/debug/played.h"

#include <gtest/gtest.h>

namespace sim::debug::test {

SharedSetup setup_of(const std::string& home, const std::string& away, float half) {
  contest::LineupChoice choice;
  choice.game.strategies[0] = home, choice.game.strategies[1] = away;
  auto setup = prepare(choice);
  EXPECT_TRUE(setup) << setup.error();
  auto shorter = std::make_shared<Setup>(**setup);
  shorter->params.rules.half_duration = half;
  return shorter;
}

Timeline timeline_of(const SharedSetup& setup, std::uint64_t seed) {
  return Timeline(setup, sim::test::begun(setup->params, seed));
}

void for_each_decision(
    int count, int every,
    const std::function<void(const Params&, const State&, const Decision&, const agent::TreeBehaviour&)>& see) {
  const SharedSetup setup = setup_of("baseline", "passing", 120);
  const Params& params = setup->params;
  int seen = 0, number = 0;
  for (std::uint64_t seed = 1; seen < count; ++seed) {
    State state = sim::test::begun(params, seed);
    referee::Events events;
    while (!finished(state) && seen < count) {
      for_each_robot(state.world.players, [&](int robot) {
        if (!referee::in_play(state.book) || !decides(state, robot)) return;
        if (++number % every != 0 || seen >= count) return;
        const auto decision = decision_in(params, state, robot);
        ASSERT_TRUE(decision);
        if (!agent::plays(decision->game)) return;
        ++seen;
        see(params, state, *decision, *tree_of(params, robot));
      });
      step(params, state, events);
    }
  }
}

}  // namespace sim::debug::test
