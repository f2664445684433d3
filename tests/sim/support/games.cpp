#include "tests/sim/support/games.h"

#include <gtest/gtest.h>

namespace sim::test {

io::PreparedGame setup_of(const io::Matchup& matchup, float half) {
  auto setup = io::prepare(matchup);
  EXPECT_TRUE(setup) << setup.error();
  if (!setup) return {};
  setup->params.rules.half_duration = half;
  return *std::move(setup);
}

io::Matchup choice_of(const std::string& rules, const std::string& strategy, const std::string& models, Pace pace) {
  io::Matchup matchup;
  matchup.rules = rules;
  matchup.strategies[0] = matchup.strategies[1] = strategy;
  matchup.models[0] = matchup.models[1] = models;
  matchup.pace = pace;
  return matchup;
}

State after(const Params& params, State state, Tick ticks) {
  play_on(params, state, ticks);
  return state;
}

State begun(const Params& params, std::uint64_t seed) {
  referee::Events events;
  return begin(params, {seed}, events);
}

}  // namespace sim::test
