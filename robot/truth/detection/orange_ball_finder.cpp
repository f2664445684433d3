#include "robot/truth/detection/orange_ball_finder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/truth/detection/ball_agreement.h"
#include "robot/truth/detection/pixel_patch.h"

namespace robot::truth {

using Eigen::Vector2d;

OrangeBallFinder::OrangeBallFinder(const SensorPose& pose, const DetectorOptions& options)
    : plane_(pose, options.ball_radius),
      is_orange_(options.orange),
      colour_shift_(options.colour_shift_x, options.colour_shift_y),
      colour_deviation_(options.colour_deviation) {}

std::optional<SeenBall> OrangeBallFinder::find(const Sight& sight, const DepthFrame& frame) const {
  std::optional<Candidate> best;
  int step = 1;
  for (int row = sight.first_row(); row < sight.end_row(); row += step) {
    const Sight::Columns columns = sight.columns(row);
    step = std::clamp(static_cast<int>(smallest_radius(columns, row)), 1, 16);
    for (int column = columns.first; column < columns.end; column += step) {
      if (!is_orange_(&frame.rgb[3 * sight.index(row, column)])) continue;
      const auto candidate = candidate_at(sight, frame, {column + 0.5, row + 0.5});
      if (candidate && (!best || candidate->filled > best->filled)) best = candidate;
    }
  }
  if (!best) return std::nullopt;
  return best->ball;
}

double OrangeBallFinder::smallest_radius(Sight::Columns columns, int row) const {
  const auto left = plane_.centre({columns.first + 0.5, row + 0.5}),
             right = plane_.centre({columns.end - 0.5, row + 0.5});
  return left && right ? std::min(plane_.radius_px(*left), plane_.radius_px(*right)) : 0;
}

std::optional<OrangeBallFinder::Candidate> OrangeBallFinder::candidate_at(const Sight& sight, const DepthFrame& frame,
                                                                          const Vector2d& pixel) const {
  constexpr double kLeastFilled = 0.3, kMostFilled = 1.4;
  constexpr double kContradiction = -2;  // evidence of each pixel: a ball behind a robot, or an orange shirt
  const auto first = plane_.centre(pixel);
  if (!first) return std::nullopt;
  const PixelPatch patch =
      centred_patch(frame.intrinsics, pixel, 1.5 * plane_.radius_px(*first),
                    [&](int row, int column) { return is_orange_(&frame.rgb[3 * sight.index(row, column)]); });
  if (patch.count == 0) return std::nullopt;
  const Vector2d middle = patch.middle() - colour_shift_;
  const auto centre = plane_.centre(middle);
  if (!centre || !sight.on_carpet(plane_.on_ground(*centre))) return std::nullopt;

  const double radius = plane_.radius_px(*centre), filled = patch.count / (std::numbers::pi * radius * radius);
  if (filled < kLeastFilled || filled > kMostFilled || !plane_.whole(middle, radius)) return std::nullopt;
  const BallAgreement depths = ball_agreement(sight, frame, *centre, plane_.radius());
  if (depths.evidence < kContradiction * depths.pixels) return std::nullopt;
  // the hidden part of a ball moves the middle of the rest
  const double hidden = std::max(0., 0.9 - filled);
  return Candidate{{plane_.place(middle, std::hypot(colour_deviation_, hidden * radius))}, filled};
}

}  // namespace robot::truth
