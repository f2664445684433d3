#include "robot/fit/walking/step_luck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "robot/fit/math/resampling.h"
#include "robot/fit/walking/mean_walk.h"
#include "sim/motion/gait.h"

namespace robot::fit {
namespace {

using sim::motion::Command, sim::motion::Walk;

constexpr std::size_t kShortBlocks = 2, kLongBlocks = 5;                                        // [blocks]
constexpr double kLongerBy = static_cast<double>(kLongBlocks - kShortBlocks) * kBlockDuration;  // [s]
constexpr double kSteady = 0.15;       // share of the speed by which a steady gait may change
constexpr double kSlowest = 0.05;      // [m/s]
constexpr double kBentMost = 0.7;      // [rad] turn within a window whose speed counts
constexpr double kUnluckySquare = 36;  // times the expected square: something else than luck
constexpr std::size_t kLuckPoints = 26;
constexpr double kLeastLucky = 0.05;  // share of the luck in the expected square of a window that counts
constexpr double kFewestLuckyDrives = 4;

/// The possible lucks: shares of the speed, or [rad/s].
struct LuckGrid {
  double most;
  double at(std::size_t i) const { return most * static_cast<double>(i) / (kLuckPoints - 1); }
};
constexpr LuckGrid kSpeeds{0.5}, kTurns{1};

/// The sums over the windows of one drive.
struct LuckWindows {
  double squares = 0;                          // [m²] or [rad²] of the long windows less those of the short ones
  std::array<double, kLuckPoints> expected{};  // of that, for each luck of the grid
  double seconds = 0;
};

/// The gait of a drive in its blocks, by the fitted walk.
struct BlockGait {
  WalkRates mean;
  bool steady = false;
};

std::vector<BlockGait> gaits_of(const DriveTrack& track, const std::vector<WalkRates>& rates) {
  std::vector<BlockGait> gaits(track.blocks());
  for (std::size_t b = 0; b < gaits.size(); ++b) {
    // half a second before the block is steady, too
    const std::size_t middle = track.middle_of(b), to = middle + kBlockTicks / 2;
    const std::size_t from = middle >= kBlockTicks / 2 + 15 ? middle - kBlockTicks / 2 - 15 : 0;
    WalkRates least{INFINITY, INFINITY, INFINITY}, most{-INFINITY, -INFINITY, -INFINITY};
    for (std::size_t i = from; i < std::min(to, rates.size()); ++i) {
      least = {std::min(least.x, rates[i].x), std::min(least.y, rates[i].y), std::min(least.turn, rates[i].turn)};
      most = {std::max(most.x, rates[i].x), std::max(most.y, rates[i].y), std::max(most.turn, rates[i].turn)};
    }
    gaits[b].mean = {(least.x + most.x) / 2, (least.y + most.y) / 2, (least.turn + most.turn) / 2};
    const double speed = std::hypot(gaits[b].mean.x, gaits[b].mean.y);
    const double change = std::hypot(most.x - least.x, most.y - least.y);
    const bool moves = speed > kSlowest || std::abs(gaits[b].mean.turn) > 0.1;
    gaits[b].steady = moves && change <= std::max(kSteady * speed, 0.01) &&
                      most.turn - least.turn <= std::max(kSteady * std::abs(gaits[b].mean.turn), 0.15);
  }
  return gaits;
}

bool is_along_one_axis(const WalkRates& rates) {
  const double x = std::abs(rates.x), y = std::abs(rates.y);
  return (x > kSlowest && y < 0.15 * x) || (y > kSlowest && x < 0.15 * y);
}

/// Returns the variances of a step for each luck of the grid: of the speed along the way, and of the turn rate.
struct StepVariances {
  std::array<double, kLuckPoints> speed{}, turn{};
};
StepVariances variances_of(Walk walk, const Command& command) {
  StepVariances variances;
  for (std::size_t i = 0; i < kLuckPoints; ++i) {
    walk.speed_noise = static_cast<float>(kSpeeds.at(i)), walk.turn_noise = static_cast<float>(kTurns.at(i));
    const MeanGait gait = mean_gait(walk, command);
    variances.speed[i] = gait.variance.x + gait.variance.y;
    variances.turn[i] = gait.variance.turn;
  }
  return variances;
}

/// Adds the squares of a window to `windows` unless they are out of all proportion.
void add_window(double step, double longer, double shorter, double scatter,
                const std::array<double, kLuckPoints>& variance, double assumed, LuckWindows& windows) {
  const double expected = assumed * step * kLongBlocks * kBlockDuration + scatter;
  if (longer > kUnluckySquare * expected || shorter > kUnluckySquare * expected) return;
  // a window in which the truth's errors hide the luck counts little
  const double lucky = assumed * step * kLongBlocks * kBlockDuration;
  if (lucky < kLeastLucky * expected) return;
  const double weight = lucky / (expected * expected);
  windows.squares += weight * (longer - shorter);
  for (std::size_t i = 0; i < kLuckPoints; ++i) windows.expected[i] += weight * variance[i] * step * kLongerBy;
  windows.seconds += kBlockDuration;
}

/// Returns the value between two points of the grid at which the variances are those of `luck`.
double at_luck(const std::array<double, kLuckPoints>& values, const LuckGrid& grid, double luck) {
  const double place =
      std::clamp(luck / grid.most * (kLuckPoints - 1), 0., static_cast<double>(kLuckPoints - 1) - 1e-9);
  const auto i = static_cast<std::size_t>(place);
  return values[i] + (place - static_cast<double>(i)) * (values[i + 1] - values[i]);
}

struct DriveWindows {
  LuckWindows speed, turn;
};

DriveWindows windows_in(const WalkProblem& problem, const DriveTrack& track, const WalkFit& fit) {
  DriveWindows windows;
  const std::size_t robot = track.drive().robot;
  const Walk walk = fit.state.walk_of(robot, fit.base);
  const std::vector<WalkRates> rates = mean_walk(walk, track.drive().commands);
  const std::vector<BlockMean> path = track.predicted(rates, fit.state.late(robot));
  const std::vector<BlockGait> gaits = gaits_of(track, rates);
  std::size_t steady = 0;
  for (std::size_t to = 0; to < gaits.size(); ++to) {
    steady = gaits[to].steady && track.places_in(to) >= 2 ? steady + 1 : 0;
    if (steady < kLongBlocks + 1) continue;
    const std::size_t from = to - kLongBlocks, middle = from + kLongBlocks / 2;
    const Command& command = track.drive().commands[track.middle_of(middle)];
    const bool near = command.body == Command::Body::walk_to && sim::length(command.walk) < sim::motion::kNear + 0.1f;
    if (near || !asks_to_walk(command)) continue;
    const auto missed = [&](std::size_t a, std::size_t b) { return missed_between(track, path, a, b); };
    const bool ahead = std::abs(gaits[middle].mean.x) > std::abs(gaits[middle].mean.y);
    const auto along = [&](const BlockStep& step) { return std::pow(ahead ? step.ahead : step.left, 2); };
    double shorter = 0, shorter_turn = 0;
    for (std::size_t i = from; i + kShortBlocks <= to; ++i) {
      const BlockStep step = missed(i, i + kShortBlocks);
      shorter += along(step) / (kLongBlocks - kShortBlocks + 1),
          shorter_turn += step.turn * step.turn / (kLongBlocks - kShortBlocks + 1);
    }
    const BlockStep longer = missed(from, to);
    const StepVariances variances = variances_of(walk, command);
    const double share = 2. / static_cast<double>(std::min(track.places_in(from), track.places_in(to)));
    const auto scatter = [share](double deviation) { return share * deviation * deviation + 1e-5; };
    const double bent = std::abs(seen_between(track, from, to).turn);
    if (is_along_one_axis(gaits[middle].mean) && bent < kBentMost)
      add_window(walk.step_duration, along(longer), shorter, scatter(problem.place_deviation), variances.speed,
                 at_luck(variances.speed, kSpeeds, std::max(0.1f, walk.speed_noise)), windows.speed);
    add_window(walk.step_duration, longer.turn * longer.turn, shorter_turn, scatter(problem.heading_deviation),
               variances.turn, at_luck(variances.turn, kTurns, std::max(0.1f, walk.turn_noise)), windows.turn);
  }
  return windows;
}

/// Returns the luck at which the expected squares are `squares`, at a bound if there is none.
double luck_of(const std::array<double, kLuckPoints>& expected, const LuckGrid& grid, double squares) {
  if (squares <= 0) return 0;
  for (std::size_t i = 0; i + 1 < kLuckPoints; ++i)
    if (squares <= expected[i + 1]) {
      // the expected squares grow with the square of the luck
      const double below = grid.at(i), above = grid.at(i + 1);
      const double share = (squares - expected[i]) / std::max(1e-300, expected[i + 1] - expected[i]);
      return std::sqrt(below * below + std::clamp(share, 0., 1.) * (above * above - below * below));
    }
  return grid.most;
}

std::optional<StepLuck> luck_in(const std::vector<LuckWindows>& drives, const LuckGrid& grid) {
  LuckWindows all;
  double weights = 0, squared_weights = 0;
  std::size_t count = 0;
  for (const LuckWindows& drive : drives) {
    all.squares += drive.squares, all.seconds += drive.seconds;
    for (std::size_t i = 0; i < kLuckPoints; ++i) all.expected[i] += drive.expected[i];
    weights += drive.seconds, squared_weights += drive.seconds * drive.seconds;
    count += drive.seconds > 0 ? 1 : 0;
  }
  const double alike = squared_weights > 0 ? weights * weights / squared_weights : 0;
  if (all.seconds < static_cast<double>(kFewestLucky) || alike < kFewestLuckyDrives) return std::nullopt;
  StepLuck luck{.value = luck_of(all.expected, grid, all.squares),
                .seconds = static_cast<std::size_t>(all.seconds),
                .drives = count};
  double scatter = 0;
  for (const LuckWindows& drive : drives) {
    const double expected = at_luck(drive.expected, grid, luck.value);
    scatter += std::pow(drive.squares - expected, 2);
  }
  const double deviation = std::sqrt(scatter * alike / (alike - 1));
  const double half = two_sided(static_cast<std::size_t>(alike - 1)) * deviation;
  luck.low = luck_of(all.expected, grid, all.squares - half);
  luck.high = luck_of(all.expected, grid, all.squares + half);
  luck.deviation = (luck.high - luck.low) / 4;
  return luck;
}

}  // namespace

WalkLuck measure_luck(const WalkProblem& problem, const WalkFit& fit) {
  std::vector<LuckWindows> speeds, turns;
  WalkLuck luck;
  for (const DriveTrack& track : problem.tracks) {
    const DriveWindows windows = windows_in(problem, track, fit);
    speeds.push_back(windows.speed), turns.push_back(windows.turn);
    luck.seconds += windows.speed.seconds;
  }
  luck.speed = luck_in(speeds, kSpeeds);
  luck.turn = luck_in(turns, kTurns);
  return luck;
}

}  // namespace robot::fit
