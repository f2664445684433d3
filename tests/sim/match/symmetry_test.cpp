// The simulator favours neither left nor right, neither home nor away.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "sim/agent/mirror.h"
#include "sim/agent/tree.h"
#include "sim/match/fields.h"
#include "sim/match/situation.h"
#include "tests/sim/support/games.h"
#include "tests/sim/support/states.h"

namespace sim {
namespace {

using test::choice_of;
using test::exchanged;
using test::setup_of;

// [ticks] between two comparisons; differences only grow
constexpr int kCompared = 40;

/// Returns the first relevant field in which two states differ.
std::string real_difference(const State& a, const State& b) {
  return difference(test::as_it_matters(a), test::as_it_matters(b));
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
          if (i % kCompared != 0) continue;
          ASSERT_EQ(real_difference(exchanged(state), other), "") << rules << ", seed " << seed << ", tick " << i;
        }
      }
}

/// Returns the same trees with left and right exchanged.
struct MirroredTrees {
  explicit MirroredTrees(Params given) : params(std::move(given)) {
    for (Team& team : params.teams) {
      const auto* tree = dynamic_cast<const agent::TreeBehaviour*>(team.behaviour);
      trees.push_back(std::make_unique<agent::TreeBehaviour>(agent::mirrored(tree->tree())));
      team.behaviour = trees.back().get();
    }
  }
  Params params;
  std::vector<std::unique_ptr<agent::TreeBehaviour>> trees;
};

TEST(Symmetry, MirroredGamesAreTheMirrorImagesOfGames) {
  for (const Pace pace : {Pace::every_tick, Pace::thinned})
    for (const char* rules : {"spl2012", "spl2025"})
      for (const char* strategy : {"baseline", "passing"})
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
          const auto setup = setup_of(choice_of(rules, strategy, "perfect", pace));
          const MirroredTrees image(setup.params);
          State state = random_situation(setup.params, {seed}), other = test::mirrored(state);
          referee::Events events;
          for (int i = 0; i < 2000; ++i) {
            step(setup.params, state, events);
            step(image.params, other, events);
            if (i % kCompared != 0) continue;
            ASSERT_EQ(real_difference(test::mirrored(state), other), "")
                << strategy << " by " << rules << ", seed " << seed << ", tick " << i;
          }
        }
}

}  // namespace
}  // namespace sim
