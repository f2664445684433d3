#include "robot/lab/clocks/true_motion.h"

#include <cmath>

namespace robot::lab {

TrueMotion::TrueMotion(const TruthRecord& truth, const Path& own)
    : ball_x_(curve_of(truth.ball, &PlaceAt::x)),
      ball_y_(curve_of(truth.ball, &PlaceAt::y)),
      own_x_(curve_of(own, &PlaceAt::x)),
      own_y_(curve_of(own, &PlaceAt::y)) {}

std::optional<TrueMotion::Moment> TrueMotion::at(double seconds) const {
  const auto x = ball_x_.at(seconds), y = ball_y_.at(seconds);
  const auto own_x = own_x_.at(seconds), own_y = own_y_.at(seconds);
  const auto speed_x = ball_x_.rate_at(seconds), speed_y = ball_y_.rate_at(seconds);
  const auto own_speed_x = own_x_.rate_at(seconds), own_speed_y = own_y_.rate_at(seconds);
  if (!x || !y || !own_x || !own_y || !speed_x || !speed_y || !own_speed_x || !own_speed_y) return std::nullopt;
  const double to_x = *x - *own_x, to_y = *y - *own_y, distance = std::hypot(to_x, to_y);
  const double along = to_x * (*speed_x - *own_speed_x) + to_y * (*speed_y - *own_speed_y);
  return Moment{.ball = {.at = seconds, .x = *x, .y = *y},
                .speed = std::hypot(*speed_x, *speed_y),
                .distance = distance,
                .rate = distance > 0 ? along / distance : 0};
}

}  // namespace robot::lab
