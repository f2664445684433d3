#include "sim/world/contact.h"

namespace sim {

namespace {

constexpr float kDistance = 1.5f;  // [m] kept from the ball
constexpr float kSpeed = 1;        // [m/s] at most

}  // namespace

void walk_official(const field::Field& field, World& world) {
  Official& official = world.official;
  if (!is_there(official)) {
    const auto words = draw(world.key, kNobody, Draw::official, 0);
    official = {{((words[0] & 1) != 0 ? 0.25f : -0.25f) * field.length, 0}, {}};
  }

  // walk straight away from the ball, or towards it, until the distance is right
  const Vec2 from_ball = official.position - world.ball.position;
  const float gap = length(from_ball);
  const Vec2 away = gap > 0 ? (1 / gap) * from_ball : Vec2{1, 0};
  const float step = kSpeed * kTickDuration;
  const float wanted = kDistance - gap;
  const float done = wanted < -step ? -step : wanted > step ? step : wanted;
  official.velocity = (done * kTicksPerSecond) * away;
  official.position += done * away;
}

}  // namespace sim
