#include "sim/perception/odometry.h"

#include "sim/math/lanes.h"
#include "sim/perception/estimate.h"
#include "sim/perception/localisation.h"

namespace sim::perception {
namespace {

/// The constants of a prediction.
struct OdometryConstants {
  float deceleration;  // [m/s²] of the ball
  float noise;         // [m²/s³] variance of the ball's velocity added per second
  float most;          // [m²] variance of a ball that may be anywhere
};

OdometryConstants constants_of(const PerceptionParams& params) {
  const BallFilter& filter = params.model.filter;
  return {params.ball.deceleration, filter.acceleration_noise * filter.acceleration_noise * kTickDuration,
          filter.lost_deviation * filter.lost_deviation};
}

/// The body of a robot, and its odometry before the look.
struct Walker {
  Vec2 position;
  float heading;
  Vec2 facing;
  Pose2 last;
  float scale, turn_scale;
};

/// The believed motion since the last reading. [robot, present pose]
struct Odometry {
  Vec2 moved;    // [m]
  float way;     // [m] length of `moved`
  float turned;  // [rad]
  Vec2 turn;     // unit vector at `turned`
};

/// Returns the unit vector at `angle` [rad]. A small angle has the bits of sin_cos_of_rest.
Vec2 direction_of_turn(float angle) {
  const float shifted = std::fabs(angle) > kPi / 4 ? angle * (2.f / kPi) + detail::kRound : detail::kRound;
  const SinCos both = detail::sin_cos_shifted(angle, shifted);
  return {both.cos, both.sin};
}

/// Returns the believed motion from `last` to the present pose.
Odometry odometry_of(const Walker& robot) {
  const Vec2 way = robot.position - robot.last.position;
  const bool walked = (robot.position.x != robot.last.position.x) | (robot.position.y != robot.last.position.y);
  const Vec2 moved = select(walked, robot.scale * turned_back(way, robot.facing), {});
  const float turned = robot.turn_scale * normalized(robot.heading - robot.last.heading);
  const float angle = robot.heading != robot.last.heading ? turned : 0;
  return {moved, length(moved), angle, direction_of_turn(angle)};
}

/// Rolls a ball on turf that slows it down for `dt` [s]. The ball does not roll back.
Estimate rolled(Estimate ball, float deceleration, float dt) {
  const float square = squared_length(ball.velocity);
  const float speed = std::sqrt(square), lost = deceleration * dt;
  const bool stops = !(lost < speed), rolls = square != 0;
  const float share = lost / speed;
  const float way = stops ? 0.5f * speed / deceleration : dt * (1 - 0.5f * share);
  ball.position = select(rolls, ball.position + way * ball.velocity, ball.position);
  ball.velocity = select(rolls, select(stops, {}, (1 - share) * ball.velocity), ball.velocity);
  return ball;
}

/// Returns the ball that lies or rolls, seen from the robot that moved.
Estimate moved_on(const OdometryConstants& constants, const Odometry& odometry, float dt, Estimate ball) {
  // the same place in the frame of the robot that moved
  const bool turned = odometry.turned != 0;
  ball.position = select(turned, turned_back(ball.position, odometry.turn), ball.position) - odometry.moved;
  ball.velocity = select(turned, turned_back(ball.velocity, odometry.turn), ball.velocity);

  // the ball rolls; a ball that may be anywhere needs no prediction
  const bool anywhere = ball.variance >= constants.most;
  Estimate next = rolled(ball, constants.deceleration, dt);

  // white noise of the acceleration, with the standard deviation `acceleration_noise` in each tick
  const float noise = constants.noise * dt;
  next.variance += dt * (2 * ball.covariance + dt * (ball.velocity_variance + noise * (1.f / 3)));
  next.covariance += dt * (ball.velocity_variance + 0.5f * noise);
  next.velocity_variance += noise;
  const bool lost = next.variance >= constants.most;
  next.variance = lost ? constants.most : next.variance;
  next.velocity = select(lost, {}, next.velocity);
  return select(anywhere, ball, next);
}

/// The robots of one block.
struct OdometryBlock {
  Lane<Vec2> position, facing, last_position;
  Lane<float> heading, last_heading, scale, turn_scale;
  Lane<float> dt;  // [s]
  BallLanes ball;
  Lane<Vec2> believed;  // position of the believed pose [team_field]
  Lane<float> believed_heading, way, turned;
};

void predict_block(OdometryBlock& block, const OdometryConstants& constants) {
  SIM_FOR_LANES(i) {
    const Odometry odometry = odometry_of({block.position[i],
                                           block.heading[i],
                                           block.facing[i],
                                           {block.last_position[i], block.last_heading[i]},
                                           block.scale[i],
                                           block.turn_scale[i]});
    block.ball.set(i, moved_on(constants, odometry, block.dt[i], block.ball.get(i)));

    // the believed pose
    const float turned_on = normalized(block.believed_heading[i] + odometry.turned);
    const float heading = odometry.turned != 0 ? turned_on : block.believed_heading[i];
    const Vec2 moved = block.believed[i] + turned(odometry.moved, direction(heading));
    block.believed.set(i, select(odometry.way > 0, moved, block.believed[i]));
    block.believed_heading[i] = heading;
    block.way[i] = odometry.way;
    block.turned[i] = odometry.turned;
  }
}

void gather_walk(const Look& look, int i, OdometryBlock& block) {
  const Body& body = look.body();
  block.position.set(i, body.position);
  block.facing.set(i, body.facing);
  block.heading[i] = body.heading;
  const Cognition& cognition = *look.cognition;
  block.last_position.set(i, cognition.last.position);
  block.last_heading[i] = cognition.last.heading;
  block.scale[i] = cognition.odometry_scale;
  block.turn_scale[i] = cognition.turn_scale;
  block.dt[i] = static_cast<float>(look.steps) * kTickDuration;
  block.ball.gather(i, look.beliefs->ball);
  block.believed.set(i, look.beliefs->pose.pose.position);
  block.believed_heading[i] = look.beliefs->pose.pose.heading;
}

void scatter_walk(const PerceptionParams& params, const OdometryBlock& block, int i, const Look& look) {
  if (look.beliefs->ball.seen != kNever) block.ball.scatter(i, look.beliefs->ball);
  Cognition& cognition = *look.cognition;
  cognition.last = {block.position[i], block.heading[i]};
  if (!params.effects.odometry_drift) {
    look.beliefs->pose = {.pose = true_pose(*look.world, look.robot)};
    return;
  }
  look.beliefs->pose.pose = {block.believed[i], block.believed_heading[i]};
  cognition.walked += block.way[i];
  const float turned = static_cast<float>(cognition.turned) + std::fabs(block.turned[i]) * (1 / kTurnUnit) + 0.5f;
  cognition.turned = static_cast<std::uint16_t>(turned < 65535 ? turned : 65535);
}

}  // namespace

void predict(const PerceptionParams& params, std::span<const Look> looks) {
  const OdometryConstants constants = constants_of(params);
  OdometryBlock block{};
  in_blocks(
      looks, [&](const Look& look, int i) { gather_walk(look, i, block); },
      [&] { in_lanes<predict_block>(block, constants); },
      [&](const Look& look, int i) { scatter_walk(params, block, i, look); });
}

}  // namespace sim::perception
