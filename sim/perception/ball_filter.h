// The ball filter: what a robot makes of its percepts.
//
// A Kalman filter in the frame of the robot whose axes do not know of each other: position and velocity of each, with
// one variance for both. It runs on believed odometry, so a robot that misjudges its walk misjudges the ball.
#pragma once

#include "sim/agent/beliefs.h"
#include "sim/perception/ball_sight.h"
#include "sim/perception/image.h"
#include "sim/perception/localisation.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// A ball nobody has seen: anywhere.
agent::Ball unknown_ball(const BallFilter& filter);

inline constexpr float kForgotten = 0.5f;  // [s] out of sight after which a ball may turn up anywhere

/// Moves the belief towards a percept [m, robot] and says true.
///
/// A percept farther off than `reacquire` standard deviations starts the filter anew if the ball was `forgotten`.
/// Otherwise it is doubted, which says false: the belief stays where it is but becomes so uncertain that the next
/// percept there is believed.
bool believe(const PerceptionParams& params, const Body& body, const BallPercept& percept, bool forgotten,
             agent::Ball& ball);

// The two steps of each image, inline because every robot takes them every tick.

/// Rolls a ball on over turf that slows it down; it does not roll back.
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

/// Rolls the believed ball on for `steps` ticks while the robot moved by `odometry`: where it is then, and how
/// uncertain that is. Many short predictions end where one long one does.
///
/// That the odometry is off is not added to the uncertainty: 5 % of the 0.2 m that a robot walks in a second are 1 cm
/// against the tenths of a metre that an unseen ball becomes uncertain by.
inline void predict(const PerceptionParams& params, const Odometry& odometry, Tick steps, agent::Ball& ball) {
  if (ball.seen == kNever) return;

  // the same place in the frame of the robot that moved
  if (odometry.turned != 0) {
    ball.position = turned_back(ball.position, odometry.turn);
    ball.velocity = turned_back(ball.velocity, odometry.turn);
  }
  ball.position -= odometry.moved;

  // the ball rolls; when it may be anywhere nothing is reckoned with any more
  const BallFilter& filter = params.model.filter;
  const float most = filter.lost_deviation * filter.lost_deviation;
  if (ball.variance >= most) return;
  const float dt = static_cast<float>(steps) * kTickDuration;
  roll(ball.position, ball.velocity, params.ball.deceleration, dt);

  // white noise of acceleration, of which each tick has `acceleration_noise`
  const float noise = filter.acceleration_noise * filter.acceleration_noise * kTickDuration * dt;
  ball.variance += dt * (2 * ball.covariance + dt * (ball.velocity_variance + noise * (1.f / 3)));
  ball.covariance += dt * (ball.velocity_variance + 0.5f * noise);
  ball.velocity_variance += noise;
  if (ball.variance < most) return;
  ball.variance = most;
  ball.velocity = {};
}

/// Counts the image of `now` in, and believes its percept, if there is one. Each image without the ball takes a tenth
/// of the heat away.
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

  // images in a row
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
