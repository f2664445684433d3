#include "tests/sim/support/games.h"

#include <gtest/gtest.h>

namespace sim::test {

io::PreparedGame setup_of(const io::Matchup& choice, float half) {
  auto setup = io::prepare(choice);
  EXPECT_TRUE(setup) << setup.error();
  if (!setup) return {};
  setup->params.rules.half_duration = half;
  return *std::move(setup);
}

io::Matchup choice_of(const std::string& rules, const std::string& strategy, const std::string& models, Pace pace) {
  io::Matchup choice;
  choice.rules = rules;
  choice.strategies[0] = choice.strategies[1] = strategy;
  choice.models[0] = choice.models[1] = models;
  choice.pace = pace;
  return choice;
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
