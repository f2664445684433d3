#include "sim/perception/ball_filter.h"

namespace sim::perception {
namespace {

constexpr float kLeastVariance = 1e-6f;  // [m²] of a percept: no camera is more accurate than 1 mm

/// Restarts the filter at a place with this variance. The velocity is unknown.
void start(const BallFilter& filter, Vec2 position, float variance, agent::Ball& ball) {
  ball.position = position;
  ball.velocity = {};
  ball.variance = variance;
  ball.covariance = 0;
  ball.velocity_variance = squared(filter.first_velocity);
}

/// Corrects the belief by two measurements with independent errors: the position at the mean time
/// of the images, and the velocity.
void correct(const BallPercept& percept, float variance, agent::Ball& ball) {
  const Images& images = percept.images;
  {
    const float ago = images.middle;
    const float with_position = ball.variance - ago * ball.covariance;
    const float with_velocity = ball.covariance - ago * ball.velocity_variance;
    const float whole = 1 / (with_position - ago * with_velocity + variance / images.count);
    const Vec2 innovation = (percept.position - ball.position) - ago * (percept.velocity - ball.velocity);
    const float gain = with_position * whole, velocity_gain = with_velocity * whole;
    ball.position += gain * innovation;
    ball.velocity += velocity_gain * innovation;
    ball.variance -= gain * with_position;
    ball.covariance -= gain * with_velocity;
    ball.velocity_variance -= velocity_gain * with_velocity;
  }
  if (images.spread == 0) return;
  const float of_velocity = variance / images.spread;
  const float whole = 1 / (ball.velocity_variance + of_velocity);
  const Vec2 innovation = percept.velocity - ball.velocity;
  const float gain = ball.covariance * whole, rest = of_velocity * whole;
  ball.position += gain * innovation;
  ball.velocity += (1 - rest) * innovation;
  ball.variance -= gain * ball.covariance;
  ball.covariance *= rest;
  ball.velocity_variance *= rest;
}

}  // namespace

agent::Ball unknown_ball(const BallFilter& filter) {
  agent::Ball ball;
  start(filter, {}, squared(filter.lost_deviation), ball);
  return ball;
}

bool believe(const PerceptionParams& params, const Body& body, const BallPercept& percept, bool forgotten,
             agent::Ball& ball) {
  const BallFilter& filter = params.model.filter;
  const float height = params.model.camera.height - params.ball.radius;
  const ImageNoise noise = image_noise(params.model, body);
  const auto variance_at = [&](Vec2 place) {
    return percept_variance(noise, squared_length(place), height) + kLeastVariance;
  };

  // The expected place gives the variance of the percept. The percept's own place would give more weight to percepts
  // that seem near, and the ball would seem nearer than it is.
  const bool lost = ball.variance >= squared(filter.lost_deviation);
  const float variance = variance_at(lost ? percept.position : ball.position);
  const float square = squared_length(percept.position - ball.position), gate = squared(filter.reacquire);
  const bool elsewhere = square > gate * (ball.variance + variance);
  const bool several = percept.images.count >= 2;
  if (lost || (elsewhere && (forgotten || several))) {
    const float anew = variance_at(percept.position);
    start(filter, percept.position, several ? squared(filter.lost_deviation) : anew, ball);
    if (several) correct(percept, anew, ball);
    return true;
  }
  if (elsewhere) {
    start(filter, ball.position, square / gate, ball);
    return false;
  }
  correct(percept, variance, ball);
  return true;
}

}  // namespace sim::perception
