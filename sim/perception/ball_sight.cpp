#include "sim/perception/ball_sight.h"

#include "sim/perception/image.h"

namespace sim::perception {
namespace {

// A foot kicks a ball 0.2 m in front of the body (models.md 2.3). The heat of Northern Bites in 2012 ended at 0.4 m
// (lineage.md 2.3).
constexpr float kKickReach = 0.25f;  // [m] from the middle of an opponent, where the heat is 1
constexpr float kHeatReach = 0.45f;  // [m] where it has fallen to 0

constexpr Tick kFalseInterval = 10;    // [ticks] between the images that may show a false ball, if they are the newest
constexpr float kNearestFalse = 0.3f;  // [m]
constexpr float kBeyondRange = 2;      // [ranges] a percept that seems to be farther away is dropped

/// Returns the place where the image shows the ball: its place `latency` ago, in whole ticks. [m, field]
///
/// The robot's own motion in that time is compensated by odometry. The odometry's error over 70 ms is left out.
Vec2 shown_ball(const PerceptionParams& params, const Ball& ball) {
  const Tick ago = params.effects.latency ? ticks(params.model.camera.latency) : 0;
  return ago == 0 ? ball.position : ball.past[ago - 1];
}

/// Returns the heat [0..1] of one opponent whose ball is at `to_ball` [m, field's axes].
float heat_of(const Body& opponent, Vec2 to_ball) {
  const float range = length(to_ball);
  if (range == 0 || !has_eyes(opponent)) return 0;
  const float facing = dot(opponent.facing, to_ball) / range;
  const float near = range <= kKickReach ? 1 : (kHeatReach - range) / (kHeatReach - kKickReach);
  return facing > 0 ? facing * near : 0;
}

/// Returns the greatest heat of all opponents for a ball at this place [m, field].
float heat_of(const World& world, Side opponents, Vec2 ball) {
  float heat = 0;
  for (int player = 1; player <= world.players; ++player) {
    const Body& opponent = world.bodies[robot_of(opponents, player)];
    const Vec2 to_ball = ball - opponent.position;
    if (squared_length(to_ball) >= kHeatReach * kHeatReach) continue;
    const float of_one = heat_of(opponent, to_ball);
    heat = of_one > heat ? of_one : heat;
  }
  return heat;
}

/// The line from the eye to the ball.
struct LineOfSight {
  Vec2 eye;      // [m, field]
  Vec2 to_ball;  // [m, field's axes]
  float square;  // [m²] of its length
  float offset = cross(eye, to_ball);

  /// Reports whether the line passes through a round thing between both.
  bool meets(Vec2 thing, float radius) const {
    // the distance of the line first: mostly large, so the branch is predictable
    const float across = cross(thing, to_ball) - offset;
    if (across * across >= radius * radius * square) return false;
    const float along = dot(thing - eye, to_ball);
    return along > 0 && along < square;
  }
};

bool is_hidden(const PerceptionParams& params, const World& world, Vec2 eye, const Sighting& ball) {
  const LineOfSight line{eye, ball.to_it, ball.square};
  const float radius = params.contact.hiding_radius;
  // the robot itself is at the eye and hides nothing; a fallen robot is lower than the line
  const auto hides = [&](const Body& body) { return line.meets(body.position, radius) && has_eyes(body); };
  for (int i = 0; i < world.players; ++i)
    if (hides(world.bodies[i]) || hides(world.bodies[kMaxPlayers + i])) return true;
  return params.effects.official && line.meets(world.official.position, params.contact.official_radius);
}

/// Returns the age [ticks] of the newest detection in the last `steps` images, each with the probability `chance`, or
/// `steps` when there is none. `luck` is uniform in [0, 1).
Tick newest_detection(float chance, Tick steps, float luck) {
  float none = 1 - chance;  // probability of no detection in the images so far
  Tick ago = 0;
  while (ago < steps && luck >= 1 - none) none *= 1 - chance, ++ago;
  return ago;
}

/// Returns the statistics of the images that show the ball: the newest, `ago` ticks old, and `earlier` older ones, each
/// with the probability `chance`.
Images images_of(float chance, Tick earlier, Tick ago) {
  const auto most = static_cast<float>(earlier);
  const float count = 1 + chance * most;
  const float sum = 0.5f * chance * most * (most + 1), squares = sum * (2 * most + 1) * (1.f / 3);
  const float middle = sum / count;
  return {count, (middle + static_cast<float>(ago)) * kTickDuration,
          (squares - sum * middle) * (kTickDuration * kTickDuration)};
}

/// Returns the error of a velocity measured from images with this `spread` [s²], of a ball `range` [m] away at `place`
/// [m, robot].
Vec2 velocity_error(const ImageNoise& noise, Vec2 place, float range, float height, float spread,
                    std::array<float, 2> errors) {
  const float per_radian = range_per_elevation(range * range, height);
  const Vec2 error{per_radian * std::sqrt(noise.elevation) * errors[0], range * std::sqrt(noise.bearing) * errors[1]};
  return 1 / (range * std::sqrt(spread)) * turned(error, place);
}

/// Returns the percept of a ball in view, if it is detected. A body between camera and ball hides it; a body does not
/// hide the ball at its own feet.
BallPercept detect_ball(const PerceptionParams& params, const World& world, int robot, Tick steps,
                        const Sighting& sighting) {
  const auto& [model, effects, field, marks, contact, ball] = params;
  const Body& body = world.bodies[robot];
  const float range = std::sqrt(sighting.square);
  std::array<std::uint32_t, 4> words{};
  if (effects.missed_ball || effects.ball_noise)
    words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::ball_seen, world.tick);

  // detected in any of the images, and not hidden; in this order because the second test costs more
  const float chance = effects.missed_ball ? probability(model.ball, range) : 1;
  const Tick ago = newest_detection(chance, steps, uniform(words[0]));
  if (ago == steps) return {};
  if (effects.occlusion && is_hidden(params, world, body.position, sighting)) return {};

  // the measured place and velocity
  BallPercept percept{.seen = true,
                      .position = turned_back(sighting.to_it, body.facing),
                      .velocity = turned_back(world.ball.velocity, body.facing),
                      .ago = ago,
                      .range = range};
  if (effects.ball_noise) {
    const Vec2 place = percept.position;
    const ImageNoise noise = image_noise(model, body);
    const Images images = percept.images = images_of(chance, steps - 1 - ago, ago);
    auto errors = normals(words[1], words[2]);
    const float less = 1 / std::sqrt(images.count);
    for (float& error : errors) error *= less;
    percept.position = seen_through(noise, place, range, sighting.height, kBeyondRange * model.ball.far_range, errors);
    if (percept.position == Vec2{}) return {};
    if (images.spread > 0 && range > 0) {
      const auto more = draw(world.key, static_cast<std::uint32_t>(robot), Draw::ball_noise, world.tick);
      const Vec2 error = velocity_error(noise, place, range, sighting.height, images.spread, normals(more[0], more[1]));
      percept.velocity += error;
      percept.position += images.middle * error;
    }
  }
  percept.heat = heat_of(world, other(side_of(robot)), sighting.to_it + body.position);
  return percept;
}

/// Returns occasionally a false ball at a random place in view.
BallPercept detect_false_ball(const PerceptionParams& params, const World& world, int robot) {
  const Camera& camera = params.model.camera;
  const Body& body = world.bodies[robot];
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::false_ball, world.tick);
  const float chance = params.model.filter.false_per_second * static_cast<float>(kFalseInterval) * kTickDuration;
  if (uniform(words[0]) >= chance) return {};

  const float range = kNearestFalse + uniform(words[1]) * (params.model.ball.far_range - kNearestFalse);
  const Vec2 place = turned(range * body.look, direction(camera.width * (uniform(words[2]) - 0.5f)));
  const Sighting sighting{turned(place, body.facing), range * range, camera.height - params.ball.radius};
  if (!in_view(camera, body, look_of(body), params.model.ball.far_range, sighting)) return {};
  return {.seen = true, .position = place, .range = range};
}

}  // namespace

BallPercept look_for_ball(const PerceptionParams& params, const World& world, int robot, Tick steps, bool followed) {
  const Body& body = world.bodies[robot];
  if (!has_eyes(body)) return {};
  const Camera& camera = params.model.camera;
  const Sighting sighting = sighting_of(body, shown_ball(params, world.ball), camera.height - params.ball.radius);
  if (!params.effects.limited_view || in_view(camera, body, look_of(body), params.model.ball.far_range, sighting)) {
    const BallPercept percept = detect_ball(params, world, robot, followed ? steps : 1, sighting);
    if (percept.seen) return percept;
  }
  if (!params.effects.false_balls || world.tick % kFalseInterval != 0) return {};
  return detect_false_ball(params, world, robot);
}

}  // namespace sim::perception
