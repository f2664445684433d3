#include "sim/agent/head.h"

namespace sim::agent {
namespace {

constexpr float kScanAngle = 1.3f;  // [rad] HULKs look_around
constexpr float kScanPitch = 0.3f;  // [rad] down
constexpr Tick kScanPeriod = 66;    // [ticks] there and back

/// Returns the position -1..1 of a head that swings at a constant speed; 0 and rising at tick 0.
float swing(Tick tick, Tick period) {
  const float share = static_cast<float>(tick % period) / static_cast<float>(period);
  return share < 0.25f ? 4 * share : share < 0.75f ? 2 - 4 * share : 4 * share - 4;
}

void set_angles(motion::Command& command, float yaw, float pitch) {
  command.head = motion::Command::Head::angles;
  command.look[0] = yaw, command.look[1] = pitch, command.look[2] = 0;
}

}  // namespace

void scan(const View& view, motion::Command& command, float angle) {
  const Tick begun = view.mind.search_since == kNever ? 0 : view.mind.search_since;
  set_angles(command, view.mind.search_side * angle * swing(view.now - begun, kScanPeriod), kScanPitch);
}

void keep_eye_on_ball(const View& view, motion::Command& command) {
  if (!view.ball_known) return scan(view, command, kScanAngle);
  command.head = motion::Command::Head::look_to;
  command.look[0] = view.ball.x, command.look[1] = view.ball.y, command.look[2] = 0.05f;
}

void look_at_ball(const View& view, motion::Command& command) {
  const Habits& habits = view.settings.habits;
  const Tick follow = ticks(habits.look_at_ball), away = ticks(habits.look_away);
  if (!view.ball_known || follow + away == 0) return keep_eye_on_ball(view, command);

  // players are out of step, so that a team never looks away all at once
  const Tick time = view.now + 17u * view.game.player;
  const Tick cycle = time / (follow + away);
  if (time - cycle * (follow + away) < follow) return keep_eye_on_ball(view, command);
  const float side = cycle % 2 == 0 ? view.mind.search_side : -view.mind.search_side;
  set_angles(command, side * habits.look_angle, 0);
}

motion::Command stand(const View& view) {
  motion::Command command;
  look_at_ball(view, command);
  return command;
}

motion::Command look_round(const View& view, Mind&, const LookRound& with) {
  motion::Command command;
  scan(view, command, with.angle);
  return command;
}

}  // namespace sim::agent
