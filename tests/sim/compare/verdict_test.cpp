#include "sim/compare/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <vector>

#include "sim/math/random.h"

namespace sim::compare {
namespace {

/// Makes a pair with these gains of B in its two games.
Pair pair_of(int first, int second) {
  Pair pair;
  pair.games[0] = {.gain = first, .goals = {1, 1 + first}, .conceded = {1 + first, 1}};
  pair.games[1] = {.gain = second, .goals = {1, 1 + second}, .conceded = {1 + second, 1}};
  return pair;
}

PairStatistics statistics_of(const std::vector<Pair>& pairs) {
  PairStatistics statistics;
  for (const Pair& pair : pairs) statistics.add(pair);
  return statistics;
}

TEST(PairStatistics, AreEqualInAnyOrderAndAnyParts) {
  std::vector<Pair> pairs;
  for (int i = 0; i < 100; ++i) pairs.push_back(pair_of(i * 7 % 5 - 2, i * 11 % 7 - 3));
  const PairStatistics whole = statistics_of(pairs);
  PairStatistics parts;
  parts.add(statistics_of({pairs.begin() + 63, pairs.end()}));
  parts.add(statistics_of({pairs.begin(), pairs.begin() + 63}));
  EXPECT_EQ(parts, whole);
  EXPECT_EQ(statistics_of({pairs.rbegin(), pairs.rend()}), whole);
  EXPECT_EQ(whole.won + whole.drawn + whole.lost, 200);
  EXPECT_EQ(whole.points[0] + whole.points[1] + whole.points[2] + whole.points[3] + whole.points[4], 100);
  // a pair won and drawn is 3 points
  EXPECT_EQ(statistics_of({pair_of(1, 0)}).points[3], 1);
}

TEST(Gain, IsTheMeanPerGameWithStudentsInterval) {
  // 31 pairs whose sums are 0, 2, .. 60: mean 30, variance 4 * 31 * 32 / 12; t of 30 degrees is 2.0423
  PairStatistics statistics;
  for (int i = 0; i < 31; ++i) statistics.add(pair_of(i, i));
  const Interval gain = gain_per_game(statistics);
  EXPECT_DOUBLE_EQ(gain.mean, 15);
  EXPECT_NEAR(gain.high - gain.mean, 2.0423 * std::sqrt(4 * 31 * 32 / 12.0 / 31) / 2, 1e-3);
  EXPECT_NEAR(gain.mean - gain.low, gain.high - gain.mean, 1e-12);
  EXPECT_DOUBLE_EQ(gain_per_game(statistics, 1000).mean, 0.015);
}

TEST(Gain, IsUnknownWithoutPairs) {
  EXPECT_EQ(gain_per_game({}).high, HUGE_VAL);
  EXPECT_EQ(gain_per_game(statistics_of({pair_of(1, 0)})).low, -HUGE_VAL);
}

TEST(HomeAdvantage, IsTheGainOfBothAtHome) {
  // B wins by one at home and loses by one away, again and again: no gain, and an advantage of one goal
  const PairStatistics statistics = statistics_of(std::vector(60, pair_of(-1, 1)));
  EXPECT_DOUBLE_EQ(gain_per_game(statistics).mean, 0);
  EXPECT_DOUBLE_EQ(home_advantage(statistics).mean, 1);
  EXPECT_DOUBLE_EQ(home_advantage(statistics).low, 1);
}

TEST(PairingGain, IsTheShareOfTheVarianceThatPairsRemove) {
  // independent games of variance 1: all four combinations equally often
  EXPECT_NEAR(pairing_gain(statistics_of({pair_of(1, 1), pair_of(1, -1), pair_of(-1, 1), pair_of(-1, -1)})), 1, 1e-12);
  // luck of +-3 that favours an end, and +-1 of the game's own: var 10 a game, of the pair's mean 0.5
  std::vector<Pair> pairs;
  for (const int luck : {-3, 3})
    for (const int first : {-1, 1})
      for (const int second : {-1, 1}) pairs.push_back(pair_of(luck + first, -luck + second));
  EXPECT_NEAR(pairing_gain(statistics_of(pairs)), 10, 1e-12);
  EXPECT_EQ(pairing_gain(statistics_of(std::vector(9, pair_of(-1, 1)))), 0);
}

TEST(Llr, IsTheRatioForEqualVariances) {
  // N = 100, mean 0.05 in the middle of the two: neither is likelier
  std::vector<Pair> pairs(55, pair_of(1, 1));
  pairs.insert(pairs.end(), 45, pair_of(-1, -1));
  pairs.insert(pairs.end(), 100, pair_of(0, 0));
  EXPECT_NEAR(llr(statistics_of(pairs), {}), 0, 1e-12);
  // and twice as good: N (h1 - h0) (2 mean - h0 - h1) / (2 variance)
  const PairStatistics better = statistics_of({pair_of(1, 0), pair_of(0, 0), pair_of(1, 1), pair_of(-1, 0)});
  const double variance = pair_variance(better);
  EXPECT_NEAR(llr(better, {}), 4 * 0.1 * (2 * 0.25 - 0.1) / (2 * variance), 1e-12);
  EXPECT_NEAR(bounds_of({}).h1, 2.944, 1e-3);
  EXPECT_NEAR(bounds_of({}).h0, -2.944, 1e-3);
}

/// Makes a pair in which B played what A played.
Pair same_pair(int first) {
  Pair pair = pair_of(first, -first);
  pair.same = true;
  return pair;
}

TEST(Decide, ABehaviourAgainstItselfIsIdentical) {
  EXPECT_EQ(decide(statistics_of(std::vector(50, same_pair(2))), {}), Verdict::identical);
  EXPECT_EQ(decide(statistics_of(std::vector(49, same_pair(2))), {}), Verdict::undecided);
  EXPECT_EQ(judge(statistics_of(std::vector(50, same_pair(2))), {}), Verdict::identical);
  // a constant gain has no variance either, but is a gain
  EXPECT_EQ(decide(statistics_of(std::vector(50, pair_of(1, 1))), {}), Verdict::better);
  EXPECT_EQ(decide(statistics_of(std::vector(50, pair_of(-1, -1))), {}), Verdict::not_better);
}

TEST(Decide, DifferentGamesWithAlmostNoGainAreTooRareAndNeverIdentical) {
  std::vector<Pair> pairs(999, pair_of(0, 0));
  pairs.resize(990);
  pairs.insert(pairs.end(), 9, pair_of(1, 0));
  EXPECT_EQ(decide(statistics_of(pairs), {}), Verdict::undecided) << "999 pairs: it plays on";
  EXPECT_EQ(judge(statistics_of(pairs), {}), Verdict::too_rare);
  pairs.push_back(pair_of(0, 0));
  EXPECT_EQ(statistics_of(pairs).uneven, 9);
  EXPECT_EQ(decide(statistics_of(pairs), {}), Verdict::too_rare);
  EXPECT_EQ(decide(statistics_of(std::vector(1000, pair_of(-2, 2))), {}), Verdict::too_rare);
  EXPECT_EQ(judge(statistics_of(std::vector(4, pair_of(1, 1))), {}), Verdict::undecided)
      << "few pairs, not a rare gain";
}

TEST(Asked, IsAPartOfTheStandardDeviationInAnyUnit) {
  // the sums of pairs are +-2: per game +-1
  std::vector<Pair> pairs(50, pair_of(1, 1));
  pairs.insert(pairs.end(), 50, pair_of(-1, -1));
  const double deviation = std::sqrt(100 / 99.);
  EXPECT_NEAR(asked({.part = 0.1}, statistics_of(pairs)).h1, 0.1 * deviation, 1e-12);
  EXPECT_NEAR(asked({.h0 = 0.5, .part = 0.1}, statistics_of(pairs), 100).h1, 0.5 + 0.001 * deviation, 1e-12);
  EXPECT_EQ(asked({.h1 = 0.3}, statistics_of(pairs)).h1, 0.3);
  // the ratio is the same in any unit
  pairs.insert(pairs.end(), 20, pair_of(1, 1));
  EXPECT_NEAR(llr(statistics_of(pairs), {.part = 0.1}, 1), llr(statistics_of(pairs), {.part = 0.1}, 100), 1e-12);
}

TEST(Judge, UsesTheInterval) {
  std::vector<Pair> pairs(300, pair_of(1, 0));
  pairs.insert(pairs.end(), 300, pair_of(0, -1));
  EXPECT_EQ(judge(statistics_of(pairs), {}), Verdict::not_better);  // 0 +- 0.04 does not reach 0.1
  pairs.insert(pairs.end(), 300, pair_of(1, 0));
  EXPECT_EQ(judge(statistics_of(pairs), {}), Verdict::better);
  pairs.resize(20);
  pairs.insert(pairs.end(), 21, pair_of(0, -1));
  EXPECT_EQ(judge(statistics_of(pairs), {}), Verdict::undecided);
}

// the table of sample sizes behind the figures of comparisons: variance 4 a game, 0.1 goals
TEST(Plan, GivesTheNumberOfPairs) {
  const Plan four = plan(4, 0.1);
  EXPECT_NEAR(four.fixed_80, 3140, 1);
  EXPECT_NEAR(four.fixed_95, 5198, 1);
  EXPECT_NEAR(four.sequential, 2120, 1);
  EXPECT_NEAR(four.sequential_worst, 3468, 2);
}

/// Returns how often `tests` sequential tests say "better". The gain per game has the mean `gain` and a standard deviation
/// of about 1.2 goals. A test looks after every `block` pairs.
double part_better(double gain, int tests, int block) {
  int better = 0;
  for (int test = 0; test < tests; ++test) {
    PairStatistics statistics;
    Verdict verdict = Verdict::undecided;
    for (std::uint32_t i = 0; verdict == Verdict::undecided && i < 100'000; ++i) {
      const auto words = draw({.seed = static_cast<std::uint64_t>(test)}, kNobody, Draw::situation, i);
      const int noise = static_cast<int>(words[0] % 5) - 2 + static_cast<int>(words[1] % 5) - 2;
      const int shift = static_cast<double>(uniform(words[2])) < 2 * gain ? 1 : 0;
      statistics.add(pair_of(noise, shift));
      if (statistics.pairs % block == 0) verdict = decide(statistics, {});
    }
    if (verdict == Verdict::better) ++better;
  }
  return static_cast<double>(better) / tests;
}

TEST(Decide, ErrsAsOftenAsStated) {
  constexpr int kBlock = 25;  // as the games are played
  EXPECT_LE(part_better(0, 3000, kBlock), 0.05);
  EXPECT_NEAR(part_better(0.1, 3000, kBlock), 0.95, 0.02);
  EXPECT_GE(part_better(0.2, 500, kBlock), 0.99);
}

// 1000 pairs of align_first against baseline, spl2012, models match, seeds 1 .. 1000: number of pairs that gained -7, -6, ..
constexpr int kLeastGain = -7;
constexpr int kPlayed[] = {3, 4, 29, 68, 101, 140, 174, 166, 140, 101, 44, 23, 5, 0, 2};

/// Gains of those pairs in thousandths of a goal, moved so that their mean per game is `gain`.
std::vector<int> played_pairs(double gain) {
  std::vector<int> sums;
  double mean = 0;
  for (std::size_t i = 0; i < std::size(kPlayed); ++i)
    for (int pair = 0; pair < kPlayed[i]; ++pair)
      sums.push_back(1000 * (kLeastGain + static_cast<int>(i))), mean += sums.back();
  mean /= static_cast<double>(sums.size());
  for (int& sum : sums) sum += static_cast<int>(std::lround(2000 * gain - mean));
  return sums;
}

/// Runs a sequential test on pairs drawn from these with replacement. Returns its statistics at the verdict.
PairStatistics resampled(const std::vector<int>& sums, std::uint64_t test, Verdict& verdict) {
  PairStatistics statistics;
  verdict = Verdict::undecided;
  for (std::uint32_t i = 0; verdict == Verdict::undecided; ++i) {
    const auto words = draw({.seed = test}, kNobody, Draw::situation, i);
    statistics.add(pair_of(sums[words[0] % sums.size()], 0));
    if (statistics.pairs % 25 == 0) verdict = decide(statistics, {}, 1000);
  }
  return statistics;
}

TEST(Decide, ErrsAsOftenAsStatedOnPlayedPairs) {
  const auto part_of = [](double gain) {
    const std::vector<int> sums = played_pairs(gain);
    int better = 0;
    for (std::uint64_t test = 0; test < 1000; ++test) {
      Verdict verdict;
      resampled(sums, test, verdict);
      better += verdict == Verdict::better;
    }
    return better / 1000.0;
  };
  EXPECT_LE(part_of(0), 0.05);
  EXPECT_NEAR(part_of(0.1), 0.95, 0.02);
}

/// The result of tests of a gain that is 1, 0 or -1 per pair.
struct Rates {
  double better = 0, too_rare = 0, covered = 0, pairs = 0;
};

/// Runs usual tests. A pair has a gain with the probability `chance`; its mean is `effect` standard deviations.
Rates rates_of(double chance, double effect) {
  constexpr int kTests = 1000, kIntervals = 200;
  const double mean = effect * std::sqrt(chance / (1 + effect * effect)), up = (chance + mean) / 2;
  const Hypothesis question{.part = kUsualPart};
  Rates rates;
  int intervals = 0;
  for (std::uint64_t test = 0; test < kTests; ++test) {
    PairStatistics statistics;
    Verdict verdict = Verdict::undecided;
    for (std::uint32_t i = 0; verdict == Verdict::undecided; ++i) {
      const double drawn = static_cast<double>(uniform(draw({.seed = test}, kNobody, Draw::situation, i)[0]));
      statistics.add(pair_of(drawn < up ? 1 : drawn < chance ? -1 : 0, 0));
      if (statistics.pairs % 25 == 0) verdict = decide(statistics, question);
    }
    rates.better += verdict == Verdict::better;
    rates.too_rare += verdict == Verdict::too_rare;
    rates.pairs += static_cast<double>(statistics.pairs);
    if (verdict == Verdict::too_rare || intervals >= kIntervals) continue;
    ++intervals;
    const Interval found = unbiased_gain(statistics, question);
    rates.covered += found.low <= mean / 2 && mean / 2 <= found.high;
  }
  rates.covered /= intervals;
  for (double* const rate : {&rates.better, &rates.too_rare, &rates.pairs}) *rate /= kTests;
  return rates;
}

// a metric of chances: the usual question errs as often as for goals, however rare they are
TEST(Decide, ErrsAsOftenAsStatedForTheUsualQuestionOfAnyMetric) {
  for (const double chance : {0.5, 0.2, 0.05, 0.02}) {
    const Rates none = rates_of(chance, 0), asked_for = rates_of(chance, kUsualPart);
    EXPECT_LE(none.better, 0.05) << chance;
    EXPECT_GE(asked_for.better, 0.9) << chance;
    EXPECT_LE(none.too_rare, 0.02) << chance;
    EXPECT_GE(none.covered, 0.92) << chance;
    EXPECT_GE(asked_for.covered, 0.92) << chance;
    EXPECT_LE(none.pairs, 1000) << chance;
  }
  EXPECT_GE(rates_of(0.005, 0).too_rare, 0.9);
}

TEST(UnbiasedGain, IsAsOftenTooHighAsTooLowAndCoversTheTruth) {
  for (const double gain : {0., 0.05, 0.1, 0.2}) {
    const std::vector<int> sums = played_pairs(gain);
    constexpr int kTests = 400;
    int above = 0, plainly_above = 0, covered = 0;
    for (std::uint64_t test = 0; test < kTests; ++test) {
      Verdict verdict;
      const PairStatistics statistics = resampled(sums, test, verdict);
      const Interval found = unbiased_gain(statistics, {}, 1000);
      EXPECT_LT(found.low, found.mean);
      EXPECT_LT(found.mean, found.high);
      above += found.mean > gain;
      plainly_above += gain_per_game(statistics, 1000).mean > gain;
      covered += found.low <= gain && gain <= found.high;
    }
    // the plain mean is off by up to 10 % more
    EXPECT_NEAR(above / double{kTests}, 0.5, 0.06) << gain << ", plain mean: " << plainly_above / double{kTests};
    EXPECT_NEAR(covered / double{kTests}, 0.95, 0.025) << gain;
  }
}

}  // namespace
}  // namespace sim::compare
