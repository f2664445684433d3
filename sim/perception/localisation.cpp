#include "sim/perception/localisation.h"

#include <algorithm>
#include <array>

#include "sim/math/lanes.h"
#include "sim/perception/image.h"

namespace sim::perception {
namespace {

// B-Human call a localisation with smaller deviations superb (models.md 2.5). Such a pose never flips.
constexpr float kSuperb = 0.1f;                   // [m]
constexpr float kSuperbHeading = 10 * kPi / 180;  // [rad]
// The scale error of odometry is constant in a game, so its errors add up between two corrections, over about this way.
// A longer way makes a metre walked with a wrong scale count as more noise.
constexpr float kCorrelated = 1;  // [m], [rad]

float opposite(float heading) { return heading > 0 ? heading - kPi : heading + kPi; }

/// Returns the pose turned by π about the centre of the field, or the pose itself.
Pose2 turned_round_if(bool condition, Pose2 pose) {
  const float round = opposite(pose.heading);
  return {select(condition, -pose.position, pose.position), condition ? round : pose.heading};
}

/// The constants of a look at the marks.
struct MarksConstants {
  const Camera& camera;
  const Localisation& model;
  const field::Marks& marks;
};

/// The robots of one block that look at the marks.
struct MarksBlock {
  // the body and its draws
  Lane<Vec2> position, facing, look;
  Lane<float> heading, head_pitch;
  Lane<std::int32_t> eyes;      // has_eyes
  Lane<std::int32_t> mirrored;  // attacks -x
  DrawLanes draws;
  // the way since the last look
  Lane<float> walked, turned;
  Lane<float> duration;  // [s]
  // the believed pose
  Lane<Vec2> believed;
  Lane<float> believed_heading, deviation, deviation_heading;
  Lane<std::int32_t> flipped, may_flip;
  // the information from the marks in view (inverse variances), weighted by the probability of detection
  Lane<Vec2> axis;  // of the view
  Lane<float> squared_cosine, nearest, farthest;
  Lane<float> of_position;  // [1/m²]
  Lane<float> of_heading;   // [1/rad²]
};

void look_at_marks(MarksBlock& block, const MarksConstants& constants) {
  const Localisation& model = constants.model;
  SIM_FOR_LANES(i) {
    const Vec2 look = turned(block.look[i], block.facing[i]);
    const Window window = window_of(constants.camera, look, block.head_pitch[i], model.mark_range);
    block.axis.set(i, look);
    block.squared_cosine[i] = window.squared_cosine;
    block.nearest[i] = window.nearest;
    block.farthest[i] = window.farthest;
    block.of_position[i] = block.of_heading[i] = 0;
  }

  const float per_metre = 1 / model.mark_range;
  for (int mark = 0; mark < constants.marks.count; ++mark) {
    const Vec2 place = constants.marks.position(mark);
    SIM_FOR_LANES(i) {
      const Window window{block.axis[i], block.squared_cosine[i], block.nearest[i], block.farthest[i]};
      const Vec2 to_mark = place - block.position[i];
      const float square = squared_length(to_mark);
      const float detected = model.mark_near * (1 - std::sqrt(square) * per_metre);
      const bool shown = in_view(window, to_mark, square);
      // the deviation doubles from the feet to 1 m and grows with the square from there
      const float weight = detected / squared(1 + square);
      block.of_position[i] += shown ? weight : 0;
      block.of_heading[i] += shown ? detected : 0;
    }
  }

  SIM_FOR_LANES(i) {
    const float of_position = block.of_position[i] / squared(0.5f * model.mark_deviation);
    const float of_heading = block.of_heading[i] / squared(model.mark_deviation_heading);
    block.of_position[i] = block.eyes[i] != 0 ? of_position : 0;
    block.of_heading[i] = block.eyes[i] != 0 ? of_heading : 0;
  }
}

/// The change of one quantity by a look at the marks: its variance grew on the way, the marks reduce it.
struct Change {
  float gain;       // share of the error that the marks remove
  float deviation;  // standard deviation of the drawn error, from odometry and marks
  float variance;   // after the look
};
Change change_of(float variance, float noise, float grown, float information) {
  const float prior = variance + grown;
  const float rest = 1 / (1 + prior * information);
  const float gain = prior * information * rest;
  return {gain, std::sqrt(squared(rest) * noise + gain * prior * rest), prior * rest};
}

/// Draws once the effect of odometry and marks on the belief since the last look.
void correct_poses(MarksBlock& block, const MarksConstants& constants) {
  const Localisation& model = constants.model;
  SIM_FOR_LANES(i) {
    const float walked = block.walked[i], turned = block.turned[i];
    const bool idle = (walked == 0) & (turned == 0) & (block.of_position[i] == 0);

    // the variance added by the way; the robot also allows for a wrong scale and a wrong heading
    const float noise = squared(model.translation_noise) * walked;
    const float noise_heading = squared(model.rotation_noise) * turned + squared(model.rotation_per_metre) * walked;
    const float systematic = squared(model.bias), astray = squared(block.deviation_heading[i]);
    const Change place = change_of(squared(block.deviation[i]), noise,
                                   noise + 0.5f * (systematic + astray) * walked * kCorrelated, block.of_position[i]);
    const Change heading = change_of(squared(block.deviation_heading[i]), noise_heading,
                                     noise_heading + systematic * turned * kCorrelated, block.of_heading[i]);

    // the marks look the same from the other side
    const Pose2 truth = turned_round_if(block.mirrored[i] != 0, {block.position[i], block.heading[i]});
    const Pose2 seen = turned_round_if(block.flipped[i] != 0, truth);
    const auto words = block.draws.draw(i, Draw::pose_correction);
    const auto shift = normals(words[0], words[1]);
    const auto twist = normals(words[2], words[3]);
    const Vec2 before = block.believed[i];
    const Vec2 corrected = before + place.gain * (seen.position - before);
    const Vec2 position = corrected + place.deviation * Vec2{shift[0], shift[1]};
    const float old = block.believed_heading[i];
    const float error = normalized(old - seen.heading);
    const float now = normalized(old - heading.gain * error + heading.deviation * twist[0]);
    const float deviation = std::sqrt(place.variance), deviation_heading = std::sqrt(heading.variance);
    block.believed.set(i, select(idle, before, position));
    block.believed_heading[i] = idle ? old : now;
    block.deviation[i] = idle ? block.deviation[i] : deviation;
    block.deviation_heading[i] = idle ? block.deviation_heading[i] : deviation_heading;
  }
}

/// Flips the pose of an unsure robot with a small probability, because the field looks the same from both sides. Later
/// the robot notices it and flips back.
void flip_poses(MarksBlock& block, const MarksConstants& constants) {
  const Localisation& model = constants.model;
  SIM_FOR_LANES(i) {
    const bool unsure = (block.deviation[i] > kSuperb) | (block.deviation_heading[i] > kSuperbHeading);
    block.may_flip[i] = (unsure ? 1 : 0) | block.flipped[i];
  }
  if (!any(block.may_flip)) return;
  SIM_FOR_LANES(i) {
    const bool flipped = block.flipped[i] != 0;
    const float noticed = block.duration[i] / model.flip_duration;
    const float lost = model.flips_per_minute / 60 * block.duration[i];
    const auto words = block.draws.draw(i, Draw::pose_flip);
    const bool flips = (block.may_flip[i] != 0) & (uniform(words[0]) < (flipped ? noticed : lost));
    const Pose2 pose = turned_round_if(flips, {block.believed[i], block.believed_heading[i]});
    block.believed.set(i, pose.position);
    block.believed_heading[i] = pose.heading;
    block.flipped[i] = (flipped != flips) ? 1 : 0;
  }
}

void gather_looks(const Look& look, Tick steps, int i, MarksBlock& block) {
  const World& world = *look.world;
  const Body& body = look.body();
  block.position.set(i, body.position);
  block.facing.set(i, body.facing);
  block.look.set(i, body.look);
  block.heading[i] = body.heading;
  block.head_pitch[i] = body.head_pitch;
  block.eyes[i] = has_eyes(body) ? 1 : 0;
  block.mirrored[i] = attack_sign(world, side_of(look.robot)) < 0 ? 1 : 0;
  block.draws.set(i, world.key, look.robot, world.tick);
  const Cognition& cognition = *look.cognition;
  block.walked[i] = cognition.walked;
  block.turned[i] = static_cast<float>(cognition.turned) * kTurnUnit;
  block.flipped[i] = cognition.flipped ? 1 : 0;
  block.duration[i] = static_cast<float>(steps) * kTickDuration;
  const agent::Pose& belief = look.beliefs->pose;
  block.believed.set(i, belief.pose.position);
  block.believed_heading[i] = belief.pose.heading;
  block.deviation[i] = belief.deviation;
  block.deviation_heading[i] = belief.deviation_heading;
}

void scatter_looks(const MarksBlock& block, int i, const Look& look) {
  look.beliefs->pose = {{block.believed[i], block.believed_heading[i]}, block.deviation[i], block.deviation_heading[i]};
  look.cognition->walked = 0;
  look.cognition->turned = 0;
  look.cognition->flipped = block.flipped[i] != 0;
}

}  // namespace

Pose2 true_pose(const World& world, int robot) {
  const Body& body = world.bodies[robot];
  return turned_round_if(attack_sign(world, side_of(robot)) < 0, {body.position, body.heading});
}

void lose_pose(const Localisation& model, const World& world, int robot, agent::Pose& belief) {
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::lost_pose, world.tick);
  const auto shift = normals(words[0], words[1]);
  const auto twist = normals(words[2], words[3]);
  belief.pose.position += model.fall_deviation * Vec2{shift[0], shift[1]};
  belief.pose.heading = normalized(belief.pose.heading + model.fall_deviation_heading * twist[0]);
  belief.deviation = std::sqrt(squared(belief.deviation) + squared(model.fall_deviation));
  belief.deviation_heading = std::sqrt(squared(belief.deviation_heading) + squared(model.fall_deviation_heading));
}

void look_round(const PerceptionParams& params, std::span<const Look> looks) {
  const MarksConstants constants{params.model.camera, params.model.localisation, params.marks};
  const Tick interval = ticks(params.model.localisation.mark_interval);
  MarksBlock block{};
  const auto compute = [&] {
    in_lanes<look_at_marks>(block, constants);
    in_lanes<correct_poses>(block, constants);
    if (params.effects.pose_flips) in_lanes<flip_poses>(block, constants);
  };
  in_blocks(
      looks, [&](const Look& look, int i) { gather_looks(look, std::max(look.steps, interval), i, block); }, compute,
      [&](const Look& look, int i) { scatter_looks(block, i, look); });
}

void localise(const PerceptionParams& params, std::span<const Look> looks) {
  if (!params.effects.odometry_drift) return;
  const Tick interval = ticks(params.model.localisation.mark_interval);
  std::array<Look, kMostLooks> due;
  std::size_t count = 0;
  for (const Look& look : looks) {
    if (params.effects.lost_pose && fell(look.body(), look.world->tick, look.steps))
      lose_pose(params.model.localisation, *look.world, look.robot, look.beliefs->pose);
    if (look.world->tick % interval < look.steps) due[count++] = look;
  }
  look_round(params, {due.data(), count});
}

}  // namespace sim::perception
