#include "robot/nao/walk/servo_sag.h"

#include <algorithm>
#include <cstddef>

namespace robot::nao::walk {
namespace {

constexpr double kCarries = 0.95;  // share of the weight from which a leg is measured
constexpr LegJoint kSagging[] = {hip_roll};

}  // namespace

void ServoSag::see(const Legs& measured, const std::array<double, 2>& weights) {
  const double most = parameters_.sag_most;
  for (const Side side : {left, right}) {
    if (weights[side] < kCarries) continue;
    for (const LegJoint joint : kSagging) {
      double& sag = sag_[side][joint];
      sag = std::clamp(sag + parameters_.sag_learning * (places_[side][joint] - measured[side][joint]), -most, most);
    }
  }
}

void ServoSag::raise(const Legs& places, const std::array<double, 2>& weights, Legs& targets) {
  places_ = places;
  for (const Side side : {left, right})
    for (const LegJoint joint : kSagging) targets[side][joint] += weights[side] * sag_[side][joint];
}

}  // namespace robot::nao::walk
