#include "sim/debug/setup.h"

#include <gtest/gtest.h>

#include "sim/agent/follower.h"
#include "sim/io/strategy.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

TEST(Setup, RefusesWhatIsNoBehaviour) {
  contest::LineupChoice choice;
  choice.game.strategies[1] = "pipe:no_such_program";
  EXPECT_FALSE(prepare(choice));
  choice.game.strategies[1] = "baselin";
  EXPECT_FALSE(prepare(choice));
}

TEST(Setup, TheRestOfAGameKeepsTheStrategyThatItsCaptainChose) {
  auto game = io::prepare({});
  ASSERT_TRUE(game) << game.error();
  std::vector<std::shared_ptr<const agent::Behaviour>> strategies;
  for (const char* name : {"baseline", "passing"}) strategies.emplace_back(*io::load_strategy(name));
  game->behaviours[1] = std::make_shared<agent::Follower>("follows", strategies, 100);
  game->params.teams[1].behaviour = game->behaviours[1].get();
  State state{};
  const auto played = [&] {
    const auto setup = rest_of_game(*game, state);
    return tree_of((*setup)->params, robot_of(Side::away, 2))->tree().name;
  };
  EXPECT_EQ(played(), "baseline");
  state.robots[robot_of(Side::away, 1)].mind.choice = {.strategy = 1, .epoch = 3};
  EXPECT_EQ(played(), "passing");
}

TEST(Setup, KnowsTheTreeOfEachRobotAlsoOfATeamOfTwo) {
  contest::LineupChoice choice;
  choice.rest[0] = "passing", choice.changed = 2;
  const auto setup = prepare(choice);
  ASSERT_TRUE(setup) << setup.error();
  const Params& params = (*setup)->params;
  EXPECT_EQ(tree_of(params, robot_of(Side::home, 2))->tree().name, "baseline");
  EXPECT_EQ(tree_of(params, robot_of(Side::home, 3))->tree().name, "passing");
  EXPECT_EQ(tree_of(params, robot_of(Side::away, 3))->tree().name, "baseline");
}

TEST(Setup, AnotherTreeIsPlayedByThoseWhoPlayedThatOfTheRobot) {
  contest::LineupChoice choice;
  choice.rest[0] = "passing", choice.changed = 2;
  const auto setup = prepare(choice);
  ASSERT_TRUE(setup) << setup.error();
  const auto name = [](const SharedSetup& played, int player) {
    return tree_of(played->params, robot_of(Side::home, player))->tree().name;
  };
  const SharedSetup first = with_tree(*setup, robot_of(Side::home, 1), {.name = "new", .about = {}});
  EXPECT_EQ(name(first, 1) + name(first, 2) + name(first, 3), "newnewpassing");
  const SharedSetup rest = with_tree(*setup, robot_of(Side::home, 4), {.name = "new", .about = {}});
  EXPECT_EQ(name(rest, 2) + name(rest, 3), "baselinenew");
  const SharedSetup all = with_tree(*setup, robot_of(Side::away, 4), {.name = "new", .about = {}});
  EXPECT_EQ(tree_of(all->params, robot_of(Side::away, 1))->tree().name, "new");
  EXPECT_EQ(name(*setup, 1), "baseline") << "the old setup stays as it was";
}

}  // namespace
}  // namespace sim::debug
