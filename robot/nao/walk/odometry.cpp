#include "robot/nao/walk/odometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/nao/model/dimensions.h"

namespace robot::nao::walk {
namespace {

constexpr double kBiasShare = 0.01;  // of a frame in the bias
constexpr double kBiasMost = 0.05;   // [rad/s] a standing robot that turns faster is turned by somebody

}  // namespace

Point passed(const Way& then, const Point& place, const Way& now) {
  const double c = std::cos(then.heading), s = std::sin(then.heading);
  const double x = then.x + c * place.x - s * place.y - now.x, y = then.y + s * place.x + c * place.y - now.y;
  const double ahead = std::cos(now.heading), aside = std::sin(now.heading);
  return {ahead * x + aside * y, ahead * y - aside * x, place.z};
}

void Odometry::see(const Sensors& sensors, std::optional<Side> support, double dt) {
  if (!support) {
    bias_ += kBiasShare * (std::clamp(sensors.rate[2], -kBiasMost, kBiasMost) - bias_);
    support_.reset();
    return;
  }
  const double turn = (sensors.rate[2] - bias_) * dt;
  Point foot = sole_of(sensors.joints[*support], *support);
  foot.y += sign_of(*support) * Dimensions{}.hip_half_width;
  if (support_ == support) {
    // the foot is at the same place as before, seen from a torso that has turned
    const double ahead = foot_.x - (std::cos(turn) * foot.x - std::sin(turn) * foot.y);
    const double left_of = foot_.y - (std::sin(turn) * foot.x + std::cos(turn) * foot.y);
    way_.x += std::cos(way_.heading) * ahead - std::sin(way_.heading) * left_of;
    way_.y += std::sin(way_.heading) * ahead + std::cos(way_.heading) * left_of;
  }
  way_.heading = std::remainder(way_.heading + turn, 2 * std::numbers::pi);
  support_ = support;
  foot_ = foot;
}

}  // namespace robot::nao::walk
