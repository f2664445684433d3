#include "sim/perception/ball_sight.h"

#include <algorithm>
#include <array>
#include <optional>

#include "sim/math/lanes.h"
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

BallPercept no_percept() { return {.images = {.count = 1}}; }

/// The constants of a look for the ball.
struct SightConstants {
  const Model& model;
  const Effects& effects;
  float height;  // [m] of the camera above the ball
  Tick latency;  // [ticks] of the images
};

SightConstants sight_constants(const PerceptionParams& params) {
  return {params.model, params.effects, params.model.camera.height - params.ball.radius,
          params.effects.latency ? ticks(params.model.camera.latency) : 0};
}

/// Returns the place where the image shows the ball: its place `latency` ago. [m, field]
///
/// The robot's own motion in that time is compensated by odometry. The odometry's error over 70 ms is left out.
Vec2 shown_ball(const SightConstants& constants, const Ball& ball) {
  return constants.latency == 0 ? ball.position : ball.past[constants.latency - 1];
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

/// Returns the statistics of the images that show the ball: the newest, `ago` ticks old, and `earlier` older ones, each
/// with the probability `chance`.
Images images_of(float chance, float earlier, float ago) {
  const float count = 1 + chance * earlier;
  const float sum = 0.5f * chance * earlier * (earlier + 1), squares = sum * (2 * earlier + 1) * (1.f / 3);
  const float middle = sum / count;
  return {count, (middle + ago) * kTickDuration, (squares - sum * middle) * (kTickDuration * kTickDuration)};
}

/// Returns the error of a velocity measured from images with this `spread` [s²], of a ball `range` [m] away at `place`
/// [m, robot].
Vec2 velocity_error(const ImageNoise& noise, Vec2 place, float range, float height, float spread,
                    std::array<float, 2> errors) {
  const float per_radian = range_per_elevation(range * range, height);
  const Vec2 error{per_radian * std::sqrt(noise.elevation) * errors[0], range * std::sqrt(noise.bearing) * errors[1]};
  return 1 / (range * std::sqrt(spread)) * turned(error, place);
}

/// The robots of one block that look for the ball.
struct SightBlock {
  // the body, its draws and the ball that the image shows
  Lane<Vec2> position, facing, look, ball;
  Lane<float> head_pitch;
  DrawLanes draws;
  Lane<std::int32_t> steps;  // images, 0 for a robot without eyes
  std::int32_t most;         // of them
  // the newest detection
  Lane<float> square, range;  // [m²], [m]
  Lane<float> chance;         // of a detection in one image
  Lane<float> luck, missed;   // a draw, and the probability of no detection in the images so far
  Lane<std::int32_t> ago;     // [ticks] age of the newest detection; `steps`: there is none
};

/// Decides which images show the ball, if nothing hides it.
void detect_balls(SightBlock& block, const SightConstants& constants) {
  const auto& [model, effects, height, latency] = constants;
  const std::int32_t everywhere = effects.limited_view ? 0 : 1;
  const float least = effects.missed_ball ? 0 : 1;
  SIM_FOR_LANES(i) {
    const Sighting sighting = sighting_of(block.ball[i] - block.position[i], height);
    const Vec2 look = turned(block.look[i], block.facing[i]);
    const bool shown = in_view(model.camera, block.head_pitch[i], look, model.ball.far_range, sighting);
    const float range = std::sqrt(sighting.square), chance = probability(model.ball, range);
    block.square[i] = sighting.square;
    block.range[i] = range;
    block.chance[i] = chance < least ? least : chance;
    block.steps[i] = ((shown ? 1 : 0) | everywhere) != 0 ? block.steps[i] : 0;
    block.ago[i] = 0;
  }

  if (!any(block.steps)) return;

  // go back from the newest image until one shows the ball
  SIM_FOR_LANES(i) {
    block.luck[i] = uniform(block.draws.draw(i, Draw::ball_seen)[0]);
    block.missed[i] = 1 - block.chance[i];
  }
  for (std::int32_t step = 0; step < block.most; ++step) {
    SIM_FOR_LANES(i) {
      const bool none = (block.ago[i] == step) & (step < block.steps[i]) & (block.luck[i] >= 1 - block.missed[i]);
      const float further = block.missed[i] * (1 - block.chance[i]);
      block.ago[i] = none ? step + 1 : block.ago[i];
      block.missed[i] = none ? further : block.missed[i];
    }
  }
}

/// The robots of one block that detected the ball, and their percepts.
struct PerceptBlock {
  Lane<Vec2> position, facing, ball, velocity;
  Lane<std::int32_t> stands;
  DrawLanes draws;
  Lane<float> range, chance, earlier, ago;
  Lane<Vec2> place, speed;
  Lane<float> count, middle, spread;
};

/// Measures the ball's place and velocity with the noise of the images.
void measure_balls(PerceptBlock& block, const SightConstants& constants) {
  const auto& [model, effects, height, latency] = constants;
  const ImageNoise standing = image_noise(model, true), walking = image_noise(model, false);
  const float farthest = kBeyondRange * model.ball.far_range;
  SIM_FOR_LANES(i) {
    const ImageNoise noise = select(block.stands[i] != 0, standing, walking);
    const Vec2 place = turned_back(block.ball[i] - block.position[i], block.facing[i]);
    const Vec2 velocity = turned_back(block.velocity[i], block.facing[i]);
    const Images images = images_of(block.chance[i], block.earlier[i], block.ago[i]);
    const auto words = block.draws.draw(i, Draw::ball_seen);
    const auto errors = normals(words[1], words[2]);
    const float less = 1 / std::sqrt(images.count);
    const Seen seen =
        seen_through(noise, place, block.range[i], height, farthest, {errors[0] * less, errors[1] * less});

    // several images also show the velocity
    const auto more = block.draws.draw(i, Draw::ball_noise);
    const Vec2 error = velocity_error(noise, place, block.range[i], height, images.spread, normals(more[0], more[1]));
    const bool several = (images.spread > 0) & (block.range[i] > 0);
    block.place.set(i, select(several, seen.place + images.middle * error, seen.place));
    block.speed.set(i, select(several, velocity + error, velocity));
    block.count[i] = seen.is_valid != 0 ? images.count : 0;
    block.middle[i] = images.middle;
    block.spread[i] = images.spread;
  }
}

/// A ball that was detected in images, and is not hidden.
struct Detected {
  const Look* look;
  BallPercept* percept;
  float chance;
  Tick earlier;  // images before the newest detection
};

void gather_detected(const SightConstants& constants, const Detected& detected, int i, PerceptBlock& block) {
  const World& world = *detected.look->world;
  const Body& body = detected.look->body();
  block.position.set(i, body.position);
  block.facing.set(i, body.facing);
  block.ball.set(i, shown_ball(constants, world.ball));
  block.velocity.set(i, world.ball.velocity);
  block.stands[i] = body.doing == Body::Doing::standing ? 1 : 0;
  block.draws.set(i, world.key, detected.look->robot, world.tick);
  block.range[i] = detected.percept->range;
  block.chance[i] = detected.chance;
  block.earlier[i] = static_cast<float>(detected.earlier);
  block.ago[i] = static_cast<float>(detected.percept->ago);
}

void scatter_percept(const PerceptBlock& block, int i, BallPercept& percept) {
  percept.seen = block.count[i] != 0;
  percept.position = block.place[i];
  percept.velocity = block.speed[i];
  percept.images = {block.count[i], block.middle[i], block.spread[i]};
}

/// Measures the balls with the noise of the images, or without any.
void measure(const PerceptionParams& params, const SightConstants& constants, std::span<const Detected> all) {
  if (!params.effects.ball_noise) {
    for (const Detected& detected : all) {
      const World& world = *detected.look->world;
      const Body& body = detected.look->body();
      detected.percept->position = turned_back(shown_ball(constants, world.ball) - body.position, body.facing);
      detected.percept->velocity = turned_back(world.ball.velocity, body.facing);
    }
    return;
  }
  PerceptBlock block{};
  in_blocks(
      all, [&](const Detected& one, int i) { gather_detected(constants, one, i, block); },
      [&] { in_lanes<measure_balls>(block, constants); },
      [&](const Detected& one, int i) { scatter_percept(block, i, *one.percept); });
}

/// Returns the detection of one lane, if there is one and nothing hides the ball. A body between camera and ball hides it;
/// a body does not hide the ball at its own feet.
std::optional<Detected> detected_in(const PerceptionParams& params, const SightConstants& constants,
                                    const SightBlock& block, int i, const Look& look, BallPercept& percept) {
  if (block.ago[i] >= block.steps[i]) return std::nullopt;
  const Sighting sighting{block.ball[i] - block.position[i], block.square[i], constants.height};
  if (params.effects.occlusion && is_hidden(params, *look.world, block.position[i], sighting)) return std::nullopt;
  percept.seen = true;
  percept.ago = static_cast<Tick>(block.ago[i]);
  percept.range = block.range[i];
  percept.heat = heat_of(*look.world, other(side_of(look.robot)), sighting.to_it + block.position[i]);
  return Detected{&look, &percept, block.chance[i], static_cast<Tick>(block.steps[i]) - 1 - percept.ago};
}

void gather_sight(const SightConstants& constants, const Look& look, int i, SightBlock& block) {
  const World& world = *look.world;
  const Body& body = look.body();
  block.position.set(i, body.position);
  block.facing.set(i, body.facing);
  block.look.set(i, body.look);
  block.ball.set(i, shown_ball(constants, world.ball));
  block.head_pitch[i] = body.head_pitch;
  block.draws.set(i, world.key, look.robot, world.tick);
  const Tick images = look.beliefs->ball.visible ? look.steps : 1;
  block.steps[i] = has_eyes(body) ? static_cast<std::int32_t>(images) : 0;
  block.most = std::max(i == 0 ? 0 : block.most, block.steps[i]);
}

/// Returns occasionally a false ball at a random place in view.
BallPercept detect_false_ball(const PerceptionParams& params, const World& world, int robot) {
  const Camera& camera = params.model.camera;
  const Body& body = world.bodies[robot];
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::false_ball, world.tick);
  const float chance = params.model.filter.false_per_second * static_cast<float>(kFalseInterval) * kTickDuration;
  if (uniform(words[0]) >= chance) return no_percept();

  const float range = kNearestFalse + uniform(words[1]) * (params.model.ball.far_range - kNearestFalse);
  const Vec2 place = turned(range * body.look, direction(camera.width * (uniform(words[2]) - 0.5f)));
  const Sighting sighting{turned(place, body.facing), range * range, camera.height - params.ball.radius};
  if (!in_view(camera, body.head_pitch, look_of(body), params.model.ball.far_range, sighting)) return no_percept();
  BallPercept percept = no_percept();
  percept.seen = true;
  percept.position = place;
  percept.range = range;
  return percept;
}

}  // namespace

void look_for_ball(const PerceptionParams& params, std::span<const Look> looks, std::span<BallPercept> percepts) {
  const SightConstants constants = sight_constants(params);
  std::array<Detected, kMostLooks> detected;
  std::size_t count = 0;
  SightBlock block{};
  auto percept = percepts.begin();
  in_blocks(
      looks, [&](const Look& look, int i) { gather_sight(constants, look, i, block); },
      [&] { in_lanes<detect_balls>(block, constants); },
      [&](const Look& look, int i) {
        *percept = no_percept();
        if (const auto seen = detected_in(params, constants, block, i, look, *percept)) detected[count++] = *seen;
        ++percept;
      });
  measure(params, constants, {detected.data(), count});

  if (!params.effects.false_balls) return;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const World& world = *looks[i].world;
    if (!percepts[i].seen && world.tick % kFalseInterval == 0 && has_eyes(looks[i].body()))
      percepts[i] = detect_false_ball(params, world, looks[i].robot);
  }
}

BallPercept look_for_ball(const PerceptionParams& params, const World& world, int robot) {
  agent::Beliefs unseen;
  const Look look{&world, &unseen, nullptr, robot, 1};
  BallPercept percept;
  look_for_ball(params, {&look, 1}, {&percept, 1});
  return percept;
}

}  // namespace sim::perception
