#include "sim/perception/localisation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/perception/image.h"
#include "tests/sim/perception/scene.h"

namespace sim::perception {
namespace {

Scene walking_scene(std::uint64_t seed) {
  Scene scene(seed);
  scene.effects = {};
  scene.effects.limited_view = scene.effects.odometry_drift = true;
  scene.place_ball({50, 50});
  return scene;
}

/// Returns belief minus truth, in team_field.
Pose2 error_of(const Scene& scene) {
  const Pose2 truth = true_pose(scene.world, Scene::kRobot);
  const Pose2& belief = scene.beliefs.pose.pose;
  return {belief.position - truth.position, normalized(belief.heading - truth.heading)};
}

TEST(Localisation, AWindowAgreesWithInView) {
  Scene scene;
  const Camera& camera = scene.model.camera;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> metres(-3, 3), yaws(-2, 2), pitches(-1.5f, 1);
  int seen = 0;
  for (int i = 0; i < 20000; ++i) {
    scene.stand({metres(random), metres(random)}, metres(random));
    scene.look(yaws(random), pitches(random));
    const Sighting mark = sighting_of(Vec2{metres(random), metres(random)} - scene.body().position, camera.height);
    const bool shown =
        in_view(window_of(camera, look_of(scene.body()), scene.body().head_pitch, 2.5f), mark.to_it, mark.square);
    ASSERT_EQ(shown, in_view(camera, scene.body().head_pitch, look_of(scene.body()), 2.5f, mark)) << "case " << i;
    seen += shown ? 1 : 0;
  }
  EXPECT_GT(seen, 500);
}

/// Walks about on the field and looks around.
void wander(Scene& scene, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    const Vec2 home = turned_back(-scene.body().position, scene.body().facing);
    const bool far = squared_length(home) > 2;
    const float turn = far ? (home.y > 0 ? 0.8f : -0.8f) : (scene.world.tick / 90 % 2 == 0 ? 0.3f : -0.4f);
    scene.look(scene.world.tick / 30 % 2 == 0 ? 0.5f : -0.5f, 0);
    scene.walk({0.2f, 0}, turn);
    scene.perceive();
  }
}

TEST(Localisation, DeviationsAreConsistentOverLongWalks) {
  double position = 0, heading = 0;
  int samples = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Scene scene = walking_scene(seed);
    scene.enter();
    for (int i = 0; i < 40; ++i) {
      wander(scene, 45);
      const Pose2 error = error_of(scene);
      const agent::Pose& pose = scene.beliefs.pose;
      position += squared_length(error.position) / (2 * pose.deviation * pose.deviation);
      heading += error.heading * error.heading / (pose.deviation_heading * pose.deviation_heading);
      ++samples;
    }
  }
  EXPECT_GT(position / samples, 0.7);
  EXPECT_LT(position / samples, 1.5);
  EXPECT_GT(heading / samples, 0.7);
  EXPECT_LT(heading / samples, 1.5);
}

TEST(Localisation, EntersWithTheErrorThatItBelieves) {
  double position = 0, heading = 0;
  const int games = 2000;
  for (std::uint64_t seed = 0; seed < games; ++seed) {
    Scene scene = walking_scene(seed);
    scene.enter();
    const Pose2 error = error_of(scene);
    position += squared_length(error.position) / 2;
    heading += error.heading * error.heading;
  }
  const Localisation& model = Scene().model.localisation;
  EXPECT_NEAR(std::sqrt(position / games), model.start_deviation, 0.02f);
  EXPECT_NEAR(std::sqrt(heading / games), model.start_deviation_heading, 0.01f);
}

/// A scene without marks that starts from a known pose.
Scene blind_scene(std::uint64_t seed) {
  Scene scene = walking_scene(seed);
  scene.marks.count = 0;
  scene.model.localisation.start_deviation = scene.model.localisation.start_deviation_heading = 0;
  return scene;
}

TEST(Localisation, OdometryDriftsByItsNoiseAndScale) {
  double forward = 0, sideward = 0, heading = 0;
  const int games = 600;
  const float walked = 2;
  for (std::uint64_t seed = 0; seed < games; ++seed) {
    Scene scene = blind_scene(seed);
    scene.model.localisation.rotation_per_metre = 0;
    scene.enter();
    for (int i = 0; i < 300; ++i) {
      scene.walk({walked / 10, 0}, 0);
      scene.perceive();
    }
    const Pose2 error = error_of(scene);
    forward += error.position.x * error.position.x;
    sideward += error.position.y * error.position.y;
    heading += std::abs(error.heading);
  }
  const Localisation& model = Scene().model.localisation;
  const float noise = model.translation_noise * std::sqrt(walked);
  EXPECT_NEAR(std::sqrt(forward / games), std::hypot(noise, model.bias * walked), 0.015);
  EXPECT_NEAR(std::sqrt(sideward / games), noise, 0.012);
  EXPECT_EQ(heading, 0);
}

TEST(Localisation, HeadingDriftsByTurningAndWalking) {
  double turning = 0, walking = 0;
  const int games = 600;
  const float turned = 6, walked = 2;
  for (std::uint64_t seed = 0; seed < games; ++seed) {
    Scene turner = blind_scene(seed), walker = blind_scene(seed);
    turner.enter();
    walker.enter();
    for (int i = 0; i < 300; ++i) {
      turner.walk({}, turned / 10);
      turner.perceive();
      walker.walk({walked / 10, 0}, 0);
      walker.perceive();
    }
    turning += std::pow(error_of(turner).heading, 2);
    walking += std::pow(error_of(walker).heading, 2);
  }
  const Localisation& model = Scene().model.localisation;
  const float noise = model.rotation_noise * std::sqrt(turned);
  EXPECT_NEAR(std::sqrt(turning / games), std::hypot(noise, model.bias * turned), 0.04);
  EXPECT_NEAR(std::sqrt(walking / games), model.rotation_per_metre * std::sqrt(walked), 0.008);
}

TEST(Localisation, MarksPullTheBeliefBack) {
  Scene lost = walking_scene(3);
  lost.enter();
  lost.beliefs.pose.pose.position += {1, -0.8f};
  lost.beliefs.pose.deviation = 1;
  Scene blind = lost;
  blind.marks.count = 0;
  for (int i = 0; i < 300; ++i) lost.perceive(), blind.perceive();
  EXPECT_LT(length(error_of(lost).position), 0.3f);
  EXPECT_LT(lost.beliefs.pose.deviation, 0.2f);
  EXPECT_GT(length(error_of(blind).position), 1);
  EXPECT_EQ(blind.beliefs.pose.deviation, 1);
}

TEST(Localisation, IsTheTruthWithoutDrift) {
  for (const float attacks : {1.f, -1.f}) {
    Scene scene = walking_scene(4);
    scene.effects.odometry_drift = false;
    scene.world.home_attacks = attacks;
    scene.enter();
    wander(scene, 300);
    EXPECT_EQ(scene.beliefs.pose.pose, true_pose(scene.world, Scene::kRobot));
    EXPECT_EQ(scene.beliefs.pose.pose.position, attacks * scene.body().position);
    EXPECT_NEAR(std::cos(scene.beliefs.pose.pose.heading), attacks * std::cos(scene.body().heading), 1e-6);
    EXPECT_EQ(scene.beliefs.pose.deviation, 0);
  }
}

TEST(Localisation, TheScaleOfOdometryIsConstantInAGame) {
  Scene scene = walking_scene(5);
  scene.enter();
  const float scale = scene.cognition.odometry_scale, turn = scene.cognition.turn_scale;
  EXPECT_NE(scale, 1);
  wander(scene, 100);
  scene.enter();
  EXPECT_EQ(scene.cognition.odometry_scale, scale);
  EXPECT_EQ(scene.cognition.turn_scale, turn);
  Scene next = walking_scene(6);
  next.enter();
  EXPECT_NE(next.cognition.odometry_scale, scale);
}

TEST(Localisation, FlipsHappenAtTheirRateWhileUnsureAndEnd) {
  int flips = 0, flipped = 0, straight = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Scene scene = blind_scene(seed);
    scene.effects.pose_flips = true;
    scene.model.localisation.flips_per_minute = 2;
    scene.enter();
    scene.beliefs.pose.deviation = 1;
    for (int i = 0; i < 3600; ++i) {
      const bool before = scene.cognition.flipped;
      scene.perceive();
      const bool now = scene.cognition.flipped;
      flips += now && !before ? 1 : 0;
      (now ? flipped : straight)++;
      ASSERT_EQ(std::abs(error_of(scene).heading) > 1, now);
    }
  }
  const float duration = Scene().model.localisation.flip_duration;
  EXPECT_NEAR(static_cast<float>(flips) / (static_cast<float>(straight) / 1800), 2, 0.4f) << "a minute";
  EXPECT_NEAR(static_cast<float>(flipped) / 30 / static_cast<float>(flips), duration, 0.25f * duration);
}

TEST(Localisation, MarksConfirmAFlippedPose) {
  Scene scene = walking_scene(8);
  scene.effects.pose_flips = true;
  scene.model.localisation.flip_duration = 1e6f;
  scene.stand({1, 0.5f}, 0.3f);
  scene.enter();
  scene.cognition.flipped = true;
  scene.beliefs.pose.pose = {{-1, -0.5f}, 0.3f - kPi};
  for (int i = 0; i < 300; ++i) scene.perceive();
  EXPECT_LT(distance(scene.beliefs.pose.pose.position, {-1, -0.5f}), 0.3f);
  EXPECT_LT(std::abs(normalized(scene.beliefs.pose.pose.heading - 0.3f + kPi)), 0.2f);
}

TEST(Localisation, ASurePoseNeverFlips) {
  Scene scene = blind_scene(9);
  scene.effects.pose_flips = true;
  scene.model.localisation.flips_per_minute = 1000;
  scene.enter();
  for (int i = 0; i < 1000; ++i) {
    scene.perceive();
    ASSERT_FALSE(scene.cognition.flipped);
  }
}

TEST(Localisation, AFallLosesThePoseOnceAndMarksBringItBack) {
  double place = 0, heading = 0, later = 0;
  const int games = 600;
  for (std::uint64_t seed = 0; seed < games; ++seed) {
    Scene scene = walking_scene(seed);
    scene.model.localisation.start_deviation = scene.model.localisation.start_deviation_heading = 0;
    scene.model.localisation.fall_deviation = 0.3f;
    scene.model.localisation.fall_deviation_heading = 0.5f;
    scene.enter();
    scene.body().doing = Body::Doing::fallen;
    scene.body().since = scene.world.tick;
    Scene without = scene;
    scene.effects.lost_pose = true;
    for (int i = 0; i < 30; ++i) scene.perceive(), without.perceive();
    ASSERT_EQ(without.beliefs.pose.pose, true_pose(without.world, Scene::kRobot));
    const Pose2 error = error_of(scene);
    place += squared_length(error.position) / 2;
    heading += error.heading * error.heading;
    scene.body().doing = Body::Doing::standing;
    for (int i = 0; i < 300; ++i) scene.perceive();
    later += squared_length(error_of(scene).position) / 2;
  }
  EXPECT_NEAR(std::sqrt(place / games), 0.3, 0.03);
  EXPECT_NEAR(std::sqrt(heading / games), 0.5, 0.05);
  EXPECT_LT(std::sqrt(later / games), 0.15);
}

}  // namespace
}  // namespace sim::perception
