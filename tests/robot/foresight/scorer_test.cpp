#include "robot/foresight/scorer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "robot/core/clock.h"

namespace robot::foreseeing {
namespace {

constexpr std::uint64_t kBegin = 1000 * kSecond;

pb::GameState game(std::uint32_t own, std::uint32_t others, pb::GameState::State state = pb::GameState::STATE_PLAYING) {
  pb::GameState game;
  game.set_state(state);
  game.mutable_own()->set_score(own);
  game.mutable_opponent()->set_score(others);
  return game;
}

pb::Forecast foretold(float score, float concede, const std::string& by = "captain: it is time") {
  pb::Forecast forecast;
  forecast.mutable_question()->add_strategies("baseline");
  forecast.mutable_question()->add_strategies("passing");
  forecast.mutable_question()->set_asked_by(by);
  forecast.set_horizon(30);
  forecast.set_choice("passing");
  for (const char* strategy : {"baseline", "passing"}) {
    pb::Forecast::StrategyForecast& told = *forecast.add_strategies();
    told.set_strategy(strategy);
    told.set_rollouts(100);
    told.set_score(score);
    told.set_concede(concede);
  }
  return forecast;
}

TEST(Scorer, AGoalWithinTheTimeCameAndOneAfterItDidNot) {
  Scorer scorer;
  scorer.see(game(1, 0), kBegin);
  scorer.foretell(foretold(0.8f, 0.1f), kBegin);
  EXPECT_EQ(scorer.score().open(), 1u);
  EXPECT_FALSE(scorer.see(game(1, 0), kBegin + 29 * kSecond));
  EXPECT_TRUE(scorer.see(game(2, 0), kBegin + 29 * kSecond + 1)) << "what came is known at once";
  scorer.foretell(foretold(0.8f, 0.1f), kBegin + 40 * kSecond);
  EXPECT_TRUE(scorer.see(game(3, 0), kBegin + 70 * kSecond)) << "at its end it is too late for a goal";
  const pb::ForecastScore score = scorer.score();
  ASSERT_EQ(score.entries_size(), 1);
  EXPECT_EQ(score.entries(0).strategy(), "passing") << "what the captain changed to";
  EXPECT_EQ(score.entries(0).horizon(), 30);
  EXPECT_EQ(score.entries(0).forecasts(), 2u);
  EXPECT_EQ(score.entries(0).score().came(), 1u);
  EXPECT_NEAR(score.entries(0).score().brier(), (0.04 + 0.64) / 2, 1e-6);
  EXPECT_NEAR(score.entries(0).score().brier_of_rate(), 0.25, 1e-6);
  EXPECT_NEAR(score.entries(0).score().log_loss(), -(std::log(0.8) + std::log(0.2)) / 2, 1e-6);
  EXPECT_EQ(score.entries(0).score().bins(8).forecasts(), 2u);
  EXPECT_EQ(score.entries(0).concede().came(), 0u);
  EXPECT_EQ(score.open(), 0u);
}

TEST(Scorer, TheFirstGoalCounts) {
  Scorer scorer;
  scorer.see(game(0, 0), kBegin);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  scorer.see(game(0, 1), kBegin + kSecond);
  scorer.see(game(1, 1), kBegin + 2 * kSecond);
  EXPECT_EQ(scorer.score().entries(0).concede().came(), 1u);
  EXPECT_EQ(scorer.score().entries(0).score().came(), 0u);
}

TEST(Scorer, WhatPeopleAskIsScoredByWhatWasPlayed) {
  Scorer scorer;
  scorer.see(game(0, 0), kBegin);
  scorer.foretell(foretold(0.5f, 0.5f, "viewer"), kBegin);
  scorer.see(game(0, 0), kBegin + 30 * kSecond);
  ASSERT_EQ(scorer.score().entries_size(), 1);
  EXPECT_EQ(scorer.score().entries(0).strategy(), "baseline");
}

TEST(Scorer, PassesOverWhatCannotBeScored) {
  Scorer scorer;
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  EXPECT_EQ(scorer.score().open(), 0u) << "before the game was seen";
  scorer.see(game(0, 0), kBegin);
  pb::Forecast refused = foretold(0.5f, 0.5f), edited = refused, to_the_end = refused, unplayed = refused;
  refused.set_refusal("nobody has seen the ball yet");
  edited.mutable_question()->mutable_edit()->mutable_ball()->set_x(1);
  to_the_end.mutable_question()->set_until(pb::WhatIf::UNTIL_GAME);
  unplayed.mutable_strategies(1)->set_rollouts(0);
  for (const pb::Forecast& forecast : {refused, edited, to_the_end, unplayed}) scorer.foretell(forecast, kBegin);
  EXPECT_EQ(scorer.score().open(), 0u);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  EXPECT_FALSE(scorer.see(game(0, 0, pb::GameState::STATE_FINISHED), kBegin + kSecond)) << "the game was cut short";
  EXPECT_EQ(scorer.score().open(), 0u);
  EXPECT_EQ(to_text(scorer.score()), "");
}

/// Who foretells the truth: each bin comes as often as it says, and beats the base rate.
TEST(Scorer, AnHonestProphetIsReliable) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(0, 1);
  Scorer scorer;
  std::uint64_t now_ns = kBegin;
  std::uint32_t goals = 0;
  scorer.see(game(0, 0), now_ns);
  for (int i = 0; i < 20'000; ++i) {
    const float chance = any(random);
    scorer.foretell(foretold(chance, 0), now_ns);
    if (any(random) < chance) ++goals;
    scorer.see(game(goals, 0), now_ns + kSecond);
    scorer.see(game(goals, 0), now_ns += 30 * kSecond);
  }
  const pb::ForecastScore::Event score = scorer.score().entries(0).score();
  EXPECT_EQ(score.came(), goals);
  EXPECT_NEAR(score.brier(), 1. / 6, 0.005) << "the mean of p (1 - p)";
  EXPECT_NEAR(score.brier_of_rate(), 0.25, 0.005);
  for (const pb::ForecastScore::Bin& bin : score.bins())
    EXPECT_NEAR(static_cast<float>(bin.came()) / static_cast<float>(bin.forecasts()), bin.foretold(), 0.04f);
  EXPECT_NE(to_text(scorer.score()).find("passing"), std::string::npos);
  EXPECT_EQ(to_json(scorer.score())["entries"][0]["score"]["bins"].size(), 10u);
}

}  // namespace
}  // namespace robot::foreseeing
