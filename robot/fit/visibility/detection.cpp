#include "robot/fit/visibility/detection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "robot/core/text.h"
#include "robot/fit/math/simplex.h"

namespace robot::fit {
namespace {

constexpr double kCell = 0.1;  // [m] images within share a probability
constexpr std::size_t kFewestPasses = 20, kFewestFarPasses = 5, kFewestBeyond = 3, kPassSamples = 200;
constexpr double kFarShare = 0.75;   // of the range: from there on balls show the probability at its end
constexpr double kLeastSpan = 1;     // [m] between the distances
constexpr double kLeastRatio = 1.5;  // of the distances
constexpr double kLeastFall = 0.25;  // [m] in which the probability falls
constexpr double kAtBound = 0.1;     // [m] a range that near to its bound is not known
constexpr double kWidestShare = 0.1, kWidestRange = 1;
constexpr double kCostUnit = 1000;  // a search ends where it gains less than 1e-7 of this unit
constexpr double kSurest = 1e-6;    // a probability is never nearer to 0 or 1

/// Images at nearly one distance.
struct Cell {
  double images = 0, seen = 0;
  double distance = 0, plausible = 0;  // sums over the images
};

/// A part of a cell: that of one pass.
struct PassCell {
  std::size_t index;
  Cell cell;
};

void add(const Cell& from, Cell& to) {
  to.images += from.images, to.seen += from.seen;
  to.distance += from.distance, to.plausible += from.plausible;
}

/// The free balls of all passes that are nearer than the end of the range.
std::vector<std::vector<PassCell>> cells_of(const Sights& sights, const std::vector<Group>& passes, double far_range) {
  std::vector<std::vector<PassCell>> all;
  for (const Group& pass : passes) {
    std::vector<PassCell> cells;
    for (const std::size_t i : pass) {
      const Sight& sight = sights.sights[i];
      if (sight.hidden || sight.distance > far_range - 3 * sights.error) continue;
      const auto index = static_cast<std::size_t>(sight.distance / kCell);
      auto cell = std::ranges::find(cells, index, &PassCell::index);
      if (cell == cells.end()) cell = cells.insert(cell, {.index = index, .cell = {}});
      add({.images = 1, .seen = sight.seen ? 1. : 0., .distance = sight.distance, .plausible = sight.plausible},
          cell->cell);
    }
    if (!cells.empty()) all.push_back(std::move(cells));
  }
  return all;
}

std::vector<Cell> joined_cells(const std::vector<std::vector<PassCell>>& passes,
                               const std::vector<std::size_t>& chosen) {
  std::vector<Cell> cells;
  for (const std::size_t pass : chosen)
    for (const PassCell& part : passes[pass]) {
      if (part.index >= cells.size()) cells.resize(part.index + 1);
      add(part.cell, cells[part.index]);
    }
  std::erase_if(cells, [](const Cell& cell) { return cell.images == 0; });
  return cells;
}

double cost_of(const std::vector<Cell>& cells, const DetectionCurve& curve) {
  double cost = 0;
  for (const Cell& cell : cells) {
    const double shown = curve.probability(cell.distance / cell.images) * cell.plausible / cell.images;
    const double p = std::clamp(shown, kSurest, 1 - kSurest);
    cost -= cell.seen * std::log(p) + (cell.images - cell.seen) * std::log1p(-p);
  }
  return cost;
}

/// Where the parameters may be, and which of them are free.
struct Limits {
  double least = 0, most = 0;  // [m] of near_range
  bool fits_far = false;
};

DetectionCurve curve_at(const Vector& p, const DetectionCurve& start) {
  return {.near = p[0], .far = p.size() > 2 ? p[2] : start.far, .near_range = p[1], .far_range = start.far_range};
}

bool is_allowed(const DetectionCurve& curve, const Limits& limits) {
  return curve.near >= 0 && curve.near <= 1 && curve.far >= 0 && curve.far <= 1 && curve.near_range >= limits.least &&
         curve.near_range <= limits.most;
}

/// Returns the best curve that a search from one of `starts` finds.
DetectionCurve best_curve(const std::vector<Cell>& cells, const DetectionCurve& standard, const Limits& limits,
                          const std::vector<DetectionCurve>& starts) {
  const auto value = [&](const Vector& p) {
    const DetectionCurve curve = curve_at(p, standard);
    return is_allowed(curve, limits) ? cost_of(cells, curve) / kCostUnit : INFINITY;
  };
  DetectionCurve best = standard;
  double least = INFINITY;
  for (const DetectionCurve& from : starts) {
    Vector start{from.near, from.near_range}, steps{-0.2, 0.1 * (limits.most - limits.least)};
    if (limits.fits_far) start.push_back(from.far), steps.push_back(from.far < 0.5 ? 0.2 : -0.2);
    const Vector there = least_of(value, start, steps);
    if (const double cost = value(there); cost < least) least = cost, best = curve_at(there, standard);
  }
  return best;
}

/// Returns places to search from. A kink has several best places nearby, so one is not enough.
std::vector<DetectionCurve> first_starts(const Limits& limits) {
  std::vector<DetectionCurve> starts;
  for (const double share : {0.2, 0.5, 0.8})
    starts.push_back(
        {.near = 0.8, .far = 0.3, .near_range = limits.least + share * (limits.most - limits.least), .far_range = 0});
  return starts;
}

/// The distances of the passes with a free ball, in order.
std::vector<double> mean_distances(const std::vector<std::vector<PassCell>>& passes) {
  std::vector<double> distances;
  for (const auto& pass : passes) {
    Cell all;
    for (const PassCell& part : pass) add(part.cell, all);
    distances.push_back(all.distance / all.images);
  }
  std::ranges::sort(distances);
  return distances;
}

/// Returns the distances of the farthest ball seen in each pass, in order, of those beyond the range of the default. A false ball in
/// front of one that is out of range may be taken for it, so a pass needs several.
std::vector<double> seen_beyond(const Sights& sights, const std::vector<Group>& passes, double far_range) {
  std::vector<double> beyond;
  for (const Group& pass : passes) {
    double farthest = 0;
    std::size_t images = 0;
    for (const std::size_t i : pass) {
      const Sight& sight = sights.sights[i];
      if (!sight.seen || sight.distance <= far_range + 3 * sights.error) continue;
      farthest = std::max(farthest, sight.distance);
      ++images;
    }
    if (images >= kFewestBeyond) beyond.push_back(farthest);
  }
  std::ranges::sort(beyond);
  return beyond;
}

/// Returns the end of the range by the two farthest balls: Robson and Whitlock 1964, Estimation of a truncation point.
std::optional<Figure> farther_range(const Sights& sights, const std::vector<Group>& passes, double far_range) {
  const std::vector<double> beyond = seen_beyond(sights, passes, far_range);
  if (beyond.size() < kFewestBeyond) return std::nullopt;
  const double last = beyond.back(), gap = last - beyond[beyond.size() - 2];
  return Figure{.name = "ball_detection.far_range",
                .unit = "m",
                .value = last + gap,
                .low = last - 2 * sights.error,
                .high = last + 19 * gap + 2 * sights.error,
                .events = beyond.size(),
                .widest = kWidestRange};
}

std::optional<std::string> obstacle(const std::vector<std::vector<PassCell>>& cells) {
  const std::vector<double> distances = mean_distances(cells);
  std::size_t hits = 0, misses = 0;
  for (const auto& pass : cells) {
    hits += std::ranges::any_of(pass, [](const PassCell& part) { return part.cell.seen > 0; });
    misses += std::ranges::any_of(pass, [](const PassCell& part) { return part.cell.seen < part.cell.images; });
  }
  if (distances.size() < kFewestPasses || hits < kFewestPasses / 2 || misses < kFewestPasses / 2)
    return formatted(
        "ball_detection: expected at least %zu passes with a free ball in view, %zu with a seen one and %zu with a "
        "missed "
        "one, got %zu, %zu and %zu",
        kFewestPasses, kFewestPasses / 2, kFewestPasses / 2, distances.size(), hits, misses);
  const double nearest = distances[distances.size() / 20],
               farthest = distances[distances.size() - 1 - distances.size() / 20];
  if (farthest - nearest < kLeastSpan || farthest < kLeastRatio * nearest)
    return formatted(
        "ball_detection: near, far and near_range cannot be told apart: expected distances that differ by %.1f m and "
        "by "
        "half, got balls at %.2f .. %.2f m",
        kLeastSpan, nearest, farthest);
  return std::nullopt;
}

/// Returns the limits that the distances allow, and adds the reason if `far` stays.
Limits limits_of(const std::vector<double>& distances, const DetectionCurve& standard, std::vector<std::string>* kept) {
  const double far_from = kFarShare * standard.far_range;
  const auto far = distances.end() - std::ranges::lower_bound(distances, far_from);
  const bool fits_far = far >= static_cast<std::ptrdiff_t>(kFewestFarPasses);
  if (!fits_far && kept)
    kept->push_back(
        formatted("ball_detection.far: expected at least %zu passes with a ball at %.1f m or farther, got %td, the "
                  "farthest at %.1f m",
                  kFewestFarPasses, far_from, far, distances.back()));
  const double least = distances[distances.size() / 20];
  const double most =
      std::min(distances[distances.size() - 1 - distances.size() / 20], standard.far_range - kLeastFall);
  return {.least = std::min(least, most - kLeastFall), .most = most, .fits_far = fits_far};
}

Figure figure_of(const char* name, const char* unit, double value, double half, double most, double widest) {
  return {.name = std::string("ball_detection.") + name,
          .unit = unit,
          .value = value,
          .low = std::max(0., value - half),
          .high = std::min(most, value + half),
          .widest = widest};
}

/// Adds the figures of the curve that its limits allow.
void add_figures(const Vector& around, std::size_t passes, const Limits& limits, DetectionFit& fit) {
  const double half = two_sided(passes - 1);
  // if all are seen, or all missed, the passes alone bound the share
  const double least = 3. / static_cast<double>(passes);
  const auto half_of = [&](std::size_t i, double value) {
    return value < kSurest || value > 1 - kSurest ? std::max(least, half * around[i]) : half * around[i];
  };
  const DetectionCurve& curve = fit.curve;
  const bool falls = curve.near - curve.probability(limits.most) > half * around[3];
  if (!falls || curve.near_range > limits.least + kAtBound)
    fit.figures.push_back(figure_of("near", "", curve.near, half_of(0, curve.near), 1, kWidestShare));
  else
    fit.kept.push_back(
        formatted("ball_detection.near: expected balls nearer than the range in which all are seen alike, got "
                  "a share that falls from %.2f m on",
                  limits.least));
  if (limits.fits_far) fit.figures.push_back(figure_of("far", "", curve.far, half_of(2, curve.far), 1, kWidestShare));
  if (falls && curve.near_range > limits.least + kAtBound && curve.near_range < limits.most - kAtBound)
    fit.figures.push_back(figure_of("near_range", "m", curve.near_range, half * around[1], 30, kWidestRange));
  else
    fit.kept.push_back(
        formatted("ball_detection.near_range: expected a share that begins to fall at %.1f .. %.1f m, got none",
                  limits.least, limits.most));
}

}  // namespace

double DetectionCurve::probability(double distance) const {
  if (distance <= near_range) return near;
  if (distance > far_range) return 0;
  return near + (distance - near_range) / (far_range - near_range) * (far - near);
}

DetectionCurve curve_of(const sim::perception::Detection& model) {
  return {.near = model.near, .far = model.far, .near_range = model.near_range, .far_range = model.far_range};
}

double shown_by(const DetectionCurve& curve, const Sight& sight) {
  return sight.hidden ? 0 : curve.probability(sight.distance) * sight.plausible;
}

DetectionCurve detection_of(const Sights& sights, const std::vector<Group>& passes, const DetectionCurve& standard) {
  DetectionCurve start = standard;
  if (const auto farther = farther_range(sights, passes, standard.far_range)) start.far_range = farther->value;
  const auto cells = cells_of(sights, passes, start.far_range);
  if (obstacle(cells)) return standard;
  const Limits limits = limits_of(mean_distances(cells), start, nullptr);
  return best_curve(joined_cells(cells, all_of(cells.size())), start, limits, first_starts(limits));
}

DetectionFit fit_detection(const Sights& sights, const std::vector<Group>& passes, const DetectionCurve& standard) {
  DetectionFit fit{.curve = standard};
  DetectionCurve start = standard;
  const auto farther = farther_range(sights, passes, standard.far_range);
  if (farther) start.far_range = farther->value;
  const auto cells = cells_of(sights, passes, start.far_range);
  if (auto reason = obstacle(cells)) {
    fit.kept.push_back(std::move(*reason));
    return fit;
  }
  const std::vector<double> distances = mean_distances(cells);
  const Limits limits = limits_of(distances, start, &fit.kept);
  fit.curve = best_curve(joined_cells(cells, all_of(cells.size())), start, limits, first_starts(limits));
  const std::vector<DetectionCurve> starts{fit.curve, first_starts(limits)[1]};
  const Vector around = deviations_of(
      resampled(single_groups(cells.size()), kPassSamples, [&](const std::vector<std::size_t>& chosen) -> Vector {
        const DetectionCurve curve = best_curve(joined_cells(cells, chosen), start, limits, starts);
        return {curve.near, curve.near_range, curve.far, curve.near - curve.probability(limits.most)};
      }));
  add_figures(around, cells.size(), limits, fit);
  if (farther) fit.figures.push_back(*farther);
  for (Figure& figure : fit.figures) {
    if (figure.events == 0) figure.events = cells.size();
    figure.kind = "passes";
    figure.recordings = sights.recordings;
    figure.domain = {.quantity = "true distance", .unit = "m", .from = distances.front(), .to = distances.back()};
  }
  return fit;
}

}  // namespace robot::fit
