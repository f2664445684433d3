#include "robot/truth/calibration/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robot/truth/synthetic/sensor_poses.h"
#include "tests/support/ground_picture.h"

namespace robot::truth {
namespace {

using Clicks = std::vector<Click>;

struct RefusalLab {
  tests::GroundScene scene = tests::mast_scene();
  std::vector<Landmark> landmarks = landmarks_of(scene.field);
  Projection camera{scene.intrinsics, {}};
  DepthFrame image = scene.depth_image(nullptr);
  Ground ground = *find_ground(image, {}, {});

  Clicks clicks(double deviation = 0) const {
    std::mt19937 random(1);
    return scene.clicks(random, deviation);
  }
  Clicks clicks_of(std::initializer_list<const char*> names) const {
    Clicks chosen;
    for (const Click& click : clicks())
      if (std::find(names.begin(), names.end(), click.landmark) != names.end()) chosen.push_back(click);
    return chosen;
  }
  Result<Calibration> calibrated(const Clicks& clicks, const CalibrationOptions& options = {}) const {
    return calibrate(landmarks, clicks, camera, ground, options);
  }
  /// Returns the Error or the reason of the refusal.
  std::string sentence(const Clicks& clicks, const CalibrationOptions& options = {}) const {
    const auto calibration = calibrated(clicks, options);
    return calibration ? calibration->refused : calibration.error();
  }
};

const RefusalLab& refusal_lab() {
  static const RefusalLab lab;
  return lab;
}

TEST(Refusal, OfTooFewLandmarksSaysWhereToClick) {
  EXPECT_EQ(refusal_lab().sentence({}),
            "expected clicks of at least 4 landmarks, got 0: click a landmark in the left half of the picture");
  EXPECT_EQ(refusal_lab().sentence(refusal_lab().clicks_of({"penalty mark -x", "goal area -x +y", "corner -x +y"})),
            "expected clicks of at least 4 landmarks, got 3: click a landmark in the right half of the picture");
}

TEST(Refusal, OfLandmarksOnALineSaysSo) {
  const Clicks clicks = refusal_lab().clicks_of({"centre mark", "centre circle, halfway line +y",
                                                 "centre circle, halfway line -y", "halfway line, touch line +y"});
  ASSERT_EQ(clicks.size(), 4u);
  EXPECT_EQ(refusal_lab().sentence(clicks),
            "all clicked landmarks are within 0.00 m of one line: click a landmark away from this line");
}

TEST(Refusal, OfClicksThatCannotBe) {
  Clicks clicks = refusal_lab().clicks();
  clicks[1].landmark = "penalty spot\n";
  EXPECT_EQ(refusal_lab().sentence(clicks), "clicks: the field has no landmark 'penalty spot?'");
  clicks = refusal_lab().clicks();
  clicks[1] = clicks[0];
  EXPECT_EQ(refusal_lab().sentence(clicks), "clicks: 'corner +x +y' is clicked twice");
  clicks = refusal_lab().clicks();
  clicks[0].x = 641;
  clicks[0].y = 3.5;
  EXPECT_EQ(refusal_lab().sentence(clicks),
            "clicks: 'corner +x +y' must be in the picture of 640 x 480 px, got (641, 3.5)");
  clicks[0].x = std::nan("");
  EXPECT_NE(refusal_lab().sentence(clicks), "");
  const Projection bent{refusal_lab().scene.intrinsics, {.k1 = -1.5}};
  EXPECT_EQ(calibrate(refusal_lab().landmarks, {{"centre mark", 1, 2}}, bent, std::nullopt).error(),
            "clicks: 'centre mark' is at (1, 2), where the lens shows nothing");
  EXPECT_EQ(refusal_lab().sentence(refusal_lab().clicks(), {.click_deviation = 0}),
            "calibration: the deviations of clicks and of the depth scale must be positive");
}

TEST(Refusal, OfAMirroredFieldSaysWhatToExchange) {
  Clicks clicks = refusal_lab().clicks(0.5);
  for (Click& click : clicks)
    for (std::size_t i = 1; i < click.landmark.size(); ++i)
      if (click.landmark[i] == 'x') click.landmark[i - 1] = click.landmark[i - 1] == '+' ? '-' : '+';
  EXPECT_EQ(refusal_lab().sentence(clicks),
            "the clicks fit a mirrored field: exchange the landmarks of left and right");
}

TEST(Refusal, OfAWrongLandmarkNamesTheRightOne) {
  Clicks clicks = refusal_lab().clicks(0.5);
  const auto named = [&](const char* name) {
    return std::find_if(clicks.begin(), clicks.end(), [&](const Click& click) { return click.landmark == name; });
  };
  std::swap(named("penalty mark -x")->landmark, named("penalty mark +x")->landmark);
  EXPECT_EQ(refusal_lab().sentence(clicks), "the click of 'penalty mark -x' shows 'penalty mark +x': click it again");
}

TEST(Refusal, OfTooManyOutliersNamesTheWorst) {
  Clicks clicks = refusal_lab().clicks();
  for (std::size_t i = 0; i < clicks.size(); i += 2) clicks[i].y += 20. + 7. * static_cast<double>(i);
  const std::string sentence = refusal_lab().sentence(clicks);
  EXPECT_NE(sentence.find("clicks do not fit the others, and the worst is '"), std::string::npos) << sentence;
}

TEST(Refusal, OfResidualsBeyondChanceNamesTheWorst) {
  Clicks clicks = refusal_lab().clicks();
  for (std::size_t i = 0; i < clicks.size(); ++i) clicks[i].x += i % 2 == 0 ? 2.4 : -2.4;
  const std::string sentence = refusal_lab().sentence(clicks);
  EXPECT_TRUE(sentence.starts_with("the clicks miss by ")) << sentence;
  EXPECT_EQ(refusal_lab().sentence(clicks, {.click_deviation = 3}), "") << "such clicks were expected";
}

TEST(Refusal, OfADepthScaleBeyondItsPriorSaysWhatToCheck) {
  Ground ground = refusal_lab().ground;
  ground.roots.col(3) /= 1.06;  // all depths 6 % too far
  ground.height *= 1.06;
  const auto calibration = calibrate(refusal_lab().landmarks, refusal_lab().clicks(), refusal_lab().camera, ground);
  ASSERT_TRUE(calibration) << calibration.error();
  EXPECT_TRUE(calibration->refused.starts_with("the depth scale is 0.94")) << calibration->refused;
  EXPECT_NE(calibration->refused.find("expected 1 ± 0.030: check the sizes of the field"), std::string::npos);
}

TEST(Refusal, OfASensorFarFromTheFieldSaysWhereToTurnIt) {
  tests::GroundScene scene = refusal_lab().scene;
  scene.field_from_sensor = robot::truth::looking({0, -7.5, 2.1}, {0, 0, 0}).field_from_sensor;
  const Ground ground{.normal = scene.field_from_sensor.linear().row(2).transpose(),
                      .height = 2.1,
                      .roots = Eigen::Matrix4d::Zero(),
                      .pixels = 0};
  std::mt19937 random(1);
  const auto calibration = calibrate(refusal_lab().landmarks, scene.clicks(random, 0), refusal_lab().camera, ground);
  ASSERT_TRUE(calibration) << calibration.error();
  EXPECT_EQ(calibration->refused, "the sensor sees no part of the field within 5 m: turn it towards the field");
}

TEST(Refusal, OfAnUncertainCalibrationNamesAClickThatHelps) {
  Clicks clicks = refusal_lab().clicks_of(
      {"halfway line, touch line +y", "centre circle, halfway line +y", "penalty mark +x", "centre mark"});
  const CalibrationOptions options{.click_deviation = 4};
  const auto before = refusal_lab().calibrated(clicks, options);
  ASSERT_TRUE(before) << before.error();
  EXPECT_TRUE(before->refused.starts_with("the expected error is ")) << before->refused;
  EXPECT_NE(before->refused.find(" cm (p95), at most 5 cm are useful: click '"), std::string::npos);

  // the advice is followed
  const std::string after = before->refused.substr(before->refused.find("click '") + 7);
  const std::string name = after.substr(0, after.find('\''));
  for (const Click& click : refusal_lab().clicks())
    if (click.landmark == name) clicks.push_back(click);
  ASSERT_EQ(clicks.size(), 5u) << name;
  const auto better = refusal_lab().calibrated(clicks, options);
  ASSERT_TRUE(better) << better.error();
  EXPECT_LT(better->robots.p95, 0.8 * before->robots.p95);
}

TEST(Refusal, OfImagesThatShowNoField) {
  for (const std::uint16_t depth : {std::uint16_t{0}, std::uint16_t{2047}, std::uint16_t{65535}}) {
    DepthFrame frame = refusal_lab().image;
    std::fill(frame.depth.begin(), frame.depth.end(), depth);
    const auto calibration = calibrate(refusal_lab().landmarks, refusal_lab().clicks(), frame);
    EXPECT_TRUE(!calibration || !calibration->refused.empty()) << depth;
  }
}

}  // namespace
}  // namespace robot::truth
