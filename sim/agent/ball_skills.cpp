#include "sim/agent/ball_skills.h"

#include "sim/agent/features.h"
#include "sim/agent/head.h"
#include "sim/agent/past.h"
#include "sim/agent/walk.h"

namespace sim::agent {
namespace {

constexpr float kEyesOnBall = 0.7f;  // [m] the head does not look away from a nearer ball
constexpr float kStillBall = 0.35f;  // [m/s] a faster ball is not kicked
constexpr float kFreshBall = 0.7f;   // [s] a ball seen longer ago is not kicked

/// Remembers the direction of the kick. Returns the heading of `face` [rad, robot].
float intend(const View& view, Mind& mind, Vec2 way, Vec2 face) {
  const float heading = angle_of(way);
  float in_team = view.beliefs.pose.pose.heading + heading;
  if (in_team > kPi) in_team -= 2 * kPi;
  if (in_team < -kPi) in_team += 2 * kPi;
  mind.kick_direction = in_team;
  return way == face ? heading : angle_of(face);
}

/// Chooses a direction for a ball that is walked ahead, and the leg for a later kick.
Vec2 walking_way(const View& view, Mind& mind, const Where& to, float tolerance, const Dribble* past = nullptr) {
  Vec2 way = way_in(sector_of(view, target_of(view, to, 0), tolerance), view, {1, 0});
  if (past && past->past == Past::nearest) way = past_nearest(view, way, past->room);
  const float side = cross(way, view.ball);
  if (std::abs(side) > kOtherLeg) mind.search_side = left_or_right(side);
  return way;
}

/// Moves the head on the way to the ball. At the own set play the ball lies where the rules put it. There the robot looks
/// at its way: eyes on a ball 2 m away do not see a robot less than 0.4 m from the feet, and it would push that one.
void look_ahead(const View& view, motion::Command& command) {
  const bool lies_still = view.game.own_kick && view.game.set_play != Game::SetPlay::none;
  if (view.ball_distance < kEyesOnBall) return keep_eye_on_ball(view, command);
  lies_still ? scan(view, command, view.settings.habits.look_angle) : look_at_ball(view, command);
}

/// Walks to `target` [robot] and faces `heading`, round the ball without coming nearer to it than `room` [m].
motion::Command approach(const View& view, const Mind& mind, Vec2 target, float heading, float room, float gain) {
  const Vec2 step = round_circle(view, view.ball, room, target, mind.search_side);
  // near the ball the robot fights for it, farther away it goes round other robots
  const bool far = view.ball_distance > 0.6f;
  const Vec2 way = far ? round_robots(view, step) : step;
  // On a way round a robot, the legs are quickest ahead. To a set play the time is short; else the ball is in reach of
  // others, and the robot turns to its kick early.
  const bool hurries = view.game.own_kick && !(way == step);
  motion::Command command = walk_straight(way, hurries ? angle_of(way) : heading, gain);
  look_ahead(view, command);
  return command;
}

/// Walks to `distance` [m] behind the ball, for a ball that goes `way`.
motion::Command approach_from_behind(const View& view, const Mind& mind, Vec2 way, float heading, float distance,
                                     float gain) {
  return approach(view, mind, view.ball - distance * way, heading, room_of(distance), gain);
}

/// Aligns for a kick, and kicks when `kicks` and the ball lies right. Shared by align, kick and pass.
motion::Command shoot(const View& view, Mind& mind, const Target& target, const Kick& with, bool kicks) {
  const Sector sector = sector_of(view, target, with.tolerance);
  const Shot shot = choose_shot(view, sector, with.kick, with.range);
  const motion::Kick& kick = view.around.motion->kicks[shot.kick];
  mind.kick = shot.kick, mind.search_side = shot.side;
  const float heading = intend(view, mind, shot.way, shot.face);
  const bool left = shot.side > 0;

  // does the ball lie right, and would it go in an allowed direction?
  const bool faces = dot(sector.straight, shot.bend) >= sector.allowed;
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
  const Vec2 place = place_for(kick, view.ball, shot.face, shot.side);
  return approach(view, mind, place, heading, room_of(kick.ball_x), 1);
}

}  // namespace

motion::Command walk_to_ball(const View& view, Mind& mind, const WalkToBall& with) {
  const Vec2 way = walking_way(view, mind, with.to, with.tolerance);
  return approach_from_behind(view, mind, way, intend(view, mind, way, way), with.distance, with.gain);
}

motion::Command align(const View& view, Mind& mind, const Align& with) {
  return shoot(view, mind, target_of(view, with.to, 0),
               {.to = with.to, .tolerance = with.tolerance, .range = with.range, .kick = with.kick}, false);
}

motion::Command kick(const View& view, Mind& mind, const Kick& with) {
  return shoot(view, mind, target_of(view, with.to, 0), with, true);
}

motion::Command dribble(const View& view, Mind& mind, const Dribble& with) {
  const Vec2 way = walking_way(view, mind, with.to, with.tolerance, &with);
  const float heading = intend(view, mind, way, way);
  const float off = cross(way, view.ball);
  const bool behind = dot(way, view.ball) > 0 && std::abs(off) < 0.08f && view.ball_distance < 0.45f;
  if (!behind) return approach_from_behind(view, mind, way, heading, 0.2f, with.gain);
  motion::Command command = walk_straight(view.ball + 0.4f * way, heading, with.gain);
  keep_eye_on_ball(view, command);
  return command;
}

motion::Command pass(const View& view, Mind& mind, const Pass& with) {
  const Target target = target_of(view, with.to, with.lead);
  const float range = distance(target.point, view.ball_in_team);
  return shoot(view, mind, target,
               {.to = with.to,
                .tolerance = with.tolerance,
                .range = range,
                .care = with.care,
                .frames = with.frames,
                .kick = with.kick},
               true);
}

}  // namespace sim::agent
