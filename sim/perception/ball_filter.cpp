#include "sim/perception/ball_filter.h"

namespace sim::perception {
namespace {

constexpr float kLeastVariance = 1e-6f;  // [m²] of a percept: no camera measures better than to a millimetre

float squared(float x) { return x * x; }

/// Nothing but this percept is known.
void start(const BallFilter& filter, Vec2 position, float variance, agent::Ball& ball) {
  ball.position = position;
  ball.velocity = {};
  ball.variance = variance;
  ball.covariance = 0;
  ball.velocity_variance = squared(filter.first_velocity);
}

void correct(Vec2 innovation, float variance, agent::Ball& ball) {
  const float whole = 1 / (ball.variance + variance);
  const float gain = ball.variance * whole;
  const float velocity_gain = ball.covariance * whole;
  ball.position += gain * innovation;
  ball.velocity += velocity_gain * innovation;
  ball.velocity_variance -= velocity_gain * ball.covariance;
  ball.covariance *= 1 - gain;
  ball.variance *= 1 - gain;
}

}  // namespace

agent::Ball unknown_ball(const BallFilter& filter) {
  agent::Ball ball;
  start(filter, {}, squared(filter.lost_deviation), ball);
  return ball;
}

bool believe(const Means& means, const Body& body, const BallPercept& percept, bool forgotten, agent::Ball& ball) {
  const BallFilter& filter = means.model.filter;
  const float height = means.model.camera.height - means.ball.radius;
  const ImageNoise noise = image_noise(means.model, body);
  const auto variance_at = [&](Vec2 place) {
    return percept_variance(noise, squared_length(place), height) / percept.images + kLeastVariance;
  };

  // how far a percept may be off is judged by where the ball is expected: by the percepts themselves, those that seem
  // near would count for more, and the ball would seem nearer than it is
  const bool lost = ball.variance >= squared(filter.lost_deviation);
  const float variance = variance_at(lost ? percept.position : ball.position);
  const Vec2 innovation = percept.position - ball.position;
  const float square = squared_length(innovation), gate = squared(filter.reacquire);
  if (lost || (forgotten && square > gate * (ball.variance + variance))) {
    start(filter, percept.position, variance_at(percept.position), ball);
    return true;
  }
  if (square > gate * (ball.variance + variance)) {
    start(filter, ball.position, square / gate, ball);
    return false;
  }
  correct(innovation, variance, ball);
  return true;
}

}  // namespace sim::perception
