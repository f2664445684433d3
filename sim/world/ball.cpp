#include "sim/world/ball.h"

namespace sim {

void roll(Ball& ball, float deceleration, float stop_speed, float dt) {
  for (int i = Ball::kPast - 1; i > 0; --i) ball.past[i] = ball.past[i - 1];
  ball.past[0] = ball.position;

  const float squared_speed = squared_length(ball.velocity);
  if (squared_speed <= stop_speed * stop_speed) {
    ball.velocity = ball.acceleration = {};
    return;
  }

  // it may come to rest within this step
  const float speed = std::sqrt(squared_speed);
  const Vec2 heading = (1 / speed) * ball.velocity;
  const float slowed = speed - deceleration * dt;
  if (slowed <= stop_speed) {
    ball.position += ((squared_speed - stop_speed * stop_speed) / (2 * deceleration)) * heading;
    ball.velocity = ball.acceleration = {};
    return;
  }

  ball.position += (0.5f * (speed + slowed) * dt) * heading;
  ball.velocity = slowed * heading;
  ball.acceleration = -deceleration * heading;
}

void place(Ball& ball, Vec2 position) {
  ball = {.position = position};
  for (Vec2& past : ball.past) past = position;
}

Vec2 resting_place(const Ball& ball, float deceleration) {
  return ball.position + (length(ball.velocity) / (2 * deceleration)) * ball.velocity;
}

float speed_for_range(float range, float deceleration) { return std::sqrt(2 * deceleration * range); }

}  // namespace sim
