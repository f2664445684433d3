#include "sim/perception/localisation.h"

#include "sim/perception/image.h"

namespace sim::perception {
namespace {

// B-Human call a localisation superb up to these (models.md 2.5); nobody turns the field round while it is.
constexpr float kSuperb = 0.1f;                   // [m]
constexpr float kSuperbHeading = 10 * kPi / 180;  // [rad]
// The scale of odometry is off by the same all game. Between two corrections that adds up over about this way: the
// longer it is, the more a metre walked with a wrong scale counts as noise.
constexpr float kCorrelated = 1;  // [m], [rad]

float squared(float x) { return x * x; }

float opposite(float heading) { return heading > 0 ? heading - kPi : heading + kPi; }

Pose2 turned_round(Pose2 pose) { return {-pose.position, opposite(pose.heading)}; }

/// [1/m²], [1/rad²] What the marks in view tell, each as often as it is detected.
struct Information {
  float position = 0;
  float heading = 0;
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

/// The variance of one quantity through a look at the marks: it grew on the way, the marks make it less.
struct Change {
  float gain;       // share of the error that the marks take away
  float deviation;  // of the error that is drawn: by odometry and by the marks
  float variance;   // afterwards
};
Change change_of(float variance, float noise, float grown, float information) {
  const float prior = variance + grown;
  const float rest = 1 / (1 + prior * information);
  const float gain = prior * information * rest;
  return {gain, std::sqrt(squared(rest) * noise + gain * prior * rest), prior * rest};
}

/// One draw for all that odometry and the marks did to the belief since the last look.
void look(const PerceptionParams& params, const World& world, int robot, agent::Pose& belief, Cognition& cognition) {
  const Localisation& model = params.model.localisation;
  const Information information = look_at_marks(params, world.bodies[robot]);
  const float walked = cognition.walked;
  const float turned = static_cast<float>(cognition.turned) * kTurnUnit;
  cognition.walked = 0;
  cognition.turned = 0;
  if (walked == 0 && turned == 0 && information.position == 0) return;

  // what the way added, and what of it the robot reckons with: the scale besides, and walking in a wrong direction
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

/// The field looks the same from both sides: rarely a robot that is unsure turns it round, and later it notices.
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

void look_round(const PerceptionParams& params, const World& world, int robot, Tick steps, agent::Pose& belief,
                Cognition& cognition) {
  look(params, world, robot, belief, cognition);
  if (!params.effects.pose_flips) return;
  flip(params.model.localisation, world, robot, static_cast<float>(steps) * kTickDuration, belief, cognition);
}

}  // namespace sim::perception
