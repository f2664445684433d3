// camera.json: every entry, and every wrong one.
#include "robot/truth/sensor/camera_file.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/sensor/depth_files.h"
#include "tests/support/temporary_folder.h"

namespace robot::truth {
namespace {

TEST(CameraFile, ReadsEveryEntry) {
  const auto camera = parse_camera_file(
      R"({"width": 640, "height": 480, "focal_x": 384.2, "focal_y": 385, "centre_x": 319.5, "centre_y": 236.4,
          "baseline": 0, "unit": 0.0001, "rate": 15, "capture_ns": ["1305031102160407000", "1305031102193740333"]})");
  ASSERT_TRUE(camera) << camera.error();
  EXPECT_EQ(camera->rate, 15);
  EXPECT_EQ(camera->capture_ns, (std::vector<std::uint64_t>{1305031102160407000, 1305031102193740333}));
  DepthFrame frame;
  ASSERT_TRUE(apply(*camera, frame));
  EXPECT_EQ(frame.intrinsics, (Intrinsics{640, 480, 384.2, 385, 319.5, 236.4, 0}));
  EXPECT_EQ(frame.unit, 0.0001);
}

TEST(CameraFile, AnEntryThatIsLeftOutChangesNothing) {
  DepthFrame frame;
  ASSERT_TRUE(apply(*parse_camera_file("{}"), frame));
  EXPECT_EQ(frame.intrinsics, Intrinsics{});
  EXPECT_EQ(frame.unit, 0.001);
}

TEST(CameraFile, RefusesImagesOfAnotherSize) {
  DepthFrame frame;
  EXPECT_EQ(apply(*parse_camera_file(R"({"width": 848})"), frame).error(),
            "expected 848x480 px, for which the camera file is made, got 640x480");
}

TEST(CameraFile, SaysWhatIsWrong) {
  const auto error_of = [](const char* text) { return parse_camera_file(text).error(); };
  EXPECT_EQ(error_of(R"({"focal_x": NaN})"), "expected JSON, got something else");
  EXPECT_EQ(error_of(R"({"focal_x": 1e999})"), "expected JSON, got something else");
  EXPECT_EQ(error_of("[]"), "expected a JSON object, got something else");
  EXPECT_EQ(error_of(R"({"focal_x": 0})"), "\"focal_x\" must be a number from 1 to 100000, got 0");
  EXPECT_EQ(error_of(R"({"unit": "1 mm"})"), "\"unit\" must be a number from 1e-06 to 1, got \"1 mm\"");
  EXPECT_EQ(error_of(R"({"fx": 5})"), "\"fx\" is no entry of a camera file");
  for (const char* times : {R"({"capture_ns": 5})", R"({"capture_ns": [5]})", R"({"capture_ns": ["5 "]})",
                            R"({"capture_ns": ["-5"]})", R"({"capture_ns": ["99999999999999999999"]})"})
    EXPECT_EQ(error_of(times), "\"capture_ns\" must be a list of decimal texts of nanoseconds since the epoch");
}

TEST(CameraFile, NamesItsFile) {
  const tests::TemporaryFolder folder;
  tests::write_file(folder / "camera.json", "{");
  EXPECT_EQ(read_camera_file(folder / "camera.json").error(),
            (folder / "camera.json").string() + ": expected JSON, got something else");
  EXPECT_FALSE(read_camera_file(folder / "none.json"));
}

TEST(CameraFile, SurvivesEveryDamage) {
  const std::string text = R"({"width": 640, "unit": 0.001, "capture_ns": ["5"]})";
  tests::expect_no_beginning_is_read(text, parse_camera_file);
  tests::survive_each_flip(text, parse_camera_file);
}

}  // namespace
}  // namespace robot::truth
