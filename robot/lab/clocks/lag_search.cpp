#include "robot/lab/clocks/lag_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "robot/lab/clocks/lag_profile.h"

namespace robot::lab {
namespace {

constexpr double kCoarseStep = 0.1;        // [s] a kick lasts longer
constexpr double kFineStep = 0.02;         // [s]
constexpr double kReach = 0.3;             // [s] of the fine search, and of "the same lag"
constexpr double kBlock = 2;               // [s] of the bootstrap; errors of beliefs last shorter
constexpr std::size_t kCellsInBlock = 4;   // of the fine search
constexpr std::size_t kMostBlocks = 120;   // of the coarse search
constexpr double kMostValues = 3000;       // likewise
constexpr std::size_t kLeastValues = 150;  // at 10 a second: 15 s
constexpr double kCertain = 0.95;          // share of the bootstrap samples that agree
constexpr double kBetweenLags = 0.001;     // [s] error of the parabola between the lags of the fine search

/// Few kicks carry the information, so the bootstrap finds too small a deviation. Without this factor its 95 % interval
/// covers 91 % (bench_truth_offset).
constexpr double kFewKicks = 1.2;

Error not_certain() {
  return {"the ball was not kicked or moved fast enough; kick it a few times or lift it three times at the start"};
}

/// Returns the best lags of bootstrap samples. A sample without a best lag has none.
std::vector<double> bootstrap(const LagProfile& profile, std::size_t cells_in_block, int samples) {
  std::mt19937 random(1);  // the same recording gives the same deviation
  std::vector<double> lags;
  const std::size_t cells = profile.cells().count();
  for (int sample = 0; sample < samples; ++sample) {
    std::vector<double> times(cells, 0);
    for (std::size_t drawn = 0; drawn < cells; drawn += cells_in_block) {
      const std::size_t first = random() % cells;
      for (std::size_t i = 0; i < cells_in_block; ++i) ++times[(first + i) % cells];
    }
    if (const auto lag = best_lag(profile.lags(), profile.gains(times))) lags.push_back(*lag);
  }
  return lags;
}

/// Returns the distance with at most one value in each interval [s].
SharedDistance thinned(SharedDistance distance, double interval) {
  double last = -INFINITY;
  std::erase_if(distance.seen, [&](const Sample& sample) {
    if (sample.at - last < interval) return true;
    last = sample.at;
    return false;
  });
  return distance;
}

LagProfile coarse_profile(const SharedDistance& distance, const LagRange& range) {
  const double reach = std::clamp(range.reach, 2 * kReach, kLongestReach);
  // a tenth of a second is fine enough, and more for a long recording
  SharedDistance few = thinned(distance, kCoarseStep);
  const double parts = static_cast<double>(few.seen.size()) / kMostValues;
  if (parts > 1) few = thinned(std::move(few), parts * kCoarseStep);
  Cells cells(few.seen, kBlock, kMostBlocks);
  return {few, Lags::around(range.middle, reach, kCoarseStep), std::move(cells), LagProfile::Everywhere::no};
}

LagProfile fine_profile(const SharedDistance& distance, double around) {
  Cells cells(distance.seen, kBlock / static_cast<double>(kCellsInBlock), distance.seen.size());
  return {with_measured_noise(distance, around), Lags::around(around, kReach, kFineStep), std::move(cells),
          LagProfile::Everywhere::yes};
}

/// Returns the standard deviation of the lags.
double spread_of(const std::vector<double>& lags) {
  double sum = 0, squares = 0;
  for (const double lag : lags) sum += lag;
  const auto count = static_cast<double>(lags.size());
  for (const double lag : lags) squares += (lag - sum / count) * (lag - sum / count);
  return std::sqrt(squares / count);
}

}  // namespace

Result<CoarseLag> find_coarse_lag(const SharedDistance& distance, const LagRange& range) {
  constexpr int kSamples = 40;
  const LagProfile profile = coarse_profile(distance, range);
  if (profile.values() < kLeastValues)
    return Error{"only " + std::to_string(profile.values()) + " distances of the ball have a truth, expected " +
                 std::to_string(kLeastValues) + " or more, ten a second"};
  const auto gains = profile.gains();
  const auto best = best_lag(profile.lags(), gains);
  if (!best) return not_certain();
  const auto agree = std::ranges::count_if(bootstrap(profile, 1, kSamples),
                                           [&](double lag) { return std::abs(lag - *best) < kReach; });
  if (static_cast<double>(agree) < kCertain * kSamples) return not_certain();
  return CoarseLag{.seconds = *best, .gain = *std::ranges::max_element(gains)};
}

Result<Lag> refined_lag(const SharedDistance& distance, double coarse, double largest) {
  constexpr int kSamples = 200;
  // the noise, and the values that count, follow from the lag, so the second profile is the better one
  const LagProfile first = fine_profile(distance, coarse);
  const auto better = best_lag(first.lags(), first.gains());
  if (!better) return not_certain();
  const LagProfile profile = fine_profile(distance, *better);
  const auto best = best_lag(profile.lags(), profile.gains());
  if (!best) return not_certain();
  const auto lags = bootstrap(profile, kCellsInBlock, kSamples);
  if (static_cast<double>(lags.size()) < kCertain * kSamples) return not_certain();
  const double deviation = std::hypot(kFewKicks * spread_of(lags), kBetweenLags);
  if (deviation > largest) return not_certain();
  return Lag{.seconds = *best, .deviation = deviation};
}

}  // namespace robot::lab
