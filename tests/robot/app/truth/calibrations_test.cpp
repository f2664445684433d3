#include "robot/app/truth/calibrations.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

truth::Calibration good() {
  truth::Calibration calibration;
  calibration.pose.field_from_sensor.translation() = Eigen::Vector3d(1, -3, 2);
  calibration.robots.mean = 0.01;
  calibration.robots.p95 = 0.02;
  return calibration;
}

TEST(Calibrations, ASavedOneIsFoundAgainAlsoByANewProcess) {
  const tests::TemporaryFolder folder;
  auto calibrations = Calibrations::open(folder.path() / "lab.json", "spl2012");
  ASSERT_TRUE(calibrations) << calibrations.error();
  const auto none = calibrations->find("freenect:0", {});
  ASSERT_TRUE(none);
  EXPECT_FALSE(*none);
  const auto saved = calibrations->save("freenect:0", {}, good());
  ASSERT_TRUE(saved) << saved.error();
  const auto again = Calibrations::open(folder.path() / "lab.json", "spl2012");
  ASSERT_TRUE(again) << again.error();
  for (const Calibrations* one : {&std::as_const(*calibrations), &*again}) {
    const auto found = one->find("freenect:0", {});
    ASSERT_TRUE(found && *found);
    EXPECT_NEAR((*found)->pose.field_from_sensor.translation().y(), -3, 1e-9);
    EXPECT_NEAR((*found)->error_p95, 0.02, 1e-9);
  }
}

TEST(Calibrations, ThatOfAnotherSensorOrFieldIsRefused) {
  const tests::TemporaryFolder folder;
  auto calibrations = Calibrations::open(folder.path() / "lab.json", "spl2012");
  ASSERT_TRUE(calibrations);
  ASSERT_TRUE(calibrations->save("freenect:0", {}, good()));
  EXPECT_FALSE(calibrations->find("freenect:0", {.width = 320, .height = 240}));
  const auto other = Calibrations::open(folder.path() / "lab.json", "spl2025");
  ASSERT_TRUE(other);
  const auto found = other->find("freenect:0", {});
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().find("spl2012"), std::string::npos);
}

TEST(Calibrations, WithoutAFileNothingIsSaved) {
  auto calibrations = Calibrations::open({}, "spl2012");
  ASSERT_TRUE(calibrations);
  const auto saved = calibrations->save("freenect:0", {}, good());
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().find("--calibration"), std::string::npos);
}

TEST(Calibrations, ARefusedOneIsNotSaved) {
  const tests::TemporaryFolder folder;
  auto calibrations = Calibrations::open(folder.path() / "lab.json", "spl2012");
  ASSERT_TRUE(calibrations);
  truth::Calibration poor = good();
  poor.refused = "too few landmarks";
  EXPECT_FALSE(calibrations->save("freenect:0", {}, poor));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "lab.json"));
}

}  // namespace
}  // namespace robot::app
