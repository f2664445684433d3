#include "robot/truth/calibration/calibration_file.h"

#include <gtest/gtest.h>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "tests/support/ground_picture.h"
#include "tests/support/temporary_folder.h"

namespace robot::truth {
namespace {

Calibration good_calibration() {
  Calibration calibration;
  calibration.pose.field_from_sensor = tests::mast_scene().field_from_sensor;
  calibration.pose.intrinsics.focal_x = 576.125;
  calibration.pose.depth_scale = 1 / 1.01;
  calibration.pose.covariance.diagonal().setConstant(1e-6 / 3);
  calibration.pose.covariance(0, 4) = calibration.pose.covariance(4, 0) = 1e-7;
  calibration.lens = {.k1 = -0.1, .p2 = 0.001};
  calibration.residuals = {{{"centre mark", 320.5, 240.25}, 0.75, false}, {{"corner +x +y", 10, 20}, 30, true}};
  calibration.robots = {.mean = 0.006, .p95 = 0.012};
  return calibration;
}

CalibrationFile file_of(std::initializer_list<const char*> addresses) {
  CalibrationFile file;
  for (const char* address : addresses)
    put_calibration(file, address, "spl2012", {}, good_calibration()).operator bool();
  return file;
}

TEST(CalibrationFile, ReadsWhatItWroteWithoutLoss) {
  const tests::TemporaryFolder folder;
  const CalibrationFile file = file_of({"freenect:0", "fakenect:logs/\xff"});
  ASSERT_TRUE(write_calibrations(folder / "lab.json", file));
  const auto again = read_calibrations(folder / "lab.json");
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(print_calibrations(*again), print_calibrations(file));
  ASSERT_EQ(again->sensors.size(), 2u);
  const SensorCalibration &a = again->sensors[0], &b = file.sensors[0];
  EXPECT_EQ(a.address, "freenect:0");
  EXPECT_EQ(a.field, "spl2012");
  EXPECT_EQ(a.intrinsics, b.intrinsics);
  EXPECT_EQ(a.pose.intrinsics, b.pose.intrinsics);
  EXPECT_EQ(a.pose.field_from_sensor.matrix(), b.pose.field_from_sensor.matrix());
  EXPECT_EQ(a.pose.depth_scale, b.pose.depth_scale);
  EXPECT_EQ(a.pose.covariance, b.pose.covariance);
  EXPECT_EQ(a.lens, b.lens);
  EXPECT_EQ(a.clicks[1].pixels, 30);
  EXPECT_TRUE(a.clicks[1].outlier);
  EXPECT_EQ(a.error_mean, 0.006);
  EXPECT_EQ(a.error_p95, 0.012);
}

TEST(CalibrationFile, ReplacesTheCalibrationOfTheSameSensor) {
  CalibrationFile file = file_of({"a", "b"});
  Calibration newer = good_calibration();
  newer.pose.depth_scale = 1.005;
  ASSERT_TRUE(put_calibration(file, "a", "spl2012", {}, newer));
  ASSERT_EQ(file.sensors.size(), 2u);
  EXPECT_EQ(pose_for(file, "a", {})->depth_scale, 1.005);
}

TEST(CalibrationFile, TakesNoRefusedCalibration) {
  CalibrationFile file;
  Calibration refused = good_calibration();
  refused.refused = "the field is mirrored";
  EXPECT_EQ(put_calibration(file, "a", "spl2012", {}, refused).error(),
            "calibration of 'a': refused, since the field is mirrored");
  EXPECT_TRUE(file.sensors.empty());
}

TEST(CalibrationFile, HasThePoseOfASensorOfTheSameAddressAndIntrinsics) {
  const CalibrationFile file = file_of({"freenect:0", "openni:0"});
  ASSERT_TRUE(pose_for(file, "openni:0", {}));
  EXPECT_EQ(pose_for(file, "openni:1", {}).error(),
            "calibration: expected one of 'openni:1', got 'freenect:0', 'openni:0'");
  EXPECT_EQ(pose_for({}, "openni:1", {}).error(), "calibration: expected one of 'openni:1', got no sensor");
  EXPECT_EQ(pose_for(file, "openni:0", {.width = 320, .height = 240}).error(),
            "calibration of 'openni:0': expected that of a sensor of 320 x 240 px with focal length 575.80, 575.80 and "
            "centre 320.00, 240.00 px, got one of 640 x 480 px with focal length 575.80, 575.80 and centre 320.00, "
            "240.00 px");
}

/// Returns the sentence about a file whose entry is changed.
template <class Change>
std::string after(Change change) {
  auto json = nlohmann::json::parse(print_calibrations(file_of({"a"})));
  change(json["sensors"][0]);
  const auto file = parse_calibrations(json.dump());
  return file ? "" : file.error();
}

TEST(CalibrationFile, SaysWhatIsWrong) {
  using Json = nlohmann::json;
  EXPECT_EQ(parse_calibrations("x").error(), "calibrations: expected JSON, got something else");
  EXPECT_EQ(parse_calibrations("{}").error(), "calibrations: 'sensors' is missing");
  EXPECT_EQ(parse_calibrations(R"({"sensors": [1]})").error(), "calibrations: 'error' is missing");
  EXPECT_EQ(after([](Json& it) { it["address"] = 7; }),
            "calibrations: 'address' must be a text of at most 200 bytes, got 7");
  EXPECT_EQ(after([](Json& it) { it["intrinsics"] = 7; }), "calibrations: 'intrinsics' must be an object, got 7");
  EXPECT_EQ(after([](Json& it) { it["intrinsics"]["width"] = 0; }),
            "calibrations: 'width' must be a whole number 1 .. 16384, got 0");
  EXPECT_EQ(after([](Json& it) { it["intrinsics"]["focal_x"] = -1; }),
            "calibrations: 'focal_x' must be a number 1 .. 100000, got -1");
  EXPECT_EQ(after([](Json& it) { it["lens"].erase("k2"); }), "calibrations: 'k2' is missing");
  EXPECT_EQ(after([](Json& it) { it["place"]["rotation"][0] = 0.5; }),
            "calibrations: 'rotation' must be a rotation matrix row by row");
  EXPECT_EQ(after([](Json& it) {
              for (auto& number : it["place"]["rotation"]) number = -number.get<double>();
            }),
            "calibrations: 'rotation' must be a rotation matrix row by row");
  EXPECT_EQ(after([](Json& it) {
              it["place"]["rotation"] = Json::array({1, 2});
            }),
            "calibrations: 'rotation' must be a list of 9 numbers -1 .. 1, got [1,2]");
  EXPECT_EQ(after([](Json& it) { it["depth_scale"] = 0; }),
            "calibrations: 'depth_scale' must be a number 0.5 .. 2, got 0");
  EXPECT_EQ(after([](Json& it) { it["covariance"][0] = -1; }),
            "calibrations: 'covariance' must be a symmetric matrix without negative eigenvalues");
  EXPECT_EQ(after([](Json& it) { it["covariance"][1] = 1; }),
            "calibrations: 'covariance' must be a symmetric matrix without negative eigenvalues");
  EXPECT_EQ(after([](Json& it) { it["clicks"][0]["outlier"] = 1; }),
            "calibrations: 'outlier' must be true or false, got 1");
  EXPECT_EQ(after([](Json& it) { it["error"]["p95"] = -1; }), "calibrations: 'p95' must be a number 0 .. 1000, got -1");
}

TEST(CalibrationFile, RefusesAnAddressThatAppearsTwice) {
  auto json = nlohmann::json::parse(print_calibrations(file_of({"a", "b"})));
  json["sensors"][1]["address"] = "a";
  EXPECT_EQ(parse_calibrations(json.dump()).error(), "calibrations: the address 'a' appears twice");
}

TEST(CalibrationFile, SurvivesEveryTruncationAndFlippedByte) {
  const std::string text = nlohmann::json::parse(print_calibrations(file_of({"a"}))).dump();
  for (std::size_t n = 0; n < text.size(); ++n) {
    EXPECT_FALSE(parse_calibrations(text.substr(0, n)));
    std::string flipped = text;
    flipped[n] = static_cast<char>(flipped[n] ^ (1 << n % 8));
    const auto file = parse_calibrations(flipped);
    EXPECT_TRUE(file || file.error().starts_with("calibrations: ")) << flipped;
  }
}

TEST(CalibrationFile, NamesTheFileInAnError) {
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(replace_file(folder / "lab.json", "{}"));
  EXPECT_EQ(read_calibrations(folder / "lab.json").error(),
            (folder / "lab.json").string() + ": calibrations: 'sensors' is missing");
  EXPECT_EQ(read_clicks(folder / "lab.json").error(), (folder / "lab.json").string() + ": clicks: 'clicks' is missing");
  EXPECT_FALSE(read_calibrations(folder / "none.json"));
  EXPECT_FALSE(read_clicks(folder / "none.json"));
  EXPECT_FALSE(write_calibrations(folder / "none" / "lab.json", {}));
}

TEST(CalibrationFile, OfClicksIsReadAsWritten) {
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(write_clicks(folder / "clicks.json", {{"centre mark", 1.5, 2}}));
  const auto clicks = read_clicks(folder / "clicks.json");
  ASSERT_TRUE(clicks) << clicks.error();
  ASSERT_EQ(clicks->size(), 1u);
  EXPECT_EQ((*clicks)[0].landmark, "centre mark");
  EXPECT_EQ((*clicks)[0].x, 1.5);
}

}  // namespace
}  // namespace robot::truth
