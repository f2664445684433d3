#include "robot/lab/clocks/lag_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>

#include "robot/lab/clocks/lag_profile.h"

namespace robot::lab {
namespace {

constexpr double kCoarseStep = 0.1;        // [s] a kick lasts longer
constexpr double kFineStep = 0.02;         // [s]
constexpr double kReach = 0.3;             // [s] of the fine search, and of "the same lag"
constexpr double kBlock = 2;               // [s] of the bootstrap; errors of beliefs last shorter
constexpr std::size_t kCellsInBlock = 4;   // of the fine search
constexpr double kMostBlocks = 120;        // of the coarse search
constexpr double kMostValues = 3000;       // likewise, of each quantity
constexpr std::size_t kLeastValues = 150;  // at 10 a second: 15 s
constexpr double kCertain = 0.95;          // share of the bootstrap samples that agree

/// A recording has few kicks, and these carry the information: the bootstrap finds too small a deviation. Measured by
/// `bench_truth_offset`: without this factor its 95 % interval covers 91 %.
constexpr double kFewKicks = 1.2;

constexpr double kBetweenLags = 0.001;  // [s] error of the parabola between the lags of the fine search

Error not_certain() {
  return {"the ball was not kicked or moved fast enough; kick it a few times or lift it three times at the start"};
}

/// Returns the cells that cover all values of the robot.
Cells cells_of(const std::vector<SharedQuantity>& quantities, double length, double most) {
  double first = 0, last = 0;
  for (bool any = false; const SharedQuantity& quantity : quantities) {
    if (quantity.robot.empty()) continue;
    first = any ? std::min(first, quantity.robot.front().at) : quantity.robot.front().at;
    last = any ? std::max(last, quantity.robot.back().at) : quantity.robot.back().at;
    any = true;
  }
  const double cell = std::max(length, (last - first) / most);
  return {.start = first, .length = cell, .count = static_cast<std::size_t>((last - first) / cell) + 1};
}

/// Returns the best lags of bootstrap samples. Samples without one have none.
std::vector<double> bootstrap(const LagProfile& profile, std::size_t cells_in_block, int samples) {
  std::mt19937 random(1);  // the same recording gives the same deviation
  std::vector<double> lags;
  const std::size_t cells = profile.cells().count;
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

/// Returns the quantity with at most one value in each interval [s].
SharedQuantity thinned(SharedQuantity quantity, double interval) {
  double last = -INFINITY;
  std::erase_if(quantity.robot, [&](const Sample& seen) {
    if (seen.at - last < interval) return true;
    last = seen.at;
    return false;
  });
  return quantity;
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

Result<CoarseLag> find_coarse_lag(const std::vector<SharedQuantity>& quantities, const LagRange& range) {
  constexpr int kSamples = 40;
  const Cells cells = cells_of(quantities, kBlock, kMostBlocks);
  const double length = cells.length * static_cast<double>(cells.count);
  LagProfile profile(Lags::around(range.middle, std::max(range.reach, 2 * kReach), kCoarseStep), cells);
  for (const SharedQuantity& quantity : quantities)
    profile.add(thinned(quantity, std::max(kCoarseStep, length / kMostValues)), false);
  const auto gains = profile.gains();
  std::size_t values = 0;
  for (std::size_t i = 0; i < gains.size(); ++i) values = std::max(values, profile.values(i));
  if (values < kLeastValues)
    return Error{"only " + std::to_string(values) + " values of the robot have a truth of the same time, expected " +
                 std::to_string(kLeastValues) + " or more"};
  const auto best = best_lag(profile.lags(), gains);
  if (!best) return not_certain();
  const auto agree = std::ranges::count_if(bootstrap(profile, 1, kSamples),
                                           [&](double lag) { return std::abs(lag - *best) < kReach; });
  if (static_cast<double>(agree) < kCertain * kSamples) return not_certain();
  return CoarseLag{.seconds = *best, .gain = *std::ranges::max_element(gains)};
}

Result<Lag> refined_lag(const std::vector<SharedQuantity>& quantities, double coarse, double largest) {
  constexpr int kSamples = 200;
  const Cells cells = cells_of(quantities, kBlock / kCellsInBlock, INFINITY);
  std::optional<double> best = coarse;
  // the noise, and the values that count, follow from the lag
  for (int round = 0;; ++round) {
    LagProfile profile(Lags::around(*best, kReach, kFineStep), cells);
    for (const SharedQuantity& quantity : quantities) profile.add(with_measured_deviation(quantity, *best), true);
    best = best_lag(profile.lags(), profile.gains());
    if (!best) return not_certain();
    if (round == 0) continue;
    const auto lags = bootstrap(profile, kCellsInBlock, kSamples);
    if (static_cast<double>(lags.size()) < kCertain * kSamples) return not_certain();
    const Lag lag{.seconds = *best, .deviation = std::hypot(kFewKicks * spread_of(lags), kBetweenLags)};
    if (lag.deviation > largest) return not_certain();
    return lag;
  }
}

}  // namespace robot::lab
