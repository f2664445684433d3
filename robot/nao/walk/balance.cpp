#include "robot/nao/walk/balance.h"

#include <algorithm>
#include <cmath>

namespace robot::nao::walk {
namespace {

constexpr double kGravity = 9.81;        // [m/s²]
constexpr double kPartsPerPeriod = 10;   // of a step's usual course
constexpr double kLearnedAtMost = 0.02;  // [m] larger disturbances teach no more than this

/// Moves `usual` a share of the way to `error`.
void approach(double error, double share, double most, double& usual) {
  const double rest = std::clamp(error - usual, -kLearnedAtMost, kLearnedAtMost);
  usual = std::clamp(usual + share * rest, -most, most);
}

}  // namespace

void Balance::see(const Sensors& sensors) {
  const double keep = parameters_.smoothing;
  roll_ = sensors.roll, pitch_ = sensors.pitch;
  roll_rate_ = keep * roll_rate_ + (1 - keep) * sensors.rate[0];
  pitch_rate_ = keep * pitch_rate_ + (1 - keep) * sensors.rate[1];

  // the linear inverted pendulum: x + v / ω
  const double height = parameters_.com_height, omega = std::sqrt(kGravity / height);
  error_ = {height * (pitch_ + pitch_rate_ / omega), -height * (roll_ + roll_rate_ / omega)};
}

int Balance::part_of(double phase) { return std::clamp(static_cast<int>(phase * kPartsPerPeriod), 0, kParts - 1); }

Tipping Balance::disturbance(Side swing, double phase) const {
  const Tipping& usual = usual_[swing][static_cast<std::size_t>(part_of(phase))];
  return {error_.forward - usual.forward, error_.left - usual.left};
}

void Balance::learn(Side swing, double phase) {
  Tipping& usual = usual_[swing][static_cast<std::size_t>(part_of(phase))];
  approach(error_.forward, parameters_.learning, parameters_.usual_forward_most, usual.forward);
  approach(error_.left, parameters_.learning, parameters_.usual_side_most, usual.left);
}

void Balance::steady(const std::array<double, 2>& supports, Legs& legs) const {
  const Parameters& p = parameters_;
  for (const Side side : {left, right}) {
    const double share = supports[side];
    Leg& leg = legs[side];
    leg[ankle_pitch] += share * (p.rate_to_ankle_pitch * pitch_rate_ + p.tilt_to_ankle_pitch * pitch_);
    leg[ankle_roll] += share * (p.rate_to_ankle_roll * roll_rate_ + p.tilt_to_ankle_roll * roll_);
    leg[hip_pitch] += share * p.rate_to_hip_pitch * pitch_rate_;
  }
}

}  // namespace robot::nao::walk
