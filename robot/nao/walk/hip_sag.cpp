#include "robot/nao/walk/hip_sag.h"

#include <algorithm>

namespace robot::nao::walk {
namespace {

constexpr double kCarries = 0.95;  // share of the weight from which a leg is measured

}  // namespace

void HipSag::see(const Legs& measured, const Weights& weights) {
  const double most = parameters_.sag_most;
  for (const Side side : {left, right}) {
    if (weights[side] < kCarries) continue;
    const double rest = places_[side] - measured[side][hip_roll];
    sag_[side] = std::clamp(sag_[side] + parameters_.sag_learning * rest, -most, most);
  }
}

void HipSag::raise(const Legs& places, const Weights& weights, Legs& targets) {
  for (const Side side : {left, right}) {
    places_[side] = places[side][hip_roll];
    targets[side][hip_roll] += weights[side] * sag_[side];
  }
}

}  // namespace robot::nao::walk
