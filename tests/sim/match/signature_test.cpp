#include "sim/match/signature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include "sim/io/ingredients.h"
#include "sim/match/fields.h"
#include "sim/match/hash.h"

namespace sim {
namespace {

const io::AllIngredients& ingredients() {
  static const auto all = io::embedded_ingredients();
  EXPECT_TRUE(all) << all.error();
  return *all;
}

TEST(Signature, IsTheOneInTheRepository) {
  std::ifstream file(FORESIGHT_GOLDEN_DIR "/sim_signature.txt");
  std::string golden;
  ASSERT_TRUE(file >> golden) << "tests/golden/sim_signature.txt is missing";
  EXPECT_EQ(hex(signature_of(ingredients().lists)), golden)
      << "the simulator behaves differently now. If it should: foresight-sim signature > "
         "tests/golden/sim_signature.txt, and the last line of the commit message is 'Sim signature: <it>'";
}

TEST(Scenarios, FollowFromTheirNumber) {
  for (int number = 0; number < kScenarios; number += 5)
    EXPECT_EQ(difference(scenario(ingredients().lists, number).start, scenario(ingredients().lists, number).start), "");
}

TEST(Scenarios, UseAllIngredients) {
  std::set<const agent::Behaviour*> behaviours;
  std::set<std::string> models;
  std::set<float> fields;
  std::set<int> players, paces, effects_on, effects_off;
  for (int number = 0; number < kScenarios; ++number) {
    const Scenario made = scenario(ingredients().lists, number);
    players.insert(made.params.rules.players);
    fields.insert(made.params.rules.field.length);
    paces.insert(static_cast<int>(made.params.pace));
    for (const Team& team : made.params.teams) {
      behaviours.insert(team.behaviour);
      models.insert(team.models.name);
      int index = 0;
      Effects::visit(team.models.effects, [&](const char*, bool on, const char*, bool, bool) {
        (on ? effects_on : effects_off).insert(index++);
      });
    }
    EXPECT_EQ(made.start.book.phase == agent::Game::Phase::playing, number % 2 == 1);
  }
  EXPECT_EQ(behaviours.size(), ingredients().lists.behaviours.size());
  EXPECT_EQ(models.size(), ingredients().lists.models.size());
  EXPECT_EQ(fields.size(), ingredients().lists.rules.size());
  EXPECT_EQ(players, (std::set{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(paces.size(), 2u);
  EXPECT_EQ(effects_on, effects_off);
}

TEST(Signature, DependsOnEveryModelRuleAndBehaviour) {
  Ingredients some = ingredients().lists;
  const std::uint64_t before = signature_of(some);
  some.models.front().ball.deceleration *= 1.0001f;
  const std::uint64_t other_ball = signature_of(some);
  std::swap(some.behaviours.front(), some.behaviours.back());
  EXPECT_NE(before, other_ball);
  EXPECT_NE(other_ball, signature_of(some));
}

}  // namespace
}  // namespace sim
