#include "robot/body/nao/config.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "robot/core/text.h"
#include "robot/nao/walk/named_parameters.h"

namespace robot::body {
namespace {

std::string why_not(std::string_view text) {
  const auto config = parse_nao_config(text);
  return config ? "read" : config.error();
}

TEST(NaoConfig, HasTheDefaultsOfAV6) {
  const auto config = parse_nao_config("\n# nothing\n");
  ASSERT_TRUE(config);
  EXPECT_EQ(config->top.device, "/dev/video-top");
  EXPECT_TRUE(config->top.turned);
  EXPECT_EQ(config->bottom.device, "/dev/video-bottom");
  EXPECT_FALSE(config->bottom.turned);
  EXPECT_EQ(config->calibration.body_pitch, 0);
}

TEST(NaoConfig, ReadsEverySetting) {
  const auto config = parse_nao_config(
      "body.roll_deg = 1\n  body.pitch_deg=-2  \r\ncamera_top.device = /dev/video0\ncamera_top.turned = no\n"
      "camera_top.tilt_deg = 3\ncamera_top.pan_deg = -0.5\n# a comment\ncamera_top.focal_x = 600.5\n"
      "camera_top.control.gain = 40\ncamera_bottom.roll_deg = 0.25\ncamera_bottom.centre_y = 250\nwalk.period = 0.3");
  ASSERT_TRUE(config) << config.error();
  constexpr double kDegree = std::numbers::pi / 180;
  EXPECT_DOUBLE_EQ(config->calibration.body_roll, kDegree);
  EXPECT_DOUBLE_EQ(config->calibration.body_pitch, -2 * kDegree);
  EXPECT_EQ(config->top.device, "/dev/video0");
  EXPECT_FALSE(config->top.turned);
  EXPECT_DOUBLE_EQ(config->calibration.top.tilt, 3 * kDegree);
  EXPECT_DOUBLE_EQ(config->calibration.top.pan, -0.5 * kDegree);
  EXPECT_EQ(config->top_projection.focal_x, 600.5);
  EXPECT_EQ(config->top.controls.at("gain"), 40);
  EXPECT_EQ(config->top.controls.at("contrast"), 32) << "the others stay";
  EXPECT_DOUBLE_EQ(config->calibration.bottom.roll, 0.25 * kDegree);
  EXPECT_EQ(config->bottom_projection.centre_y, 250);
  EXPECT_EQ(config->walk.period, 0.3);
  EXPECT_EQ(config->walk.lift, nao::walk::Parameters{}.lift) << "the others stay";
}

TEST(NaoConfig, NamesTheWrongLine) {
  EXPECT_EQ(why_not("body.pitch_deg 3"), "nao config: expected NAME = VALUE, got 'body.pitch_deg 3'");
  EXPECT_EQ(why_not("camera.gain = 3"), "nao config: there is no 'camera.gain'");
  EXPECT_EQ(why_not("camera_top = 3"), "nao config: there is no 'camera_top'");
  EXPECT_EQ(why_not("body.yaw_deg = 3"), "nao config: there is no 'body.yaw_deg'");
  EXPECT_EQ(why_not("body.pitch_deg = 30"), "nao config: body.pitch_deg: expected a number -20 .. 20, got '30'");
  EXPECT_EQ(why_not("body.pitch_deg = 3x"), "nao config: body.pitch_deg: expected a number -20 .. 20, got '3x'");
  EXPECT_EQ(why_not("body.pitch_deg = nan"), "nao config: body.pitch_deg: expected a number -20 .. 20, got 'nan'");
  EXPECT_EQ(why_not("camera_top.device ="), "nao config: camera_top.device: expected a path, got ''");
  EXPECT_EQ(why_not("camera_top.turned = 1"), "nao config: camera_top.turned: expected yes or no, got '1'");
  EXPECT_EQ(why_not("camera_top.control.zoom = 1"), "nao config: there is no 'camera_top.control.zoom'");
  EXPECT_EQ(why_not("camera_top.control.gain = 1.5"),
            "nao config: camera_top.control.gain: expected a whole number, got '1.5'");
  EXPECT_EQ(why_not("camera_bottom.focal_x = -1"),
            "nao config: camera_bottom.focal_x: expected a number 0 .. 5000, got '-1'");
}

TEST(NaoConfig, ReadsEveryParameterOfTheWalkWithinItsBounds) {
  for (const nao::walk::NamedParameter& named : nao::walk::kNamedParameters) {
    const std::string name(named.name);
    const double usual = nao::walk::Parameters{}.*named.place;
    const auto line = [&](double value) { return formatted("walk.%s = %.17g", name.c_str(), value); };
    const auto config = parse_nao_config(line(1.5 * usual));
    ASSERT_TRUE(config) << config.error();
    EXPECT_EQ(config->walk.*named.place, 1.5 * usual) << name;
    EXPECT_FALSE(parse_nao_config(line(5 * usual))) << name;
    EXPECT_FALSE(parse_nao_config(line(0))) << name;
  }
  EXPECT_EQ(why_not("walk.speed = 1"), "nao config: there is no 'walk.speed'");
  EXPECT_EQ(why_not("walk = 1"), "nao config: there is no 'walk'");
}

TEST(NaoConfig, SurvivesEveryTruncation) {
  const std::string text = "body.roll_deg = 1\ncamera_top.control.gain = 40\n";
  for (std::size_t n = 0; n < text.size(); ++n) {
    const std::string sentence = why_not(text.substr(0, n));
    EXPECT_TRUE(sentence == "read" || sentence.starts_with("nao config: ")) << n << sentence;
  }
}

}  // namespace
}  // namespace robot::body
