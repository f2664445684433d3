#include "sim/agent/ball_skills.h"

#include "sim/agent/features.h"
#include "sim/agent/head.h"
#include "sim/agent/walk.h"

namespace sim::agent {
namespace {

constexpr float kEyesOnBall = 0.7f;      // [m] the head does not look away from a nearer ball
constexpr float kNextToBall = 0.35f;     // [m]
constexpr float kStillBall = 0.35f;      // [m/s] a faster ball is not kicked
constexpr float kFreshBall = 0.7f;       // [s] a ball seen longer ago is not kicked
constexpr float kUseOfTolerance = 0.7f;  // share of the tolerance that the approach uses; noise needs the rest
constexpr float kOtherLeg = 0.03f;       // [m] the ball must lie this far on the other side to change the leg

/// The target of the ball: a point, and the tolerated distance beside it.
struct Target {
  Vec2 point;       // [m, team_field]
  float slack = 0;  // [m] to each side
};

Target target_of(const View& view, Aim aim, float lead) {
  const Vec2 ball = view.ball_in_team;
  switch (aim) {
    case Aim::goal: return {view.goal()};
    case Aim::opening: {
      const Gap gap = widest_gap(view);
      return {{view.half_length, 0.5f * (gap.right + gap.left)}, 0.35f * (gap.left - gap.right)};
    }
    case Aim::away: return {ball + (ball - view.own_goal())};
    case Aim::mate:
      if (const int mate = pass_target(view).mate; mate >= 0)
        return {view.beliefs.mates[mate].pose.position + Vec2{lead, 0}};
      break;
    case Aim::cross: return {{view.half_length - view.around.rules->field.penalty_mark, 0}};
    case Aim::ahead: break;
  }
  return {ball + Vec2{1, 0}};
}

/// The direction in which to send the ball: within the tolerance of the target, and as near as possible to the
/// direction from which the robot comes.
struct Direction {
  Vec2 way;       // [robot] unit vector
  Vec2 straight;  // [robot] unit vector to the target itself
  float allowed;  // cosine of the allowed angle
};

/// Returns about the unit vector at an angle >= 0: 0.5 % off at 1 rad, quicker than the exact one, length exactly 1.
Vec2 about(float angle) {
  const float tangent = 0.5f * angle * (1 + angle * angle / 12);
  const float square = tangent * tangent;
  const float scale = 1 / (1 + square);
  return {(1 - square) * scale, 2 * tangent * scale};
}

Direction direction_of(const View& view, const Target& target, float tolerance) {
  const Vec2 to_target = target.point - view.ball_in_team;
  const float far = length(to_target);
  const Vec2 straight = far > 1e-3f ? turned_back((1 / far) * to_target, view.facing) : Vec2{1, 0};
  // the angle of the slack, approximated for a goal seen obliquely
  const float slack = far > 0.1f ? target.slack * std::abs(to_target.x) / (far * far) : 0;
  const float allowed = slack > tolerance ? (slack < 1.2f ? slack : 1.2f) : tolerance;

  const Vec2 use = about(kUseOfTolerance * allowed);
  const float limit = about(allowed).x;
  // next to the ball the heading counts, farther away the direction to the ball, which the robot will face
  const Vec2 coming = view.ball_distance > kNextToBall ? (1 / view.ball_distance) * view.ball : Vec2{1, 0};
  if (dot(coming, straight) >= use.x) return {coming, straight, limit};
  const float across = cross(straight, coming);
  const float side = across != 0 ? sign(across) : view.mind.search_side;
  return {turned(straight, {use.x, side * use.y}), straight, limit};
}

/// Returns the quickest kick to the front that carries `range`, or the longest when none does.
std::uint8_t choose_kick(const motion::Model& model, float range) {
  int best = -1;
  for (int i = 0; i < model.kick_count; ++i) {
    const motion::Kick& kick = model.kicks[i];
    if (std::abs(kick.direction) > 0.2f) continue;
    if (best < 0) {
      best = i;
      continue;
    }
    const motion::Kick& other = model.kicks[best];
    const bool reaches = kick.range >= range, other_reaches = other.range >= range;
    const bool better = reaches && other_reaches ? kick.delay < other.delay : kick.range > other.range;
    if (reaches != other_reaches ? reaches : better) best = i;
  }
  return static_cast<std::uint8_t>(best < 0 ? 0 : best);
}

/// Remembers the direction of the kick and the leg. Returns the heading for it [rad, robot].
float intend(const View& view, Mind& mind, Vec2 way) {
  const float heading = angle_of(way);
  float in_team = view.beliefs.pose.pose.heading + heading;
  if (in_team > kPi) in_team -= 2 * kPi;
  if (in_team < -kPi) in_team += 2 * kPi;
  mind.kick_direction = in_team;
  const float side = cross(way, view.ball);
  if (std::abs(side) > kOtherLeg) mind.search_side = left_or_right(side);
  return heading;
}

/// Walks to where the ball lies `ahead` [m] in front and `beside` [m] to the left of a robot that faces `way`.
motion::Command approach(const View& view, const Mind& mind, Vec2 way, float heading, float ahead, float beside,
                         float gain) {
  const Vec2 target = view.ball - ahead * way - beside * left_of(way);
  const float room = ahead + 0.07f < 0.3f ? ahead + 0.07f : 0.3f;
  const Vec2 step = round_circle(view.ball, room, target, mind.search_side);
  // near the ball the robot fights for it, farther away it goes round other robots
  motion::Command command =
      view.ball_distance > 0.6f ? walk_in_robot(view, step, heading, gain) : walk_straight(step, heading, gain);
  view.ball_distance < kEyesOnBall ? keep_eye_on_ball(view, command) : look_at_ball(view, command);
  return command;
}

/// Aligns for a kick, and kicks when `kicks` and the ball lies right. Shared by align, kick and pass.
motion::Command shoot(const View& view, Mind& mind, const Target& target, const Kick& with, bool kicks) {
  mind.kick = choose_kick(*view.around.motion, with.range);
  const motion::Kick& kick = view.around.motion->kicks[mind.kick];
  const Direction direction = direction_of(view, target, with.tolerance);
  const float heading = intend(view, mind, direction.way);
  const bool left = mind.search_side > 0;

  // does the ball lie right, and does the robot face an allowed direction?
  const bool faces = direction.straight.x >= direction.allowed;
  const bool lies = faces && in_gate(kick, view.ball, left, with.care);
  mind.aligned = lies ? static_cast<std::uint8_t>(mind.aligned < 255 ? mind.aligned + 1 : 255) : std::uint8_t{0};

  const bool still = squared_length(view.ball_velocity) < kStillBall * kStillBall;
  const bool fresh = age(view.now, view.beliefs.ball.seen) < kFreshBall;
  if (kicks && lies && still && fresh && static_cast<float>(mind.aligned) >= with.frames) {
    motion::Command command;
    command.body = motion::Command::Body::kick;
    command.kick = mind.kick, command.kick_left = left;
    keep_eye_on_ball(view, command);
    return command;
  }
  return approach(view, mind, direction.way, heading, kick.ball_x, left ? kick.ball_y : -kick.ball_y, 1);
}

}  // namespace

motion::Command walk_to_ball(const View& view, Mind& mind, const WalkToBall& with) {
  const Direction direction = direction_of(view, target_of(view, with.aim, 0), with.tolerance);
  const float heading = intend(view, mind, direction.way);
  return approach(view, mind, direction.way, heading, with.distance, 0, with.gain);
}

motion::Command align(const View& view, Mind& mind, const Align& with) {
  return shoot(view, mind, target_of(view, with.aim, 0),
               {.aim = with.aim, .tolerance = with.tolerance, .range = with.range}, false);
}

motion::Command kick(const View& view, Mind& mind, const Kick& with) {
  return shoot(view, mind, target_of(view, with.aim, 0), with, true);
}

motion::Command dribble(const View& view, Mind& mind, const Dribble& with) {
  const Direction direction = direction_of(view, target_of(view, with.aim, 0), with.tolerance);
  const float heading = intend(view, mind, direction.way);
  const float off = cross(direction.way, view.ball);
  const bool behind = dot(direction.way, view.ball) > 0 && std::abs(off) < 0.08f && view.ball_distance < 0.45f;
  if (!behind) return approach(view, mind, direction.way, heading, 0.2f, 0, with.gain);
  motion::Command command = walk_straight(view.ball + 0.4f * direction.way, heading, with.gain);
  keep_eye_on_ball(view, command);
  return command;
}

motion::Command pass(const View& view, Mind& mind, const Pass& with) {
  const Target target = target_of(view, Aim::mate, with.lead);
  const float range = distance(target.point, view.ball_in_team);
  return shoot(
      view, mind, target,
      {.aim = Aim::mate, .tolerance = with.tolerance, .range = range, .care = with.care, .frames = with.frames}, true);
}

}  // namespace sim::agent
