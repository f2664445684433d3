// The ball filter: from percepts to a believed ball.
//
// It is a Kalman filter of position and velocity in the robot's frame. Both axes are independent and share one
// covariance. It uses believed odometry, so a robot that misjudges its walk also misjudges the ball.
#pragma once

#include "sim/agent/beliefs.h"
#include "sim/perception/ball_sight.h"
#include "sim/perception/image.h"
#include "sim/perception/localisation.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// Returns the belief about a ball that was never seen: it may be anywhere.
agent::Ball unknown_ball(const BallFilter& filter);

inline constexpr float kForgotten = 0.5f;  // [s] unseen; after that the ball may appear anywhere

/// Corrects the belief by a percept [m, robot] and returns true.
///
/// A percept farther off than `reacquire` standard deviations restarts the filter if the ball was `forgotten`.
/// Otherwise the percept is doubted and the result is false: the belief keeps its place, but becomes so uncertain that
/// it accepts the next percept there.
bool believe(const PerceptionParams& params, const Body& body, const BallPercept& percept, bool forgotten,
             agent::Ball& ball);

// Below: prediction and update, inline because each robot does them for each image.

/// Rolls a ball on turf that slows it down. The ball does not roll back.
inline void roll(Vec2& position, Vec2& velocity, float deceleration, float dt) {
  const float square = squared_length(velocity);
  if (square == 0) return;
  const float speed = std::sqrt(square);
  const float lost = deceleration * dt;
  if (lost < speed) {
    const float share = lost / speed;
    position += dt * (1 - 0.5f * share) * velocity;
    velocity = (1 - share) * velocity;
  } else {
    position += 0.5f * speed / deceleration * velocity;
    velocity = {};
  }
}

/// Predicts the believed ball and its uncertainty for `steps` ticks, in which the robot moved by `odometry`. Many short
/// predictions end where one long one does.
///
/// The error of the odometry is not added to the uncertainty. It is 1 cm, 5 % of the 0.2 m that a robot walks in a
/// second, while an unseen ball becomes uncertain by some tenths of a metre.
inline void predict(const PerceptionParams& params, const Odometry& odometry, Tick steps, agent::Ball& ball) {
  if (ball.seen == kNever) return;

  // the same place in the frame of the robot that moved
  if (odometry.turned != 0) {
    ball.position = turned_back(ball.position, odometry.turn);
    ball.velocity = turned_back(ball.velocity, odometry.turn);
  }
  ball.position -= odometry.moved;

  // the ball rolls; a ball that may be anywhere needs no prediction
  const BallFilter& filter = params.model.filter;
  const float most = filter.lost_deviation * filter.lost_deviation;
  if (ball.variance >= most) return;
  const float dt = static_cast<float>(steps) * kTickDuration;
  roll(ball.position, ball.velocity, params.ball.deceleration, dt);

  // white noise of the acceleration, with the standard deviation `acceleration_noise` in each tick
  const float noise = filter.acceleration_noise * filter.acceleration_noise * kTickDuration * dt;
  ball.variance += dt * (2 * ball.covariance + dt * (ball.velocity_variance + noise * (1.f / 3)));
  ball.covariance += dt * (ball.velocity_variance + 0.5f * noise);
  ball.velocity_variance += noise;
  if (ball.variance < most) return;
  ball.variance = most;
  ball.velocity = {};
}

/// Updates the belief with the images up to `now` and with their percept, if there is one. Each image without the ball
/// reduces the heat by a tenth.
inline void update(const PerceptionParams& params, const Body& body, const BallPercept& percept, Tick steps, Tick now,
                   agent::Ball& ball) {
  bool believed = percept.seen;
  if (percept.seen && params.effects.ball_noise) {
    believed = believe(params, body, percept, !ball.visible && age(now, ball.seen) >= kForgotten, ball);
  } else if (percept.seen) {
    ball.position = percept.position;
    ball.velocity = percept.velocity;
    ball.variance = ball.covariance = ball.velocity_variance = 0;
  }

  // number of images in a row with, or without, the ball
  const bool visible = believed && percept.ago == 0;
  const std::uint32_t frames = visible == ball.visible ? ball.frames + steps : steps;
  ball.frames = static_cast<std::uint8_t>(frames < 255 ? frames : 255);
  ball.visible = visible;
  if (believed) {
    ball.seen = now - percept.ago;
    ball.heat = percept.heat;
  } else if (ball.heat > 0) {
    const float rest = 1 - 0.1f * static_cast<float>(steps);
    ball.heat = rest > 0 ? rest * ball.heat : 0;
  }
}

}  // namespace sim::perception
