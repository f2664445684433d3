#include "robot/foresight/game_setting.h"

#include <gtest/gtest.h>

namespace robot::foreseeing {
namespace {

foresight::Simulation simulated() {
  foresight::Simulation simulation;
  simulation.set_rules("spl2012");
  simulation.mutable_home()->set_number(14), simulation.mutable_home()->set_models("friendly");
  simulation.mutable_away()->set_number(5), simulation.mutable_away()->set_models("perfect");
  return simulation;
}

TEST(GameSetting, ARealGameIsPlayedByTheNewestRules) {
  const GameSetting real{.rules = "spl2025", .models = "match", .opponent_models = "match"};
  EXPECT_EQ(setting_of(nullptr, "14/2", ""), real);
  const foresight::Simulation nothing;
  EXPECT_EQ(setting_of(&nothing, "14/2", ""), real);
}

TEST(GameSetting, ASimulationHasModelsForEachSide) {
  const foresight::Simulation simulation = simulated();
  EXPECT_EQ(setting_of(&simulation, "14/2", ""),
            (GameSetting{.rules = "spl2012", .models = "friendly", .opponent_models = "perfect"}));
  EXPECT_EQ(setting_of(&simulation, "5/2", ""),
            (GameSetting{.rules = "spl2012", .models = "perfect", .opponent_models = "friendly"}));
}

TEST(GameSetting, ModelsThatNoLongerExistBecomeMatch) {
  foresight::Simulation simulation = simulated();
  simulation.mutable_home()->set_models("of last year");
  EXPECT_EQ(setting_of(&simulation, "14/2", "").models, "match");
}

TEST(GameSetting, GivenRulesReplaceThose) {
  const foresight::Simulation simulation = simulated();
  EXPECT_EQ(setting_of(&simulation, "14/2", "spl2025:7").rules, "spl2025:7");
  EXPECT_EQ(setting_of(nullptr, "14/2", "hsl2026").rules, "hsl2026");
}

}  // namespace
}  // namespace robot::foreseeing
