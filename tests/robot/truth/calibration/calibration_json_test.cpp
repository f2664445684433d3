#include "robot/truth/calibration/calibration_json.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"

namespace robot::truth {
namespace {

TEST(CalibrationJson, ReadsClicksThatItWrote) {
  const std::vector<Click> clicks{{"corner +x +y", 12.25, 33}, {"centre mark", 0.1, 1e-9}};
  const auto again = parse_clicks(to_json(clicks).dump());
  ASSERT_TRUE(again) << again.error();
  ASSERT_EQ(again->size(), 2u);
  EXPECT_EQ((*again)[0].landmark, "corner +x +y");
  EXPECT_EQ((*again)[0].x, 12.25);
  EXPECT_EQ((*again)[1].x, 0.1);
  EXPECT_EQ((*again)[1].y, 1e-9);
  EXPECT_TRUE(parse_clicks(R"({"sensor": "freenect:0", "clicks": []})")) << "other members are left alone";
}

TEST(CalibrationJson, SaysWhatIsWrongWithClicks) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "clicks: expected JSON, got something else"},
      {"[]", "clicks: 'clicks' is missing"},
      {R"({"clicks": 3})", "clicks: 'clicks' must be a list of at most 200 entries, got 3"},
      {R"({"clicks": [3]})", "clicks: 'landmark' is missing"},
      {R"({"clicks": [{"landmark": null}]})", "clicks: 'landmark' must be a text of at most 200 bytes, got null"},
      {R"({"clicks": [{"landmark": "a"}]})", "clicks: 'x' is missing"},
      {R"({"clicks": [{"landmark": "a", "x": "1", "y": 2}]})",
       "clicks: 'x' must be a number -100000 .. 100000, got \"1\""},
      {R"({"clicks": [{"landmark": "a", "x": 1, "y": 1e300}]})",
       "clicks: 'y' must be a number -100000 .. 100000, got 1e+300"},
  };
  for (const auto& [text, sentence] : cases) EXPECT_EQ(parse_clicks(text).error(), sentence) << text;
}

TEST(CalibrationJson, SurvivesEveryTruncationAndFlippedByteOfClicks) {
  const std::string text = R"({"clicks": [{"landmark": "corner +x +y", "x": 12.5, "y": 33}]})";
  for (std::size_t n = 0; n < text.size(); ++n) {
    EXPECT_FALSE(parse_clicks(text.substr(0, n)));
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = text;
      flipped[n] = static_cast<char>(flipped[n] ^ (1 << bit));
      const auto clicks = parse_clicks(flipped);
      EXPECT_TRUE(clicks || clicks.error().starts_with("clicks: ")) << flipped;
    }
  }
}

TEST(CalibrationJson, AnswersWithTheFit) {
  Calibration calibration;
  calibration.pose.field_from_sensor.translation() << 1, 2, 3;
  calibration.pose.depth_scale = 0.99;
  calibration.scale_deviation = 0.002;
  calibration.residuals = {{{"centre mark", 5, 6}, 0.5, true}};
  calibration.left_out = {0.01, 0.02, "centre mark"};
  calibration.robots = {0.006, 0.012, {{1, -0.5, 0.007}}};
  calibration.refused = "too few";
  const nlohmann::json expected = nlohmann::json::parse(R"({"fitted": true, "refused": "too few",
    "residuals": [{"landmark": "centre mark", "pixels": 0.5, "outlier": true}],
    "depth_scale": 0.99, "depth_scale_deviation": 0.002,
    "error": {"mean": 0.006, "p95": 0.012, "grid": [{"x": 1.0, "y": -0.5, "metres": 0.007}]},
    "ball_error": {"mean": 0.0, "p95": 0.0, "grid": []},
    "left_out": {"mean": 0.01, "worst": 0.02, "landmark": "centre mark"},
    "place": {"rotation": [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0], "x": 1.0, "y": 2.0, "z": 3.0}})");
  EXPECT_EQ(to_json(Result<Calibration>(calibration)), expected);
}

TEST(CalibrationJson, AnswersAnErrorWithItsSentence) {
  EXPECT_EQ(to_json(Result<Calibration>(Error{"no clicks"})).dump(), R"({"fitted":false,"refused":"no clicks"})");
}

TEST(CalibrationJson, ListsLandmarks) {
  const std::vector<Landmark> landmarks{{"centre mark", {0, 0, 0}}, {"post", {3, -0.75, 0}}};
  EXPECT_EQ(to_json(landmarks), nlohmann::json::parse(R"([{"name": "centre mark", "x": 0.0, "y": 0.0, "z": 0.0},
                                                          {"name": "post", "x": 3.0, "y": -0.75, "z": 0.0}])"));
}

}  // namespace
}  // namespace robot::truth
