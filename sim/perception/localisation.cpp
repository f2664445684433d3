#include "sim/perception/localisation.h"

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

Pose2 turned_round(Pose2 pose) { return {-pose.position, opposite(pose.heading)}; }

/// The information from the marks in view (inverse variances), weighted by the probability of detection.
struct Information {
  float position = 0;  // [1/m²]
  float heading = 0;   // [1/rad²]
};
Information look_at_marks(const PerceptionParams& params, const Body& body) {
  const Localisation& model = params.model.localisation;
  Information information;
  if (!has_eyes(body)) return information;
  const Window window = window_of(params.model.camera, body, model.mark_range);
  const field::Marks& marks = params.marks;
  float squares[field::Marks::kMost];
  std::uint32_t shown[field::Marks::kMost];
  for (int block = 0; block < marks.count; block += field::Marks::kBlock)
    for (int i = block; i < block + field::Marks::kBlock; ++i) {
      const Vec2 to_mark = marks.position(i) - body.position;
      squares[i] = squared_length(to_mark);
      shown[i] = in_view(window, to_mark, squares[i]) ? 1u : 0u;
    }

  const float per_metre = 1 / model.mark_range;
  for (int i = 0; i < marks.count; ++i) {
    if (shown[i] == 0) continue;
    const float square = squares[i];
    const float detected = model.mark_near * (1 - std::sqrt(square) * per_metre);
    // the deviation doubles from the feet to 1 m and grows with the square from there
    information.position += detected / squared(1 + square);
    information.heading += detected;
  }
  information.position /= squared(0.5f * model.mark_deviation);
  information.heading /= squared(model.mark_deviation_heading);
  return information;
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
void look(const PerceptionParams& params, const World& world, int robot, agent::Pose& belief, Cognition& cognition) {
  const Localisation& model = params.model.localisation;
  const Information information = look_at_marks(params, world.bodies[robot]);
  const float walked = cognition.walked;
  const float turned = static_cast<float>(cognition.turned) * kTurnUnit;
  cognition.walked = 0;
  cognition.turned = 0;
  if (walked == 0 && turned == 0 && information.position == 0) return;

  // the variance added by the way; the robot also allows for a wrong scale and a wrong heading
  const float noise = squared(model.translation_noise) * walked;
  const float noise_heading = squared(model.rotation_noise) * turned + squared(model.rotation_per_metre) * walked;
  const float systematic = squared(model.bias), astray = squared(belief.deviation_heading);
  const Change place = change_of(squared(belief.deviation), noise,
                                 noise + 0.5f * (systematic + astray) * walked * kCorrelated, information.position);
  const Change heading = change_of(squared(belief.deviation_heading), noise_heading,
                                   noise_heading + systematic * turned * kCorrelated, information.heading);

  // the marks look the same from the other side
  const Pose2 truth = true_pose(world, robot);
  const Pose2 seen = cognition.flipped ? turned_round(truth) : truth;
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::pose_correction, world.tick);
  const auto shift = normals(words[0], words[1]);
  const auto twist = normals(words[2], words[3]);
  belief.pose.position += place.gain * (seen.position - belief.pose.position);
  belief.pose.position += place.deviation * Vec2{shift[0], shift[1]};
  const float error = normalized(belief.pose.heading - seen.heading);
  belief.pose.heading = normalized(belief.pose.heading - heading.gain * error + heading.deviation * twist[0]);
  belief.deviation = std::sqrt(place.variance);
  belief.deviation_heading = std::sqrt(heading.variance);
}

/// Flips the pose of an unsure robot with a small probability, because the field looks the same from both sides. Later
/// the robot notices it and flips back.
void flip(const Localisation& model, const World& world, int robot, float duration, agent::Pose& belief,
          Cognition& cognition) {
  const bool unsure = belief.deviation > kSuperb || belief.deviation_heading > kSuperbHeading;
  if (!unsure && !cognition.flipped) return;
  const float chance = cognition.flipped ? duration / model.flip_duration : model.flips_per_minute / 60 * duration;
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::pose_flip, world.tick);
  if (uniform(words[0]) >= chance) return;
  belief.pose = turned_round(belief.pose);
  cognition.flipped = !cognition.flipped;
}

}  // namespace

Pose2 true_pose(const World& world, int robot) {
  const Body& body = world.bodies[robot];
  const Pose2 pose{body.position, body.heading};
  return attack_sign(world, side_of(robot)) > 0 ? pose : turned_round(pose);
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

void look_round(const PerceptionParams& params, const World& world, int robot, Tick steps, agent::Pose& belief,
                Cognition& cognition) {
  look(params, world, robot, belief, cognition);
  if (!params.effects.pose_flips) return;
  flip(params.model.localisation, world, robot, static_cast<float>(steps) * kTickDuration, belief, cognition);
}

}  // namespace sim::perception
