#include "robot/truth/detection/ball_shape_finder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/truth/detection/pixel_patch.h"

namespace robot::truth {
namespace {

using Eigen::Vector2d;

/// Reports whether a place is at the feet of a person or a robot.
bool taken(const Vector2d& place, const GroundGrid& grid, const std::vector<SeenRobot>& robots) {
  constexpr float kPerson = 0.45F, kArea = 0.002F;             // [m], [m²]
  constexpr double kStanding = 0.2, kLying = 0.4, kLow = 0.4;  // [m]
  if (grid.within(Layer::tall, place.cast<float>(), kPerson).area > kArea) return true;
  return std::any_of(robots.begin(), robots.end(), [&](const SeenRobot& robot) {
    return (robot.place.position - place).norm() < (robot.height < kLow ? kLying : kStanding);
  });
}

/// Returns the standard deviation of a ball's place in the image: that of the search, and that of the noise. Both are found
/// by experiment (bench_truth).
double deviation_px(const BallAgreement& agreement) { return std::hypot(0.14, 3.3 / std::sqrt(agreement.evidence)); }

}  // namespace

BallShapeFinder::BallShapeFinder(const SensorPose& pose, double ball_radius)
    : plane_(pose, ball_radius),
      columns_((pose.intrinsics.width + kTile - 1) / kTile),
      rows_((pose.intrinsics.height + kTile - 1) / kTile),
      tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void BallShapeFinder::clear() { std::fill(tiles_.begin(), tiles_.end(), std::uint16_t{0}); }

std::optional<SeenBall> BallShapeFinder::find(const Sight& sight, const DepthFrame& frame, const GroundGrid& grid,
                                              const std::vector<SeenRobot>& robots) {
  collect(sight, grid, robots);
  std::optional<SeenBall> ball;
  double best = 0;  // evidence of each pixel
  for (const Candidate& candidate : candidates_) {
    const auto match = best_match(sight, frame, candidate);
    if (!match || !match->agreement.convincing()) continue;
    const double each = match->agreement.evidence / match->agreement.pixels;
    if (each <= best) continue;
    best = each;
    ball = SeenBall{plane_.place(match->pixel, deviation_px(match->agreement))};
  }
  return ball;
}

void BallShapeFinder::collect(const Sight& sight, const GroundGrid& grid, const std::vector<SeenRobot>& robots) {
  constexpr std::uint16_t kLeast = 3;  // pixels of a tile
  candidates_.clear();
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      if (tiles_[tile(row, column)] < kLeast) continue;
      const auto candidate = candidate_at(row, column);
      if (!candidate) continue;
      const Vector2d place = plane_.on_ground(*plane_.centre(candidate->pixel));
      if (sight.on_carpet(place) && !taken(place, grid, robots)) add(*candidate);
    }
}

std::optional<BallShapeFinder::Candidate> BallShapeFinder::candidate_at(int row, int column) const {
  constexpr double kLeastFilled = 0.3, kMostFilled = 1.8;
  const Vector2d pixel = kTile * Vector2d(column + 0.5, row + 0.5);
  const auto centre = plane_.centre(pixel);
  if (!centre) return std::nullopt;
  const double radius = plane_.radius_px(*centre);
  const int reach = std::max(1, static_cast<int>(radius / kTile));
  const double filled = count_around(row, column, reach) / (std::numbers::pi * radius * radius);
  if (filled < kLeastFilled || filled > kMostFilled) return std::nullopt;
  return Candidate{pixel, filled};
}

int BallShapeFinder::count_around(int row, int column, int reach) const {
  int count = 0;
  for (int y = std::max(row - reach, 0); y <= std::min(row + reach, rows_ - 1); ++y)
    for (int x = std::max(column - reach, 0); x <= std::min(column + reach, columns_ - 1); ++x)
      count += tiles_[tile(y, x)];
  return count;
}

/// Keeps the best of all candidates within one and a half radii.
void BallShapeFinder::add(const Candidate& candidate) {
  const double radius = plane_.radius_px(*plane_.centre(candidate.pixel));
  const auto same = std::find_if(candidates_.begin(), candidates_.end(), [&](const Candidate& other) {
    return (other.pixel - candidate.pixel).norm() < 1.5 * radius;
  });
  if (same == candidates_.end())
    candidates_.push_back(candidate);
  else if (same->filled < candidate.filled)
    *same = candidate;
}

BallAgreement BallShapeFinder::agreement(const Sight& sight, const DepthFrame& frame, const Vector2d& pixel) const {
  const auto centre = plane_.centre(pixel);
  if (!centre || !plane_.whole(pixel, plane_.radius_px(*centre))) return {};
  return ball_agreement(sight, frame, *centre, plane_.radius());
}

/// Moves a ball in the image until the evidence is greatest. Leaves hopeless candidates early.
std::optional<BallShapeFinder::Match> BallShapeFinder::best_match(const Sight& sight, const DepthFrame& frame,
                                                                  const Candidate& candidate) const {
  constexpr double kSmallestStep = 0.2;  // [px]
  const double radius = plane_.radius_px(*plane_.centre(candidate.pixel));
  const PixelPatch patch = centred_patch(frame.intrinsics, candidate.pixel, 1.3 * radius,
                                         [&](int row, int column) { return sight.notices(frame, row, column); });
  if (patch.count == 0) return std::nullopt;
  Match match{patch.middle(), agreement(sight, frame, patch.middle())};
  if (match.agreement.evidence < 1.5 * match.agreement.pixels || 2 * match.agreement.fitting < match.agreement.pixels)
    return std::nullopt;

  for (double step = radius / 2; step > kSmallestStep;) {
    const Match before = match;
    for (const Vector2d& way : {Vector2d(step, 0), Vector2d(-step, 0), Vector2d(0, step), Vector2d(0, -step)}) {
      const Match moved{before.pixel + way, agreement(sight, frame, before.pixel + way)};
      if (moved.agreement.evidence > match.agreement.evidence) match = moved;
    }
    if (match.pixel == before.pixel) step /= 2;
  }
  return match;
}

}  // namespace robot::truth
