// The believed ball without its history, alone and in lanes. Internal to sim/perception.
#pragma once

#include "sim/agent/beliefs.h"
#include "sim/math/lanes.h"

namespace sim::perception {

/// Mean and variance of the ball's place and velocity, as in agent::Ball.
struct Estimate {
  Vec2 position, velocity;
  float variance, covariance, velocity_variance;
};

/// Returns `a` if `first` is true, `b` otherwise, without a branch.
constexpr Estimate select(bool first, const Estimate& a, const Estimate& b) {
  return {sim::select(first, a.position, b.position), sim::select(first, a.velocity, b.velocity),
          first ? a.variance : b.variance, first ? a.covariance : b.covariance,
          first ? a.velocity_variance : b.velocity_variance};
}

/// One estimate in each lane.
struct BallLanes {
  Lane<Vec2> position, velocity;
  Lane<float> variance, covariance, velocity_variance;

  Estimate get(int i) const { return {position[i], velocity[i], variance[i], covariance[i], velocity_variance[i]}; }
  void set(int i, const Estimate& ball) {
    position.set(i, ball.position);
    velocity.set(i, ball.velocity);
    variance[i] = ball.variance, covariance[i] = ball.covariance, velocity_variance[i] = ball.velocity_variance;
  }
  void gather(int i, const agent::Ball& ball) {
    set(i, {ball.position, ball.velocity, ball.variance, ball.covariance, ball.velocity_variance});
  }
  void scatter(int i, agent::Ball& ball) const {
    ball.position = position[i];
    ball.velocity = velocity[i];
    ball.variance = variance[i], ball.covariance = covariance[i], ball.velocity_variance = velocity_variance[i];
  }
};

}  // namespace sim::perception
