#include "robot/fit/localisation/mark_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "robot/core/text.h"

namespace robot::fit {
namespace {

using sim::perception::Localisation;

constexpr std::size_t kFewestBlocks = 20, kBlockSamples = 200;
constexpr double kBlock = 30;                          // [s]
constexpr std::uint64_t kSeeds = 3;                    // of the luck of each simulation
constexpr double kLeastMark = 0.005, kMostMark = 0.9;  // [m], [rad]
constexpr int kHalvings = 9;                           // of the logarithm between both
constexpr double kFlat = 0.15;  // least growth of the logarithm of a squared error with that of the deviation
constexpr std::size_t kMostMoments = 300'000;  // of the simulation

/// One of the two deviations.
struct Deviation {
  float Localisation::*figure;
  double MarkErrors::*error;
  double MarkMoment::*square;
  double MarkSquares::*simulated;
};
constexpr Deviation kOfHeading{&Localisation::mark_deviation_heading, &MarkErrors::heading, &MarkMoment::square_turn,
                               &MarkSquares::heading};
constexpr Deviation kOfPlace{&Localisation::mark_deviation, &MarkErrors::place, &MarkMoment::square,
                             &MarkSquares::place};

/// The simulation as a function of the models.
class MarkGame {
 public:
  MarkGame(const std::vector<MarkWalk>& walks, const sim::field::Field& field) : walks_(walks), field_(field) {}

  MarkErrors errors(const sim::Models& models) const {
    MarkErrors mean;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const MarkErrors one = simulated_errors(walks_, models, field_, seed);
      mean.place += one.place / kSeeds, mean.heading += one.heading / kSeeds, mean.moments = one.moments;
      for (std::size_t i = 0; i < mean.histogram.size(); ++i) mean.histogram[i] += one.histogram[i] / kSeeds;
    }
    return mean;
  }

  /// Returns the squares of each moment that counts, the mean of several simulations.
  std::vector<MarkSquares> squares(const sim::Models& models) const {
    std::vector<MarkSquares> mean, one;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      one.clear();
      simulated_errors(walks_, models, field_, seed, &one);
      mean.resize(one.size());
      for (std::size_t i = 0; i < one.size(); ++i)
        mean[i].place += one[i].place / kSeeds, mean[i].heading += one[i].heading / kSeeds;
    }
    return mean;
  }

  /// Returns the logarithm of one mean square.
  double logarithm(sim::Models models, const Deviation& which, double value) const {
    models.perception.localisation.*which.figure = static_cast<float>(value);
    return std::log(errors(models).*which.error);
  }

 private:
  const std::vector<MarkWalk>& walks_;
  const sim::field::Field& field_;
};

/// Returns the walks, cut so that the simulation is fast.
std::vector<MarkWalk> cut(std::vector<MarkWalk> walks) {
  std::size_t all = 0;
  for (const MarkWalk& walk : walks) all += walk.moments.size();
  if (all <= kMostMoments) return walks;
  for (MarkWalk& walk : walks) walk.moments.resize(walk.moments.size() * kMostMoments / all);
  return walks;
}

/// The sums of squares of one block.
struct BlockSum {
  double recorded = 0, simulated = 0;
};

/// Returns the sums of each half minute. `simulated` are the squares of the moments that count, or empty.
std::vector<BlockSum> blocks_of(const std::vector<MarkWalk>& walks, const Deviation& which,
                                const std::vector<MarkSquares>& simulated) {
  std::vector<BlockSum> blocks;
  std::size_t next = 0;
  for (const MarkWalk& walk : walks) {
    double end = -INFINITY;
    for (const MarkMoment& moment : walk.moments) {
      if (!moment.counts) continue;
      if (moment.at >= end) end = moment.at + kBlock, blocks.emplace_back();
      blocks.back().recorded += moment.*which.square;
      if (next < simulated.size()) blocks.back().simulated += simulated[next++].*which.simulated;
    }
  }
  return blocks;
}

/// Returns one standard deviation of the logarithm of recorded by simulated squares. Both are of the same walks, so the luck of
/// these has no part in it.
double deviation_of_ratio(const std::vector<BlockSum>& blocks) {
  return deviations_of(
      resampled(single_groups(blocks.size()), kBlockSamples, [&](const std::vector<std::size_t>& chosen) -> Vector {
        BlockSum sum;
        for (const std::size_t i : chosen) {
          sum.recorded += blocks[i].recorded;
          sum.simulated += blocks[i].simulated;
        }
        return {std::log(std::max(sum.recorded, 1e-9) / std::max(sum.simulated, 1e-9))};
      }))[0];
}

/// Returns one standard deviation of the logarithm of a simulated mean square by the errors of other figures.
double deviation_by_others(const MarkGame& game, const sim::Models& models, const Deviation& which,
                           const std::vector<UncertainFigure>& uncertain) {
  const double value = models.perception.localisation.*which.figure;
  const double middle = game.logarithm(models, which, value);
  double squares = 0;
  for (const UncertainFigure& one : uncertain) {
    sim::Models other = models;
    other.perception.localisation.*one.figure += static_cast<float>(one.deviation);
    squares += std::pow(game.logarithm(other, which, value) - middle, 2);
  }
  return std::sqrt(squares);
}

/// Fits one deviation, and sets it in `models`. Returns an Error with the reason if it stays.
Result<RootInterval> fit_deviation(const MarkGame& game, const std::vector<MarkWalk>& walks, const Deviation& which,
                                   double recorded, const std::vector<UncertainFigure>& uncertain,
                                   sim::Models& models) {
  if (!(recorded > 0)) return Error{"expected errors beyond those of the truth, got less"};
  const double wanted = std::log(recorded);
  const double least = game.logarithm(models, which, kLeastMark), most = game.logarithm(models, which, kMostMark);
  if (wanted <= least || wanted >= most)
    return Error{
        formatted("expected errors between %.3f and %.3f, as the simulator makes them with any deviation, got %.3f",
                  std::exp(least / 2), std::exp(most / 2), std::exp(wanted / 2))};
  double low = std::log(kLeastMark), high = std::log(kMostMark);
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (game.logarithm(models, which, std::exp(middle)) < wanted ? low : high) = middle;
  }
  // the last part is straight
  const double below = game.logarithm(models, which, std::exp(low)),
               above = game.logarithm(models, which, std::exp(high));
  const double part = above > below ? std::clamp((wanted - below) / (above - below), 0., 1.) : 0.5;
  const double value = std::exp(low + part * (high - low));
  models.perception.localisation.*which.figure = static_cast<float>(value);

  constexpr double kAside = 0.2;  // of the logarithm
  const double slope = (game.logarithm(models, which, value * std::exp(kAside)) -
                        game.logarithm(models, which, value * std::exp(-kAside))) /
                       (2 * kAside);
  if (slope < kFlat) return Error{"expected errors that depend on it, got about the same with any"};
  const std::vector<BlockSum> blocks = blocks_of(walks, which, game.squares(models));
  const double deviation =
      std::hypot(deviation_of_ratio(blocks), deviation_by_others(game, models, which, uncertain)) / slope;
  const double half = std::min(3., two_sided(blocks.size() - 1) * deviation);
  return RootInterval{.value = value, .low = value * std::exp(-half), .high = value * std::exp(half)};
}

}  // namespace

Result<MarkFit> fit_marks(const std::vector<MarkWalk>& all, const sim::Models& models, const sim::field::Field& field,
                          const std::vector<UncertainFigure>& uncertain) {
  const std::vector<MarkWalk> walks = cut(all);
  MarkFit fit;
  fit.blocks = blocks_of(walks, kOfPlace, {}).size();
  if (fit.blocks < kFewestBlocks)
    return Error{formatted("expected at least %zu half minutes of upright robots with poses and motion_status, got %zu",
                           kFewestBlocks, fit.blocks)};
  fit.recorded = recorded_errors(walks);
  const MarkGame game(walks, field);
  fit.before = game.errors(models);
  sim::Models fitted = models;
  std::vector<UncertainFigure> others = uncertain;
  const auto settle = [&](const Deviation& which, double recorded, RootInterval& interval, std::string& kept) {
    auto one = fit_deviation(game, walks, which, recorded, others, fitted);
    if (one)
      interval = *one;
    else
      kept = one.error(), fitted.perception.localisation.*which.figure = models.perception.localisation.*which.figure;
  };
  // the heading's error does not depend on that of the place
  settle(kOfHeading, fit.recorded.heading, fit.heading, fit.heading_kept);
  if (fit.heading_kept.empty())
    others.push_back({.figure = kOfHeading.figure, .deviation = (fit.heading.high - fit.heading.low) / 2 / 1.96});
  settle(kOfPlace, fit.recorded.place, fit.place, fit.place_kept);
  fit.fitted = game.errors(fitted);
  return fit;
}

}  // namespace robot::fit
