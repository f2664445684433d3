#include "robot/foresight/scorer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "robot/core/clock.h"
#include "robot/core/json_library.h"

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

pb::Strategy playing(const std::string& name) {
  pb::Strategy strategy;
  strategy.set_name(name);
  return strategy;
}

pb::Forecast foretold(float score, float concede) {
  pb::Forecast forecast;
  forecast.mutable_question()->add_strategies("baseline");
  forecast.mutable_question()->add_strategies("passing");
  forecast.mutable_question()->set_asked_by("captain: it is time");
  forecast.set_horizon(30);
  forecast.set_advice(pb::Forecast::ADVICE_KEEP);
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
  scorer.see(playing("passing"), kBegin - kSecond);
  scorer.see(game(1, 0), kBegin);
  scorer.foretell(foretold(0.8f, 0.1f), kBegin);
  EXPECT_EQ(scorer.score().open(), 1u);
  EXPECT_FALSE(scorer.see(game(2, 0), kBegin + 30 * kSecond - 1)) << "its time has not passed";
  EXPECT_TRUE(scorer.see(game(2, 0), kBegin + 30 * kSecond));
  scorer.foretell(foretold(0.8f, 0.1f), kBegin + 40 * kSecond);
  EXPECT_TRUE(scorer.see(game(3, 0), kBegin + 70 * kSecond)) << "at its end it is too late for a goal";
  const pb::ForecastScore score = scorer.score();
  ASSERT_EQ(score.entries_size(), 1);
  EXPECT_EQ(score.entries(0).strategy(), "passing") << "the played strategy";
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
  scorer.see(game(1, 1), kBegin + 30 * kSecond);
  EXPECT_EQ(scorer.score().entries(0).concede().came(), 1u);
  EXPECT_EQ(scorer.score().entries(0).score().came(), 0u);
  EXPECT_EQ(scorer.score().entries(0).strategy(), "baseline") << "the first one without a message about the strategy";
}

TEST(Scorer, AGoalBetweenQuestionAndAnswerCounts) {
  Scorer scorer;
  scorer.see(game(0, 0), kBegin);
  scorer.see(game(1, 0), kBegin + kSecond);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  scorer.see(game(1, 0), kBegin + 30 * kSecond);
  EXPECT_EQ(scorer.score().entries(0).score().came(), 1u);
}

TEST(Scorer, GoalsFellBeforeTheGameControllerReportedThem) {
  Scorer scorer(15);
  scorer.see(game(0, 0), kBegin);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin + 20 * kSecond);
  scorer.see(game(0, 1), kBegin + 5 * kSecond);                 // a goal before the first forecast
  EXPECT_FALSE(scorer.see(game(1, 1), kBegin + 44 * kSecond));  // fell at 29 s
  EXPECT_TRUE(scorer.see(game(1, 1), kBegin + 45 * kSecond));
  EXPECT_TRUE(scorer.see(game(2, 1), kBegin + 65 * kSecond));
  ASSERT_EQ(scorer.score().entries_size(), 1);
  EXPECT_EQ(scorer.score().entries(0).forecasts(), 2u);
  EXPECT_EQ(scorer.score().entries(0).score().came(), 2u);
  EXPECT_EQ(scorer.score().entries(0).concede().came(), 0u);
}

TEST(Scorer, InAFastSimulationTheTimePassesSooner) {
  Scorer scorer(15);
  scorer.see(game(0, 0), kBegin);
  pb::Forecast forecast = foretold(0.5f, 0.5f);
  forecast.set_speed(10);
  scorer.foretell(forecast, kBegin);
  scorer.see(game(1, 0), kBegin + 4 * kSecond);
  EXPECT_FALSE(scorer.see(game(1, 0), kBegin + 45 * kSecond / 10 - 1));
  EXPECT_TRUE(scorer.see(game(1, 0), kBegin + 45 * kSecond / 10))
      << "30 s and the 15 s in which the GameController reports a goal";
  EXPECT_EQ(scorer.score().entries(0).score().came(), 1u);
}

TEST(Scorer, ACancelledGoalDoesNotCount) {
  Scorer scorer;
  scorer.see(game(0, 0), kBegin);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  scorer.see(game(0, 1), kBegin + kSecond);
  scorer.see(game(1, 1), kBegin + 2 * kSecond);
  scorer.see(game(1, 0), kBegin + 3 * kSecond);
  scorer.see(game(1, 0), kBegin + 30 * kSecond);
  EXPECT_EQ(scorer.score().entries(0).score().came(), 1u);
  EXPECT_EQ(scorer.score().entries(0).concede().came(), 0u);
}

/// The strategy is written once a second. A choice has the time of its question, half a second ago.
TEST(Scorer, AForecastCountsForTheStrategyThatWasPlayedAllItsTime) {
  Scorer scorer;
  scorer.see(game(0, 0), kBegin);
  scorer.see(playing("baseline"), kBegin - kSecond);
  scorer.see(playing("baseline"), kBegin + kSecond / 4);
  scorer.see(playing("passing"), kBegin);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  scorer.see(playing("passing"), kBegin + kSecond);
  EXPECT_TRUE(scorer.see(game(0, 0), kBegin + 30 * kSecond));
  EXPECT_EQ(scorer.score().entries(0).strategy(), "passing");
  scorer.foretell(foretold(0.5f, 0.5f), kBegin + 40 * kSecond);
  scorer.see(playing("baseline"), kBegin + 60 * kSecond);
  EXPECT_FALSE(scorer.see(game(0, 0), kBegin + 70 * kSecond)) << "the strategy changed meanwhile";
  scorer.see(playing("tiki_taka"), kBegin + 75 * kSecond);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin + 80 * kSecond);
  EXPECT_FALSE(scorer.see(game(0, 0), kBegin + 110 * kSecond)) << "it holds no forecast of the played strategy";
  EXPECT_EQ(scorer.score().open(), 0u);
}

TEST(Scorer, ABehaviourThatAsksByItselfPlaysTheFirstThatItAskedAbout) {
  Scorer scorer;
  scorer.see(game(0, 0), kBegin);
  scorer.see(playing("passing"), kBegin);
  pb::Forecast forecast = foretold(0.5f, 0.5f);
  for (const char* by : {"people", "", "our behaviour"}) {
    forecast.mutable_question()->set_asked_by(by);
    scorer.foretell(forecast, kBegin);
  }
  scorer.see(game(0, 0), kBegin + 30 * kSecond);
  ASSERT_EQ(scorer.score().entries_size(), 2);
  EXPECT_EQ(scorer.score().entries(0).strategy(), "baseline");
  EXPECT_EQ(scorer.score().entries(0).forecasts(), 2u);
  EXPECT_EQ(scorer.score().entries(1).strategy(), "passing") << "what people ask changes nothing";
}

/// A forecast without a goal cannot be scored when the game ends before its time; were one with a goal, goals would
/// seem to come more often than they do.
TEST(Scorer, TheEndOfTheGameFavoursNeither) {
  for (const std::uint32_t goals : {0u, 1u}) {
    Scorer scorer;
    scorer.see(game(0, 0), kBegin);
    scorer.foretell(foretold(0.5f, 0.5f), kBegin);
    EXPECT_FALSE(scorer.see(game(goals, 0), kBegin + 5 * kSecond));
    EXPECT_FALSE(scorer.see(game(goals, 0, pb::GameState::STATE_FINISHED), kBegin + 20 * kSecond));
    EXPECT_FALSE(scorer.see(game(goals, 0), kBegin + 40 * kSecond));
    EXPECT_EQ(scorer.score().entries_size(), 0);
  }
}

TEST(Scorer, SkipsForecastsThatCannotBeScored) {
  Scorer scorer;
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  EXPECT_EQ(scorer.score().open(), 0u) << "before the game was seen";
  scorer.see(game(0, 0), kBegin);
  pb::Forecast refused = foretold(0.5f, 0.5f), edited = refused, to_the_end = refused, without_advice = refused,
               other_world = refused;
  refused.set_refusal("nobody has seen the ball yet");
  edited.mutable_question()->mutable_edit()->mutable_ball()->set_x(1);
  to_the_end.mutable_question()->set_until(pb::WhatIf::UNTIL_GAME);
  without_advice.set_advice(pb::Forecast::ADVICE_NONE);
  other_world.mutable_question()->set_opponent("kick_now");
  for (const pb::Forecast& forecast : {refused, edited, to_the_end, without_advice, other_world})
    scorer.foretell(forecast, kBegin);
  EXPECT_EQ(scorer.score().open(), 0u);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  EXPECT_FALSE(scorer.see(game(0, 0, pb::GameState::STATE_FINISHED), kBegin + kSecond)) << "the game was cut short";
  EXPECT_EQ(scorer.score().open(), 0u);
  EXPECT_EQ(to_text(scorer.score()), "");
}

/// A simulated game of the teams 14, at home, and 1.
pb::Simulation truth(std::uint32_t home, std::uint32_t away, std::uint32_t tick) {
  pb::Simulation simulation;
  simulation.set_tick(tick);
  simulation.mutable_home()->set_number(14);
  simulation.mutable_home()->set_score(home);
  simulation.mutable_away()->set_number(1);
  simulation.mutable_away()->set_score(away);
  return simulation;
}

pb::GameState game_of(std::uint32_t team, std::uint32_t own, std::uint32_t others) {
  pb::GameState told = game(own, others);
  told.set_own_team(team);
  return told;
}

TEST(Scorer, InASimulationGoalsCountWhenTheyFall) {
  for (const std::uint32_t team : {14u, 1u}) {
    Scorer scorer(15);
    scorer.see(game_of(team, 0, 0), kBegin);
    EXPECT_EQ(scorer.score().against(), pb::ForecastScore::AGAINST_OWN_MEMORY);
    scorer.see(truth(0, 0, 300), kBegin);
    EXPECT_EQ(scorer.score().against(), pb::ForecastScore::AGAINST_GROUND_TRUTH);
    scorer.foretell(foretold(0.5f, 0.5f), kBegin);
    // the away side's goal that falls late is told after its time, and the home side's of before within
    scorer.see(game_of(team, 2, 0), kBegin + 5 * kSecond);
    scorer.see(truth(0, 1, 1190), kBegin + 29 * kSecond);
    EXPECT_FALSE(scorer.see(truth(0, 1, 1199), kBegin + 30 * kSecond - 1));
    EXPECT_TRUE(scorer.see(truth(0, 1, 1200), kBegin + 30 * kSecond)) << "it does not wait for the GameController";
    ASSERT_EQ(scorer.score().entries_size(), 1);
    EXPECT_EQ(scorer.score().entries(0).score().came(), team == 1 ? 1u : 0u);
    EXPECT_EQ(scorer.score().entries(0).concede().came(), team == 1 ? 0u : 1u);
    EXPECT_NE(to_text(scorer.score()).find("goals by ground truth"), std::string::npos);
    EXPECT_EQ(to_json(scorer.score())["against"], "ground truth");
  }
}

TEST(Scorer, ASimulationOfOtherTeamsDoesNotCount) {
  Scorer scorer;
  scorer.see(game_of(7, 0, 0), kBegin);
  scorer.see(truth(0, 0, 300), kBegin);
  EXPECT_EQ(scorer.score().against(), pb::ForecastScore::AGAINST_OWN_MEMORY);
}

TEST(Scorer, ANewSimulatedGameDropsOpenForecasts) {
  Scorer scorer;
  scorer.see(game_of(14, 0, 0), kBegin);
  scorer.see(truth(2, 0, 300), kBegin);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  scorer.see(truth(0, 0, 0), kBegin + kSecond);
  EXPECT_EQ(scorer.score().open(), 0u);
}

TEST(Scorer, AfterTimeWasMovedBackOpenForecastsAreNotScored) {
  Scorer scorer;
  scorer.see(game(0, 0), kBegin);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin);
  scorer.see(playing("passing"), kBegin + kSecond);
  scorer.see(game(1, 0), kBegin + 2 * kSecond);
  EXPECT_FALSE(scorer.see(game(0, 0), kBegin - 100 * kSecond));
  EXPECT_EQ(scorer.score().open(), 0u);
  scorer.foretell(foretold(0.5f, 0.5f), kBegin - 90 * kSecond);
  EXPECT_TRUE(scorer.see(game(0, 0), kBegin - 60 * kSecond));
  EXPECT_EQ(scorer.score().entries(0).strategy(), "baseline") << "the choice is still to come";
  EXPECT_EQ(scorer.score().entries(0).score().came(), 0u);
}

/// True probabilities as forecasts: each bin occurs as often as forecast, and the score beats the base rate.
TEST(Scorer, TrueProbabilitiesAreReliable) {
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
  const std::string text = to_text(scorer.score());
  EXPECT_EQ(text.find("baseline, 20000 of 30 s "), 0u) << text;
  EXPECT_NE(text.find("log-loss"), std::string::npos);
  EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 1 + 10 + 1 + 1 + 1) << "a line for each decile\n" << text;
  EXPECT_NE(text.find("goals by own memory"), std::string::npos);
  EXPECT_EQ(to_json(scorer.score())["entries"][0]["score"]["bins"].size(), 10u);
}

}  // namespace
}  // namespace robot::foreseeing
