#include "sim/contest/series.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

namespace sim::contest {
namespace {

TEST(Series, PlaysEachGameOnceForAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7}) {
    constexpr int kGames = 100;
    std::atomic<int> played[kGames] = {};
    for_each_game(kGames, threads, [&](int game) { ++played[game]; });
    for (const auto& count : played) EXPECT_EQ(count, 1);
  }
}

TEST(Series, ReportsProgressUpToTheNumberOfGames) {
  std::vector<int> reported;
  for_each_game(
      5, 1, [](int) {}, [&](int done) { reported.push_back(done); });
  EXPECT_EQ(reported, (std::vector<int>{1, 2, 3, 4, 5}));
}

TEST(Series, KeepsTheFirstProblem) {
  Problem problem;
  EXPECT_FALSE(problem.is_known());
  problem.tell("first");
  problem.tell("second");
  EXPECT_TRUE(problem.is_known());
  EXPECT_EQ(problem.text(), "first");
}

TEST(Series, MeansHaveKnownAnswers) {
  EXPECT_EQ(mean_of({}).mean, 0);
  EXPECT_EQ(mean_of({7}).mean, 7);
  EXPECT_EQ(mean_of({7}).error, 0);
  EXPECT_DOUBLE_EQ(mean_of({1, 2, 3, 4}).mean, 2.5);
  EXPECT_DOUBLE_EQ(mean_of({1, 2, 3, 4}).error, std::sqrt(5. / 3 / 4));
}

TEST(Series, MediansHaveKnownAnswersInAnyOrder) {
  EXPECT_EQ(median_of({}), 0);
  EXPECT_EQ(median_of({4}), 4);
  EXPECT_EQ(median_of({9, 1, 5}), 5);
  EXPECT_EQ(median_of({9, 1, 5, 2}), 3.5);
}

}  // namespace
}  // namespace sim::contest
