// Sequential tests on pairs drawn with replacement from played ones, with a planted gain.
//
//   bench_verdicts TESTS < pool      each line of the pool: the gain of a pair, and the number of pairs with it
//
// A gain is planted by the sign: larger gains stay as rare as they are, and the metric stays as it is. Prints one line of JSON.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "sim/compare/verdict.h"
#include "sim/math/random.h"

namespace {

using namespace sim::compare;

/// Sizes of the gains of the pool's pairs.
std::vector<int> read_pool() {
  std::vector<int> sizes;
  int gain = 0, count = 0;
  while (std::scanf("%d %d", &gain, &count) == 2)
    sizes.insert(sizes.end(), static_cast<std::size_t>(count), std::abs(gain));
  return sizes;
}

/// The gains of a pool whose mean is `effect` standard deviations.
struct Planted {
  const std::vector<int>& sizes;
  double chance_of_plus, mean;

  Planted(const std::vector<int>& all, double effect) : sizes(all) {
    double sum = 0, squares = 0;
    for (const int size : sizes) sum += size, squares += static_cast<double>(size) * size;
    const auto count = static_cast<double>(sizes.size());
    mean = effect * std::sqrt(squares / count / (1 + effect * effect));
    chance_of_plus = 0.5 + mean / (2 * sum / count);
  }

  Pair draw_pair(std::uint64_t test, std::uint32_t number) const {
    const auto words = sim::draw({.seed = test}, sim::kNobody, sim::Draw::situation, number);
    const int size = sizes[words[0] % sizes.size()];
    Pair pair;
    pair.games[0].gain = static_cast<double>(sim::uniform(words[1])) < chance_of_plus ? size : -size;
    return pair;
  }
};

struct Rates {
  double better = 0, not_better = 0, too_rare = 0, covered = 0, above = 0, pairs = 0;
};

Rates rates_of(const Planted& planted, std::uint64_t tests) {
  constexpr int kBlock = 25;  // as the games are played
  const Hypothesis question{.part = kUsualPart};
  Rates rates;
  for (std::uint64_t test = 0; test < tests; ++test) {
    PairStatistics statistics;
    Verdict verdict = Verdict::undecided;
    for (std::uint32_t i = 0; verdict == Verdict::undecided; ++i) {
      statistics.add(planted.draw_pair(test, i));
      if (statistics.pairs % kBlock == 0) verdict = decide(statistics, question);
    }
    rates.better += verdict == Verdict::better, rates.not_better += verdict == Verdict::not_better;
    rates.pairs += static_cast<double>(statistics.pairs);
    if (verdict == Verdict::too_rare) {
      ++rates.too_rare;
      continue;
    }
    const Interval found = unbiased_gain(statistics, question);
    rates.covered += found.low <= planted.mean / 2 && planted.mean / 2 <= found.high;
    rates.above += found.mean > planted.mean / 2;
  }
  const double answers = static_cast<double>(tests) - rates.too_rare;
  rates.covered /= answers, rates.above /= answers;
  for (double* const rate : {&rates.better, &rates.not_better, &rates.too_rare, &rates.pairs})
    *rate /= static_cast<double>(tests);
  return rates;
}

void print(const char* name, const Rates& rates, const char* behind) {
  std::printf(
      "\"%s\": {\"better\": %g, \"not_better\": %g, \"too_rare\": %g, \"covered\": %g, \"above\": %g, "
      "\"pairs\": %g}%s",
      name, rates.better, rates.not_better, rates.too_rare, rates.covered, rates.above, rates.pairs, behind);
}

}  // namespace

int main(int count, char** words) {
  const std::uint64_t tests = count == 2 ? std::strtoull(words[1], nullptr, 10) : 0;
  const std::vector<int> pool = read_pool();
  double sum = 0;
  for (const int size : pool) sum += size;
  if (tests == 0 || sum == 0) {
    std::fputs("bench_verdicts: expected a number of tests, and a pool in which a pair has a gain\n", stderr);
    return 2;
  }
  std::printf("{");
  print("none", rates_of(Planted(pool, 0), tests), ", ");
  print("planted", rates_of(Planted(pool, kUsualPart), tests), "}\n");
  return 0;
}
