#include "sim/drills/trials.h"

#include <gtest/gtest.h>

namespace sim::drills {
namespace {

TEST(Trials, DependOnDrillAndOptionsOnly) {
  const auto drill = load_drill("empty_goal");
  ASSERT_TRUE(drill);
  const auto first = run_trials(*drill, {.trials = 60, .seed = 5}),
             second = run_trials(*drill, {.trials = 60, .seed = 5});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->succeeded, second->succeeded);
  EXPECT_EQ(first->score.mean, second->score.mean);
  // two halves are the whole
  const auto half = run_trials(*drill, {.trials = 30, .seed = 5}),
             other = run_trials(*drill, {.trials = 30, .seed = 35});
  ASSERT_TRUE(half && other);
  EXPECT_EQ(first->succeeded, half->succeeded + other->succeeded);
}

TEST(Trials, EachEndsInOneWayAndTheIntervalHoldsTheShare) {
  const auto drill = load_drill("counter_attack");
  ASSERT_TRUE(drill);
  const auto trials = run_trials(*drill, {.trials = 80});
  ASSERT_TRUE(trials);
  EXPECT_EQ(trials->successes + trials->failures + trials->times_over, 80);
  EXPECT_EQ(trials->succeeded, trials->successes + trials->times_over);
  EXPECT_LE(trials->interval.low, trials->share());
  EXPECT_GE(trials->interval.high, trials->share());
}

TEST(Trials, AStrategyThatDoesNothingDoesNotScore) {
  const auto drill = load_drill("empty_goal");
  ASSERT_TRUE(drill);
  const auto idle = run_trials(*drill, {.strategy = "idle", .trials = 50});
  const auto plays = run_trials(*drill, {.trials = 50});
  ASSERT_TRUE(idle && plays);
  EXPECT_EQ(idle->succeeded, 0);
  EXPECT_GT(plays->succeeded, 15);
}

TEST(Trials, AnUnknownStrategyIsASentence) {
  const auto drill = load_drill("empty_goal");
  ASSERT_TRUE(drill);
  EXPECT_EQ(run_trials(*drill, {.strategy = "baselin"}).error(), "no strategy 'baselin'; did you mean 'baseline'?");
}

}  // namespace
}  // namespace sim::drills
