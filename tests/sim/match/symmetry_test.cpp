// Left and right, home and away: nobody is favoured by how the simulator is written.
#include <gtest/gtest.h>

#include "sim/match/fields.h"
#include "sim/match/situation.h"
#include "tests/sim/support/games.h"
#include "tests/sim/support/states.h"

namespace sim {
namespace {

using test::choice_of;
using test::exchanged;
using test::setup_of;

/// The first field in which two states differ that matters.
std::string real_difference(const State& a, const State& b) {
  return difference(test::without_leftovers(a), test::without_leftovers(b));
}

TEST(Symmetry, GamesOfExchangedSidesAreTheExchangedGames) {
  for (const Pace pace : {Pace::every_tick, Pace::thinned})
    for (const char* rules : {"spl2012", "spl2025"})
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        auto choice = choice_of(rules, "baseline", "perfect", pace);
        choice.strategies[1] = "kick_now";
        const auto setup = setup_of(choice);
        const Params params = setup.params, params_exchanged = exchanged(setup.params);
        State state = random_situation(params, {seed}), other = exchanged(state);
        referee::Events events;
        for (int i = 0; i < 2000; ++i) {
          step(params, state, events);
          step(params_exchanged, other, events);
          ASSERT_EQ(real_difference(exchanged(state), other), "") << rules << ", seed " << seed << ", tick " << i;
        }
      }
}

}  // namespace
}  // namespace sim
