#include "sim/perception/ball_sight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/perception/image.h"
#include "tests/sim/perception/scene.h"

namespace sim::perception {
namespace {

/// Returns a scene whose only effect is the view of the camera.
Scene clear_scene() {
  Scene scene;
  scene.effects = {};
  scene.effects.limited_view = true;
  return scene;
}

/// Returns the percept of the last `steps` images, of a ball that was followed or not.
BallPercept percept_of(Scene& scene, Tick steps, bool followed) {
  scene.beliefs.ball.visible = followed;
  const Look look = scene.look_after(steps);
  BallPercept percept;
  look_for_ball(scene.params(), {&look, 1}, {&percept, 1});
  return percept;
}

BallPercept look(Scene& scene) {
  ++scene.world.tick;
  return percept_of(scene, 1, false);
}

/// Returns the number of images, out of `images`, in which the ball is seen.
int count_seen(Scene& scene, int images) {
  int seen = 0;
  for (int i = 0; i < images; ++i) seen += look(scene).seen ? 1 : 0;
  return seen;
}

TEST(BallSight, FollowsFromTheAnglesOfBodyHeadAndCamera) {
  Scene scene = clear_scene();
  const Camera& camera = scene.model.camera;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> metres(-3, 3), radians(-kPi, kPi), yaws(-2, 2), pitches(-0.7f, 0.5f);
  int seen = 0;
  for (int i = 0; i < 20000; ++i) {
    scene.stand({metres(random), metres(random)}, radians(random));
    scene.look(yaws(random), pitches(random));
    scene.place_ball({metres(random), metres(random)});

    // the same with angles, in double
    const Vec2 to_ball = scene.world.ball.position - scene.body().position;
    const double range = std::hypot(to_ball.x, to_ball.y);
    const double bearing = std::remainder(
        std::atan2(to_ball.y, to_ball.x) - scene.body().heading - scene.body().head_yaw, 2 * std::acos(-1.0));
    const double drop = std::atan2(camera.height - scene.ball.radius, range) - scene.body().head_pitch;
    const double inside = std::min({camera.width / 2 - std::abs(bearing), drop - camera.upper_edge,
                                    camera.lower_edge - drop, scene.model.ball.far_range - range});
    if (std::abs(inside) < 1e-4) continue;  // on the edge
    ASSERT_EQ(look(scene).seen, inside > 0) << "case " << i;
    seen += inside > 0 ? 1 : 0;
  }
  EXPECT_GT(seen, 1000);
}

TEST(BallSight, NoRobotSeesBehindItself) {
  Scene scene = clear_scene();
  scene.model.camera.width = 3.1f;
  std::mt19937 random(2);
  std::uniform_real_distribution<float> behind(-3, -0.01f), beside(-3, 3);
  for (int i = 0; i < 2000; ++i) {
    scene.place_ball({behind(random), beside(random)});
    ASSERT_FALSE(look(scene).seen);
  }
}

TEST(BallSight, ARobotThatIsNotUprightSeesNothing) {
  for (const auto doing : {Body::Doing::fallen, Body::Doing::getting_up, Body::Doing::removed}) {
    Scene scene = clear_scene();
    EXPECT_TRUE(look(scene).seen);
    scene.body().doing = doing;
    EXPECT_FALSE(look(scene).seen);
    scene.effects.limited_view = false;
    EXPECT_FALSE(look(scene).seen);
  }
}

TEST(BallSight, WithoutLimitedViewTheBallIsSeenAnywhere) {
  Scene scene = clear_scene();
  scene.effects.limited_view = false;
  for (const Vec2 place : {Vec2{-3, 1}, Vec2{20, 0}, Vec2{0, 0}}) {
    scene.place_ball(place);
    const BallPercept percept = look(scene);
    ASSERT_TRUE(percept.seen);
    EXPECT_EQ(percept.position, place);
  }
}

TEST(BallSight, ImagesShowTheBallWithTheirLatency) {
  Scene scene = clear_scene();
  for (int i = 0; i < Ball::kPast; ++i) scene.world.ball.past[i] = {0.9f - 0.1f * static_cast<float>(i), 0};
  EXPECT_EQ(look(scene).position, scene.world.ball.position);
  scene.effects.latency = true;
  const struct {
    float latency;
    int past;
  } cases[] = {{0.02f, 0}, {0.033f, 0}, {0.07f, 1}, {0.1f, 2}};
  for (const auto& [latency, past] : cases) {
    scene.model.camera.latency = latency;
    EXPECT_EQ(look(scene).position, scene.world.ball.past[past]) << latency;
  }
  scene.model.camera.latency = 0.01f;
  EXPECT_EQ(look(scene).position, scene.world.ball.position);
}

TEST(BallSight, IsDetectedWithTheProbabilityOfItsDistance) {
  for (const float range : {0.3f, 1.f, 2.f, 3.5f, 4.99f}) {
    Scene scene = clear_scene();
    scene.effects.missed_ball = true;
    scene.place_ball({range, 0});
    const int images = 6000;
    const float expected = probability(scene.model.ball, range);
    EXPECT_NEAR(static_cast<float>(count_seen(scene, images)) / images, expected, 0.02f) << range;
  }
}

TEST(BallSight, ManyImagesAtOnceAreAsInformativeAsSingleOnes) {
  constexpr int kImages = 6, kLooks = 20000;
  Scene scene;
  scene.effects = {};
  scene.effects.missed_ball = scene.effects.ball_noise = true;
  scene.model.ball = {.near = 0.4f, .far = 0.4f, .near_range = 1, .far_range = 5};
  scene.place_ball({1, 0});

  int seen[kImages] = {}, together[kImages] = {};
  double error = 0, velocity_error = 0, information = 0, expected = 0, several = 0;
  for (int i = 0; i < kLooks; ++i) {
    // one by one: the newest percept, and the information of all percepts together
    int last = kImages, count = 0;
    for (int image = 0; image < kImages; ++image) {
      if (!look(scene).seen) continue;
      last = kImages - 1 - image;
      ++count;
    }
    if (last < kImages) ++seen[last];
    information += count;

    const BallPercept percept = percept_of(scene, kImages, true);
    if (!percept.seen) continue;
    ++together[percept.ago];
    const Images& images = percept.images;
    expected += static_cast<double>(images.count);
    // more images reduce the error of the position, a wider spread reduces the error of the velocity
    const auto off = static_cast<double>(percept.position.y - images.middle * percept.velocity.y);
    error += off * off * static_cast<double>(images.count);
    if (images.spread == 0) continue;
    const auto sideward = static_cast<double>(percept.velocity.y);
    velocity_error += sideward * sideward * static_cast<double>(images.spread);
    ++several;
  }
  for (int ago = 0; ago < kImages; ++ago) EXPECT_NEAR(together[ago], seen[ago], 0.02 * kLooks) << ago;
  EXPECT_NEAR(expected / information, 1, 0.02);

  // across the line of sight the error is the bearing's noise
  const double looks = together[0] + together[1] + together[2] + together[3] + together[4] + together[5];
  const double one = static_cast<double>(image_noise(scene.model, true).bearing);
  EXPECT_NEAR(error / looks / one, 1, 0.05);
  EXPECT_NEAR(velocity_error / several / one, 1, 0.05);
}

TEST(BallSight, ForABallThatWasNotFollowedOnlyTheNewestImageCounts) {
  Scene scene = clear_scene();
  scene.effects.missed_ball = scene.effects.ball_noise = true;
  scene.model.ball = {.near = 0.4f, .far = 0.4f, .near_range = 1, .far_range = 5};
  scene.place_ball({1, 0});
  for (int i = 0; i < 1000; ++i) {
    const BallPercept one = look(scene);
    const BallPercept several = percept_of(scene, 6, false);
    EXPECT_EQ(several.seen, one.seen);
    EXPECT_EQ(several.position, one.position);
    EXPECT_EQ(several.images.count, 1);
    EXPECT_EQ(several.images.spread, 0);
    EXPECT_EQ(several.ago, 0u);
  }
}

TEST(BallSight, DetectionFallsFromNearToFarAndEndsThere) {
  const Detection detection{.near = 0.9f, .far = 0.2f, .near_range = 1, .far_range = 5};
  EXPECT_EQ(probability(detection, 0), 0.9f);
  EXPECT_EQ(probability(detection, 1), 0.9f);
  EXPECT_NEAR(probability(detection, 3), 0.55f, 1e-6f);
  EXPECT_EQ(probability(detection, 5), 0.2f);
  EXPECT_EQ(probability(detection, 5.001f), 0);
}

TEST(BallSight, ABodyInBetweenHidesTheBall) {
  Scene scene = clear_scene();
  scene.effects.occlusion = true;
  scene.place_ball({2, 0});
  EXPECT_TRUE(look(scene).seen);
  for (const int other : {Scene::kOpponent, 3}) {
    const float radius = scene.contact.hiding_radius;
    scene.stand({1, 0.9f * radius}, 0, other);
    EXPECT_FALSE(look(scene).seen);
    scene.stand({1, -0.9f * radius}, 0, other);
    EXPECT_FALSE(look(scene).seen);
    scene.stand({1, 1.1f * radius}, 0, other);
    EXPECT_TRUE(look(scene).seen);
    // not hidden: the body is behind the ball, behind the robot, or lies, or occlusion is off
    scene.stand({2.2f, 0}, 0, other);
    EXPECT_TRUE(look(scene).seen);
    scene.stand({-1, 0}, 0, other);
    EXPECT_TRUE(look(scene).seen);
    scene.stand({1, 0}, 0, other);
    scene.body(other).doing = Body::Doing::fallen;
    EXPECT_TRUE(look(scene).seen);
    scene.body(other).doing = Body::Doing::standing;
    scene.effects.occlusion = false;
    EXPECT_TRUE(look(scene).seen);
    scene.effects.occlusion = true;
    scene.stand({100, 100}, 0, other);
  }
}

TEST(BallSight, TheWalkingRefereeHidesTheBall) {
  Scene scene = clear_scene();
  scene.effects.occlusion = true;
  scene.place_ball({2, 0});
  scene.world.official.position = {1, 0.2f};
  EXPECT_TRUE(look(scene).seen);
  scene.effects.official = true;
  EXPECT_FALSE(look(scene).seen);
}

/// The standard deviations of range and bearing, and the mean range.
struct Spread {
  double mean = 0, range = 0, bearing = 0;
};
Spread spread_of(Scene& scene) {
  scene.effects.ball_noise = true;
  const int images = 8000;
  double sum = 0, squares = 0, bearings = 0;
  int seen = 0;
  for (int i = 0; i < images; ++i) {
    const BallPercept percept = look(scene);
    if (!percept.seen) continue;
    const double range = length(percept.position), bearing = std::atan2(percept.position.y, percept.position.x);
    ++seen, sum += range, squares += range * range, bearings += bearing * bearing;
  }
  EXPECT_GT(seen, images * 9 / 10);
  const double mean = sum / seen;
  return {mean, std::sqrt(squares / seen - mean * mean), std::sqrt(bearings / seen)};
}

TEST(BallSight, TheErrorOfTheRangeFollowsFromTheTilt) {
  for (const bool walking : {false, true}) {
    for (const float range : {0.3f, 0.5f, 1.f, 2.f}) {
      Scene scene = clear_scene();
      scene.body().doing = walking ? Body::Doing::walking : Body::Doing::standing;
      scene.place_ball({range, 0});
      const Spread spread = spread_of(scene);
      const float height = scene.model.camera.height - scene.ball.radius;
      const float pixels = scene.model.noise.pixels * scene.model.camera.pixel_angle;
      const float elevation = std::hypot(walking ? scene.model.noise.tilt_walking : scene.model.noise.tilt, pixels);
      const float expected = (range * range + height * height) / height * elevation;
      // the formula is linear in the error, the image is not
      EXPECT_NEAR(spread.range / expected, 1, range < 1.5f ? 0.05 : 0.15) << range;
      EXPECT_NEAR(spread.mean, range, 0.3f * expected) << range;
      EXPECT_NEAR(spread.bearing, std::hypot(scene.model.noise.roll, pixels), 0.001) << range;
    }
  }
}

TEST(BallSight, FalseBallsComeAtTheirRateAndInView) {
  Scene scene = clear_scene();
  scene.effects.false_balls = true;
  scene.model.filter.false_per_second = 1;
  scene.place_ball({-2, 0});
  int seen = 0;
  const int images = 30000;
  for (int i = 0; i < images; ++i) {
    const BallPercept percept = look(scene);
    if (!percept.seen) continue;
    ++seen;
    ASSERT_LE(std::abs(std::atan2(percept.position.y, percept.position.x)), scene.model.camera.width / 2 + 1e-5f);
    ASSERT_LE(length(percept.position), scene.model.ball.far_range);
  }
  // false balls nearer than the lower edge are not in view
  EXPECT_GT(seen, images / 30 * 8 / 10);
  EXPECT_LT(seen, images / 30 * 11 / 10);
  scene.effects.false_balls = false;
  EXPECT_EQ(count_seen(scene, 1000), 0);
}

TEST(BallSight, HeatSaysThatAnOpponentFacesTheBallWithinReach) {
  Scene scene = clear_scene();
  scene.place_ball({1.5f, 0});
  EXPECT_EQ(look(scene).heat, 0);
  const auto heat_at = [&](float distance, float heading, int robot) {
    scene.stand({1.5f, distance}, heading, robot);
    return look(scene).heat;
  };
  const float towards = -kPi / 2;
  EXPECT_NEAR(heat_at(0.2f, towards, Scene::kOpponent), 1, 1e-5f);
  EXPECT_EQ(heat_at(0.2f, -towards, Scene::kOpponent), 0);
  EXPECT_NEAR(heat_at(0.2f, towards + kPi / 3, Scene::kOpponent), 0.5f, 1e-5f);
  float last = 1.001f;
  for (float distance = 0.2f; distance < 0.6f; distance += 0.05f) {
    const float heat = heat_at(distance, towards, Scene::kOpponent);
    EXPECT_LE(heat, last);
    last = heat;
  }
  EXPECT_EQ(last, 0);
  EXPECT_EQ(heat_at(0.2f, towards, 3), 0) << "a teammate is no danger";
}

}  // namespace
}  // namespace sim::perception
