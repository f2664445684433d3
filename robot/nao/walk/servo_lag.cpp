#include "robot/nao/walk/servo_lag.h"

#include <algorithm>
#include <cstddef>

namespace robot::nao::walk {
namespace {

constexpr double kMemory = 0.004;       // share of a new measurement
constexpr double kFastest = 6;          // [rad/s] faster targets count as this fast
constexpr double kLeastSquares = 0.05;  // [rad²/s²] with less motion there is no regression
constexpr double kRise = 0.02;          // share of a new lag in the lag that is led

}  // namespace

void ServoLag::see(const Legs& measured, const Legs& plan, Side swing, double dt) {
  for (const LegJoint joint : {hip_pitch, knee_pitch, ankle_pitch}) {
    const double last = last_[swing][joint];
    const double speed = std::clamp((plan[swing][joint] - last) / dt, -kFastest, kFastest);
    products_ += kMemory * ((last - measured[swing][joint]) * speed - products_);
    squares_ += kMemory * (speed * speed - squares_);
  }
  if (squares_ <= kLeastSquares) return;
  // the regression sees only the rest of the lag, because the targets lead already
  const double share = parameters_.lag_share;
  const double rest = products_ / squares_;
  lag_ = std::clamp(lag_ + kRise * (share * rest - (1 - share) * lag_), 0.0, parameters_.lag_most);
}

Legs ServoLag::led(const Legs& plan, double dt) {
  Legs targets = plan;
  for (const Side side : {left, right})
    for (std::size_t joint = 0; joint < kLegJoints; ++joint) {
      const double lead = lag_ * (plan[side][joint] - last_[side][joint]) / dt;
      targets[side][joint] += std::clamp(lead, -parameters_.lead_most, parameters_.lead_most);
    }
  last_ = plan;
  return targets;
}

}  // namespace robot::nao::walk
