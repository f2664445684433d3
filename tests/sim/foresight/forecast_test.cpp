#include "sim/foresight/forecast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "sim/foresight/race.h"

namespace sim::foresight {
namespace {

constexpr RandomKey kKey{.seed = 7};
const std::string kNames[] = {"baseline", "passing", "kick_now", "idle"};

/// The statistics of values by stripe and strategy; all race to the end.
RolloutStatistics statistics_of(const std::vector<std::vector<double>>& stripes) {
  RolloutStatistics statistics;
  statistics.strategies = static_cast<int>(stripes.front().size());
  for (const std::vector<double>& values : stripes) {
    ++statistics.stripes;
    for (std::size_t i = 0; i < values.size(); ++i) {
      StrategyStatistics& strategy = statistics.by_strategy[i];
      ++strategy.rollouts;
      strategy.sum += values[i];
      strategy.squares += values[i] * values[i];
      for (std::size_t j = 0; j < values.size(); ++j) {
        statistics.gains[i][j] += values[i] - values[0];
        statistics.products[i][j] += (values[i] - values[0]) * (values[j] - values[0]);
      }
    }
  }
  return statistics;
}

/// Draws stripes with values round `means`. All strategies share the luck of a stripe.
std::vector<std::vector<double>> drawn(const std::vector<double>& means, int stripes, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> values;
  for (int n = 0; n < stripes; ++n) {
    const double luck = normal(random);
    std::vector<double>& stripe = values.emplace_back();
    for (const double mean : means) stripe.push_back(mean + luck + 0.3 * normal(random));
  }
  return values;
}

TEST(Forecast, MeansAndErrorsComeFromTheStripes) {
  const Forecast told = forecast(statistics_of({{0, 1}, {1, 1}, {0, 0}, {1, 2}}), {}, kKey);
  EXPECT_EQ(told.standings[0].rollouts, 4);
  EXPECT_DOUBLE_EQ(told.standings[0].mean, 0.5);
  EXPECT_DOUBLE_EQ(told.standings[1].mean, 1);
  // squares about the mean 0.5: 4 x 0.25; over 3 degrees and 4 values, and one more that is 0.5 aside
  EXPECT_DOUBLE_EQ(told.standings[0].error, std::sqrt((1. / 3 + 0.25 / 4) / 4));
  EXPECT_DOUBLE_EQ(told.standings[1].gain, 0.5);
  // gains 1 0 0 1: as above, t of 3 degrees 3.182
  EXPECT_NEAR(told.standings[1].gain_high - 0.5, 3.182 * std::sqrt((1. / 3 + 0.25 / 4) / 4), 0.02);
  EXPECT_NEAR(told.standings[1].gain_low + told.standings[1].gain_high, 1, 1e-12);
}

TEST(Forecast, StudentsQuantilesEqualTheTables) {
  EXPECT_NEAR(student(0.975, 3), 3.182, 0.032);
  EXPECT_NEAR(student(0.975, 7), 2.365, 0.003);
  EXPECT_NEAR(student(0.975, 30), 2.042, 0.001);
  EXPECT_NEAR(student(0.975, 1e9), 1.960, 0.001);
  EXPECT_NEAR(student(0.9, 7), 1.415, 0.002);
  EXPECT_NEAR(student(0.9, 30), 1.310, 0.001);
  EXPECT_NEAR(student(0.8, 30), 0.854, 0.001);
  EXPECT_NEAR(student(0.5, 30), 0, 0.001);
}

TEST(Forecast, ChangesWhenTheGainIsSure) {
  const Forecast told = forecast(statistics_of(drawn({0, 0.3}, 100, 1)), {}, kKey);
  EXPECT_EQ(told.advice, Forecast::Advice::change);
  EXPECT_EQ(told.choice, 1);
  EXPECT_GT(told.standings[1].best, 0.99);
  const std::string why = reason(told, {}, kNames);
  EXPECT_EQ(why.find("changes from baseline to passing: that gains 0.3"), 0u) << why;
}

TEST(Forecast, KeepsTheIncumbentWhenChanceMayExplainTheGain) {
  const Forecast told = forecast(statistics_of(drawn({0, 0}, 100, 2)), {}, kKey);
  EXPECT_EQ(told.advice, Forecast::Advice::keep);
  EXPECT_EQ(told.choice, 0);
  const std::string why = reason(told, {}, kNames);
  EXPECT_NE(why.find(told.standings[1].gain > 0 ? "which may be chance (100 futures)" : "nothing else looks better"),
            std::string::npos)
      << why;
}

TEST(Forecast, AChangeHasToPayForItself) {
  const RolloutStatistics statistics = statistics_of(drawn({0, 0.3}, 100, 1));
  const Forecast told = forecast(statistics, {.switching_cost = 0.4f}, kKey);
  EXPECT_EQ(told.advice, Forecast::Advice::keep);
  EXPECT_NE(reason(told, {.switching_cost = 0.4f}, kNames).find("too little for a change, which costs 0.40"),
            std::string::npos);
}

TEST(Forecast, ATieIsReportedAsATie) {
  // the same in each stripe: no reason to change, but chance may have been quiet
  const Forecast told = forecast(statistics_of(std::vector<std::vector<double>>(50, {1, 1})), {}, kKey);
  EXPECT_EQ(told.advice, Forecast::Advice::keep);
  EXPECT_EQ(told.standings[1].gain, 0);
  EXPECT_EQ(reason(told, {}, kNames), "keeps baseline: passing comes to the same, within 0.02 goals (50 futures)");
  EXPECT_NEAR(told.standings[0].best, 0.5, 0.05);
}

TEST(Forecast, NoDifferenceIsASentenceInsteadOfZeros) {
  const Forecast told = forecast(statistics_of(std::vector<std::vector<double>>(400, {1, 1})), {}, kKey);
  EXPECT_EQ(reason(told, {}, kNames), "keeps baseline: no difference from passing was seen in 400 futures");
}

TEST(Forecast, AnEventAbsentFromAFewRolloutsIsNotImpossible) {
  // of 20 futures without an event, the 95 % interval of its rate reaches 0.12 at most (Jeffreys)
  const Question question{.measure = Measure::concede};
  const Forecast told = forecast(statistics_of(std::vector<std::vector<double>>(20, {0, 0})), question, kKey);
  EXPECT_NEAR(told.standings[1].gain_high, student(0.975, 19) * 0.5 / 20, 1e-9);
  EXPECT_GT(told.standings[0].error, 0);
  EXPECT_LT(told.standings[1].gain_high, 0.12);
}

TEST(Forecast, TheQuestionSetsTheCertainty) {
  // a gain of one standard error has a probability of 0.84: enough for some questions only
  RolloutStatistics statistics = statistics_of(drawn({0, 0}, 50, 6));
  const double error = forecast(statistics, {}, kKey).standings[1].gain_high / student(0.975, 49) -
                       forecast(statistics, {}, kKey).standings[1].gain / student(0.975, 49);
  const double mean = statistics.gains[1][1] / 50;
  statistics.products[1][1] += 50 * (error * error - mean * mean);
  statistics.gains[1][1] = 50 * error;
  EXPECT_EQ(forecast(statistics, {.switching_cost = 0, .sure = 0.8f}, kKey).advice, Forecast::Advice::change);
  EXPECT_EQ(forecast(statistics, {.switching_cost = 0, .sure = 0.9f}, kKey).advice, Forecast::Advice::keep);
}

TEST(Forecast, TooFewRolloutsGiveNoAdvice) {
  const Forecast told = forecast(statistics_of(drawn({0, 5}, kFewestStripes - 1, 3)), {}, kKey);
  EXPECT_EQ(told.advice, Forecast::Advice::none);
  EXPECT_EQ(reason(told, {}, kNames), "no advice: 7 of at least 8 futures were played in the time given");
  EXPECT_EQ(forecast(RolloutStatistics{.strategies = 2}, {}, kKey).advice, Forecast::Advice::none);
  EXPECT_EQ(forecast(statistics_of(drawn({0, 5}, kFewestStripes, 3)), {}, kKey).advice, Forecast::Advice::change);
}

TEST(Forecast, OneStrategyIsKept) {
  const Forecast told = forecast(statistics_of(drawn({0.2}, 20, 4)), {}, kKey);
  EXPECT_EQ(told.advice, Forecast::Advice::keep);
  EXPECT_EQ(reason(told, {}, kNames), "keeps baseline: there is nothing else to play");
}

TEST(Forecast, TheChancesOfBeingTheBestAddUp) {
  const Forecast told = forecast(statistics_of(drawn({0, 0.05, -0.05, 0}, 60, 5)), {}, kKey);
  double all = 0;
  for (int i = 0; i < 4; ++i) all += told.standings[i].best;
  EXPECT_NEAR(all, 1, 1e-9);
}

TEST(Forecast, TheChanceOfBeingTheBestIsThatOfTheNormalDistribution) {
  // gain 1 standard error: better with probability 0.841
  RolloutStatistics statistics = statistics_of(drawn({0, 0}, 50, 6));
  const double error = [&] {
    const double mean = statistics.gains[1][1] / 50;
    return std::sqrt((statistics.products[1][1] - 50 * mean * mean) / 49 / 50);
  }();
  const double mean = statistics.gains[1][1] / 50;
  // moved so that the mean gain is its error
  statistics.products[1][1] += 50 * (error * error - mean * mean);
  statistics.gains[1][1] = 50 * error;
  EXPECT_NEAR(forecast(statistics, {}, kKey).standings[1].best, 0.841, 0.035);
}

TEST(Forecast, TheCertaintyHoldsInTheLongRun) {
  // when none is better, another is chosen in at most 10 % of cases, and in about 10 % without a cost
  int changed = 0, covered = 0;
  constexpr int kCases = 1000;
  for (unsigned n = 0; n < kCases; ++n) {
    const Forecast told = forecast(statistics_of(drawn({0, 0}, 30, 100 + n)), {.switching_cost = 0}, kKey);
    changed += told.advice == Forecast::Advice::change ? 1 : 0;
    covered += told.standings[1].gain_low <= 0 && told.standings[1].gain_high >= 0 ? 1 : 0;
  }
  EXPECT_NEAR(changed / 1000., 0.10, 0.03);
  EXPECT_NEAR(covered / 1000., 0.95, 0.02);
}

TEST(Forecast, ADroppedStrategyIsNotChosen) {
  RolloutStatistics statistics = statistics_of(drawn({0, 0.1, 0.5}, 40, 8));
  statistics.by_strategy[2].racing = false;
  const Forecast told = forecast(statistics, {}, kKey);
  EXPECT_EQ(told.challenger, 1);
  EXPECT_FALSE(told.standings[2].raced_on);
}

}  // namespace
}  // namespace sim::foresight
