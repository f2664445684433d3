// Looks of many robots have the bits of looks alone, whatever the numbers are.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "sim/math/lanes.h"
#include "tests/sim/perception/scene.h"

namespace sim::perception {
namespace {

#ifdef NDEBUG
constexpr int kRounds = 5000;
#else
constexpr int kRounds = 100;  // without optimisation
#endif

/// Mostly moderate numbers, and every special kind of number.
float wild(std::mt19937& random) {
  using Limits = std::numeric_limits<float>;
  constexpr std::array kSpecial{
      0.f, -0.f, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), Limits::denorm_min(), -1e-40f, 1e-30f};
  const std::uint32_t kind = random() % 256;
  return kind < kSpecial.size() ? kSpecial[kind] : std::uniform_real_distribution<float>(-2, 2)(random);
}

/// A scene whose robot and ball have wild numbers.
Scene wild_scene(std::mt19937& random) {
  Scene scene(random());
  scene.world.tick = 1000 + static_cast<Tick>(random() % 64);
  for (Body& body : scene.world.bodies) {
    body.position = {wild(random), wild(random)};
    body.heading = wild(random);
    body.facing = direction(body.heading);
    body.head_pitch = 0.3f * wild(random);
    body.look = direction(wild(random));
    body.doing = static_cast<Body::Doing>(random() % 10);
    body.since = scene.world.tick - static_cast<Tick>(random() % 20);
  }
  scene.world.ball.position = {wild(random), wild(random)};
  scene.world.ball.velocity = {wild(random), wild(random)};
  for (Vec2& past : scene.world.ball.past) past = scene.world.ball.position;
  agent::Ball& ball = scene.beliefs.ball;
  ball.position = {wild(random), wild(random)};
  ball.velocity = {wild(random), wild(random)};
  ball.variance = 0.3f * std::fabs(wild(random));
  ball.covariance = 0.1f * wild(random);
  ball.velocity_variance = 0.3f * std::fabs(wild(random));
  ball.seen = random() % 8 == 0 ? kNever : scene.world.tick - static_cast<Tick>(random() % 60);
  ball.visible = random() % 2 == 0;
  scene.beliefs.pose = {
      {{wild(random), wild(random)}, wild(random)}, 0.3f * std::fabs(wild(random)), 0.3f * std::fabs(wild(random))};
  scene.cognition.last = {{wild(random), wild(random)}, wild(random)};
  scene.cognition.odometry_scale = 1 + 0.1f * wild(random);
  scene.cognition.walked = std::fabs(wild(random));
  scene.cognition.turned = static_cast<std::uint16_t>(random());
  scene.cognition.flipped = random() % 4 == 0;
  return scene;
}

void add_number(std::vector<std::uint32_t>& bits, float number) {
  std::uint32_t word = 0;
  std::memcpy(&word, &number, sizeof word);
  bits.push_back(number != number ? 0x7fc00000u : word);  // all NaN are alike
}

/// Returns the bits of all that a look may change.
std::vector<std::uint32_t> bits_of(const Scene& scene) {
  const agent::Ball& ball = scene.beliefs.ball;
  const agent::Pose& pose = scene.beliefs.pose;
  std::vector<std::uint32_t> bits{ball.seen, ball.visible, ball.frames, scene.cognition.turned,
                                  scene.cognition.flipped};
  for (const float number : {ball.position.x, ball.position.y, ball.velocity.x, ball.velocity.y, ball.variance,
                             ball.covariance, ball.velocity_variance, ball.heat, pose.pose.position.x,
                             pose.pose.position.y, pose.pose.heading, pose.deviation, pose.deviation_heading,
                             scene.cognition.last.position.x, scene.cognition.last.heading, scene.cognition.walked})
    add_number(bits, number);
  for (const agent::Opponent& opponent : scene.beliefs.opponents) {
    add_number(bits, opponent.position.x);
    add_number(bits, opponent.position.y);
    bits.push_back(opponent.seen);
  }
  return bits;
}

/// Lets the robots of all scenes look, `together` at once.
void look_together(const Effects& effects, std::vector<Scene>& scenes, const std::vector<Tick>& steps,
                   std::size_t together) {
  std::vector<Look> looks;
  for (std::size_t i = 0; i < scenes.size(); ++i) looks.push_back(scenes[i].look_after(steps[i]));
  Scene shared;
  shared.effects = effects;
  shared.effects.lost_pose = true;
  for (std::size_t i = 0; i < looks.size(); i += together)
    perceive(shared.params(), {&looks[i], std::min(together, looks.size() - i)});
}

TEST(PerceptionLanes, EachLookHasTheBitsOfALookAlone) {
  std::mt19937 random(1);
  for (int round = 0; round < kRounds; ++round) {
    Effects effects = all_effects();
    // each effect is off in some rounds
    if (random() % 8 == 0) effects.ball_noise = false;
    if (random() % 8 == 0) effects.missed_ball = false;
    if (random() % 8 == 0) effects.limited_view = false;
    if (random() % 8 == 0) effects.odometry_drift = false;
    if (random() % 8 == 0) effects.pose_flips = false;
    if (random() % 8 == 0) effects.occlusion = false;
    std::vector<Scene> together;
    std::vector<Tick> steps;
    for (std::size_t i = 0; i < kMostLooks; ++i) {
      together.push_back(wild_scene(random));
      steps.push_back(1 + static_cast<Tick>(random() % 18));
    }
    std::vector<Scene> alone = together, narrow = together;
    look_together(effects, together, steps, kMostLooks);
    look_together(effects, alone, steps, 1);
    only_narrow_lanes = true;
    look_together(effects, narrow, steps, 11);
    only_narrow_lanes = false;
    for (std::size_t i = 0; i < together.size(); ++i) {
      ASSERT_EQ(bits_of(together[i]), bits_of(alone[i])) << "look " << i << " of round " << round;
      ASSERT_EQ(bits_of(narrow[i]), bits_of(alone[i])) << "look " << i << " of round " << round;
    }
  }
}

}  // namespace
}  // namespace sim::perception
