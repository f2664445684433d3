#include "sim/io/matchup.h"

#include <gtest/gtest.h>

#include <fstream>

#include "sim/io/ingredients.h"
#include "sim/io/models.h"
#include "sim/io/source.h"
#include "tests/support/temporary_folder.h"

namespace sim::io {
namespace {

const std::string kHeel =
    R"({"ball_x": -0.1, "ball_y": 0.05, "gate_x": 0.04, "gate_y": 0.03, "delay": 0.3, "duration": 0.6, "range": 1,
        "range_deviation": 0.2, "direction": 3.1, "direction_deviation": 0.1, "in_walk": true})";

TEST(PreparedGame, HoldsTheNamedParts) {
  const auto setup = prepare({.rules = "spl2025",
                              .strategies = {"baseline", "idle"},
                              .models = {"perfect", "match,falls=off"},
                              .players = 3,
                              .pace = Pace::every_tick});
  ASSERT_TRUE(setup) << setup.error();
  const Params& params = setup->params;
  EXPECT_EQ(params.rules.players, 3);
  EXPECT_EQ(params.rules.field.length, 9);
  EXPECT_GT(params.marks.count, 10);
  EXPECT_EQ(params.teams[0].behaviour->name(), "baseline");
  EXPECT_EQ(params.teams[1].behaviour->name(), "idle");
  EXPECT_EQ(params.teams[0].models.name, "perfect");
  EXPECT_FALSE(params.teams[1].models.effects.falls);
  EXPECT_EQ(params.pace, Pace::every_tick);
}

TEST(PreparedGame, PlaysWithTheBallOfTheRulesIfTheyHaveOne) {
  const auto radius = [](const std::string& rules) {
    const auto game = prepare({.rules = rules, .models = {"match,ball.radius=0.04", "match"}});
    return game ? game->params.teams[0].models.ball.radius : 0.f;
  };
  EXPECT_EQ(radius("spl2025"), 0.04f);
  EXPECT_EQ(radius("spl2025,ball_radius=0.06"), 0.06f);
  EXPECT_EQ(radius("hsl2026"), 0.07f);
}

TEST(PreparedGame, GivesSingleRobotsModelsOfTheirOwn) {
  const auto setup = prepare({.rules = "spl2025", .models = {"match+3=perfect+5=match,walk.forward=0.2", "match"}});
  ASSERT_TRUE(setup) << setup.error();
  const Params& params = setup->params;
  EXPECT_EQ(params.teams[0].models.name, "match+3=perfect+5=match,walk.forward=0.2");
  EXPECT_EQ(models_of(params, 2).name, "perfect");
  EXPECT_EQ(models_of(params, 4).motion.walk.forward, 0.2f);
  for (const int robot : {0, 1, 3}) EXPECT_EQ(&models_of(params, robot), &params.teams[0].models);
  for (int robot = kMaxPlayers; robot < kMaxRobots; ++robot)
    EXPECT_EQ(&models_of(params, robot), &params.teams[1].models);
  EXPECT_EQ(names_of_models("match+3=perfect+5=match,walk.forward=0.2"),
            (std::vector<std::string>{"match", "perfect", "match,walk.forward=0.2"}));

  const auto error = [](const std::string& models) {
    const auto game = prepare({.rules = "spl2025", .models = {models, "match"}});
    return game ? "" : game.error();
  };
  EXPECT_EQ(error("match+6=perfect"), "models 'match+6=perfect': the player before '=' must be 1 .. 5, got 6");
  EXPECT_EQ(error("match+3=perfect+3=match"), "models 'match+3=perfect+3=match': player 3 has models twice");
  EXPECT_EQ(error("match+3=perfct"), "no models 'perfct'; did you mean 'perfect'?");
}

TEST(PreparedGame, RefusesAKickThatARobotLacks) {
  const auto folder = tests::TemporaryFolder();
  const std::string tree = (folder.path() / "mine.json").string(), models = (folder.path() / "more.json").string();
  std::ofstream(tree) << R"({"name": "mine", "tree": {"do": "kick", "with": {"kick": "heel"}}})";
  std::ofstream(models) << R"({"name": "more", "based_on": "match", "kicks": {"heel": )" + kHeel + "}}";
  const auto error = [&](const std::string& with) {
    const auto game = prepare({.strategies = {tree, "idle"}, .models = {with, "match"}});
    return game ? "" : game.error();
  };
  EXPECT_EQ(error(models), "");
  EXPECT_EQ(
      error("match"),
      "strategy 'mine': models 'match' have no kick \"heel\"; there are: forward, long, walk_forward, side, turn");
  EXPECT_EQ(
      error(models + "+3=match"),
      "strategy 'mine': models 'match' have no kick \"heel\"; there are: forward, long, walk_forward, side, turn");
}

TEST(PreparedGame, NamesUnknownParts) {
  const auto error = [](const Matchup& choice) {
    const auto setup = prepare(choice);
    return setup ? "" : setup.error();
  };
  EXPECT_EQ(error({.rules = "spl1999"}), "no rules 'spl1999'; there are: hsl2026, spl2012, spl2025");
  EXPECT_EQ(error({.models = {"match", "mach"}}), "no models 'mach'; did you mean 'match'?");
  EXPECT_EQ(error({.strategies = {"basline", "idle"}}), "no strategy 'basline'; did you mean 'baseline'?");
  EXPECT_EQ(error({.strategies = {"idle", "forsight"}}), "no strategy 'forsight'; did you mean 'foresight'?");
  EXPECT_EQ(
      error({.strategies = {"chess", "idle"}}),
      "no strategy 'chess'; there are: align_first, all_kicks, baseline, high_line, idle, kick_now, learned, passing, "
      "foresight");
  EXPECT_EQ(error({.players = 8}), "players must be 1 .. 7 a side, got 8");
}

TEST(Ingredients, AreAllEmbeddedFiles) {
  const auto all = embedded_ingredients();
  ASSERT_TRUE(all) << all.error();
  EXPECT_EQ(all->lists.rules.size(), names_of("rules").size());
  EXPECT_EQ(all->lists.models.size(), names_of("models").size());
  EXPECT_EQ(all->lists.behaviours.size(), names_of("strategies").size());
}

}  // namespace
}  // namespace sim::io
