// The intrinsics in PCL's XML files.
#include "robot/truth/sensor/pcl_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot/truth/sensor/depth_files.h"

namespace robot::truth {
namespace {

TEST(PclCamera, ReadsTheDepthCamera) {
  const auto camera = parse_pcl_camera(tests::pcl_xml(525, 320, 241.5));
  ASSERT_TRUE(camera) << camera.error();
  EXPECT_EQ(camera->focal_x, 525);
  EXPECT_EQ(camera->focal_y, 525);
  EXPECT_EQ(camera->centre_x, 320);
  EXPECT_EQ(camera->centre_y, 241.5);
  EXPECT_EQ(camera->unit, 0.002);
}

TEST(PclCamera, AFileWithoutAUnitMeansMillimetres) {
  std::string xml = tests::pcl_xml(525, 320, 240);
  const std::size_t unit = xml.find("\t<z_mult");
  xml.erase(unit, xml.find("</depth>") - unit);
  EXPECT_EQ(parse_pcl_camera(xml)->unit, 0.001);
}

TEST(PclCamera, SaysWhatIsWrong) {
  EXPECT_EQ(parse_pcl_camera("<rgb></rgb>").error(), "expected intrinsics within <depth> and </depth>, got none");
  EXPECT_EQ(parse_pcl_camera("<depth></depth>").error(),
            "<focal_length_x> within <depth> must be a number from 1 to 100000, got \"\"");
  for (const double focal : {0.0, -5.0, std::nan(""), HUGE_VAL})
    EXPECT_FALSE(parse_pcl_camera(tests::pcl_xml(focal, 320, 240))) << focal;
  EXPECT_EQ(parse_pcl_camera(tests::pcl_xml(525, std::nan(""), 240)).error(),
            "<principal_point_x> within <depth> must be a number from -100000 to 100000, got \"nan\"");
}

TEST(PclCamera, SurvivesEveryDamage) {
  std::string xml = tests::pcl_xml(525, 320, 240);
  xml.resize(xml.find("</depth>") + 8);
  tests::expect_no_beginning_is_read(xml, parse_pcl_camera);
  tests::survive_each_flip(xml, parse_pcl_camera);
}

}  // namespace
}  // namespace robot::truth
