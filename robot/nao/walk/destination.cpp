#include "robot/nao/walk/destination.h"

#include <algorithm>
#include <cmath>

namespace robot::nao::walk {
namespace {

constexpr double kNear = 0.35;                         // [m] nearer, it walks in any direction
constexpr double kArrived = 0.04, kArrivedTurn = 0.2;  // [m], [rad]
constexpr double kApproach = 1.5;                      // [1/s] speed per distance
constexpr double kTurning = 1.5;                       // [1/s] turn rate per angle
constexpr double kTurnCost = 0.5;                      // share of the speed that the fastest turn costs

}  // namespace

Command within(const Limits& limits, const Command& command) {
  const double turn = std::clamp(command.turn, -limits.turn, limits.turn);
  const double ahead = command.forward >= 0 ? limits.forward : limits.backward;
  const double size = std::hypot(command.forward / ahead, command.left / limits.left);
  const double most = 1 - kTurnCost * std::abs(turn) / limits.turn;
  const double share = size > most ? most / size : 1;
  return {share * command.forward, share * command.left, turn};
}

Command towards(const Destination& destination, double gain, const Limits& limits) {
  const auto& [x, y, heading] = destination;
  const double distance = std::hypot(x, y), share = std::clamp(gain, 0.0, 1.0);
  if (share == 0 || (distance < kArrived && std::abs(heading) < kArrivedTurn)) return {};
  const Limits slower{share * limits.forward, share * limits.backward, share * limits.left, share * limits.turn};
  if (distance <= kNear) return within(slower, {kApproach * x, kApproach * y, kTurning * heading});
  // turn first when it lies behind
  const double bearing = std::atan2(y, x);
  return within(slower, {std::max(0.0, std::cos(bearing)) * slower.forward, 0, kTurning * bearing});
}

}  // namespace robot::nao::walk
