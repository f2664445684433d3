#include "robot/foresight/wording.h"

#include <gtest/gtest.h>

namespace robot::foreseeing {
namespace {

/// Returns a forecast of three strategies in which baseline is the best and each gain is `gain` ± `reach`.
pb::Forecast forecast_of_gain(float gain, float reach) {
  pb::Forecast forecast;
  forecast.set_reason("keeps baseline: passing would gain 0.30 ± 0.40 goals, which may be chance (100 futures)");
  for (const char* name : {"baseline", "kick_now", "passing"}) {
    forecast.mutable_question()->add_strategies(name);
    pb::Forecast::StrategyForecast& told = *forecast.add_strategies();
    told.set_strategy(name);
    told.set_rollouts(100);
    told.set_gain(gain);
    told.set_gain_low(gain - reach);
    told.set_gain_high(gain + reach);
  }
  return forecast;
}

TEST(Wording, AReturnToTheDefaultNamesTheForecastOfThePlayedStrategy) {
  const auto back = [](float gain, float reach) {
    return reason_of(forecast_of_gain(gain, reach), "kick_now", "baseline");
  };
  EXPECT_EQ(back(0.25f, 0.5f),
            "back to baseline: kick_now would gain 0.25 ± 0.50 goals, which may be chance (100 futures)");
  EXPECT_EQ(back(0.25f, 0.125f),
            "back to baseline: kick_now would gain 0.25 ± 0.12 goals, too little to be worth it (100 futures)");
  EXPECT_EQ(back(-0.25f, 0.5f),
            "back to baseline: kick_now does not look better, with 0.25 ± 0.50 goals less (100 futures)");
  EXPECT_EQ(back(-0.75f, 0.5f), "back to baseline: kick_now would lose 0.75 ± 0.50 goals (100 futures)");
  EXPECT_EQ(reason_of(forecast_of_gain(0, 1), "old", "baseline"), "back to baseline: old was not asked about");
}

TEST(Wording, NoDifferenceIsASentenceInsteadOfZeros) {
  EXPECT_EQ(reason_of(forecast_of_gain(0, 0), "kick_now", "baseline"),
            "back to baseline: no difference from kick_now was seen in 100 futures");
  EXPECT_EQ(reason_of(forecast_of_gain(0.002f, 0.004f), "kick_now", "kick_now"),
            "stays with kick_now: no difference from baseline was seen in 100 futures");
}

TEST(Wording, StayingWithTheDefaultGivesTheForecastsReason) {
  EXPECT_EQ(reason_of(forecast_of_gain(0.25f, 0.5f), "baseline", "baseline"), forecast_of_gain(0, 0).reason());
}

TEST(Wording, AChangeNamesThePlayedStrategy) {
  EXPECT_EQ(reason_of(forecast_of_gain(0.75f, 0.5f), "kick_now", "passing"),
            "changes from kick_now to passing: that gains 0.75 ± 0.50 goals over baseline (100 futures)");
  EXPECT_EQ(reason_of(forecast_of_gain(0.75f, 0.5f), "kick_now", "kick_now"),
            "stays with kick_now: that gains 0.75 ± 0.50 goals over baseline (100 futures)");
}

TEST(Wording, AnotherMeasureHasAnotherUnit) {
  pb::Forecast forecast = forecast_of_gain(0.25f, 0.125f);
  forecast.mutable_question()->set_measure(pb::WhatIf::MEASURE_SCORE_NEXT);
  EXPECT_EQ(reason_of(forecast, "baseline", "passing"),
            "changes from baseline to passing: that gains 0.25 ± 0.12 in probability over baseline (100 futures)");
}

}  // namespace
}  // namespace robot::foreseeing
