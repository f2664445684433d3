#include "sim/io/matchup.h"

#include <gtest/gtest.h>

#include "sim/io/ingredients.h"
#include "sim/io/source.h"

namespace sim::io {
namespace {

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

TEST(PreparedGame, NamesUnknownParts) {
  const auto error = [](const Matchup& choice) {
    const auto setup = prepare(choice);
    return setup ? "" : setup.error();
  };
  EXPECT_EQ(error({.rules = "spl1999"}), "no rules 'spl1999'; there are: hsl2026, spl2012, spl2025");
  EXPECT_EQ(error({.models = {"match", "mach"}}), "no models 'mach'; did you mean 'match'?");
  EXPECT_EQ(error({.strategies = {"basline", "idle"}}), "no strategy 'basline'; did you mean 'baseline'?");
  EXPECT_EQ(error({.strategies = {"idle", "forsight"}}), "no strategy 'forsight'; did you mean 'foresight'?");
  EXPECT_EQ(error({.strategies = {"chess", "idle"}}),
            "no strategy 'chess'; there are: align_first, baseline, high_line, idle, kick_now, passing, foresight");
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
