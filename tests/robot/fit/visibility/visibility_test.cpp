#include "robot/fit/visibility/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "robot/fit/visibility/along.h"
#include "robot/fit/visibility/detection.h"
#include "robot/fit/visibility/false_balls.h"
#include "robot/fit/visibility/logistic.h"
#include "robot/fit/visibility/scoring.h"
#include "robot/fit/visibility/view.h"
#include "sim/perception/image.h"
#include "tests/support/planted_looks.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

using tests::planted_base, tests::planted_logistic, tests::planted_detections, tests::PlantedDetections;

const Figure* figure_in(const std::vector<Figure>& figures, const std::string& name) {
  const auto figure = std::ranges::find(figures, name, &Figure::name);
  return figure == figures.end() ? nullptr : &*figure;
}

DetectionFit detection_in(const Sights& sights) {
  return fit_detection(sights, passes_of(sights.sights), curve_of(planted_base().perception.ball));
}

bool says(const std::vector<std::string>& sentences, const std::string& part) {
  return std::ranges::any_of(sentences, [&](const std::string& one) { return one.find(part) != std::string::npos; });
}

double score_in(const Report& report, const std::string& name) {
  const auto score = std::ranges::find(report.scores, name, &std::pair<std::string, double>::first);
  return score == report.scores.end() ? NAN : score->second;
}

TEST(DetectionCurve, IsThatOfTheSimulator) {
  const sim::perception::Detection model = planted_base().perception.ball;
  const DetectionCurve curve = curve_of(model);
  for (float distance = 0.1f; distance < 8; distance += 0.1f)
    EXPECT_NEAR(curve.probability(distance), sim::perception::probability(model, distance), 1e-5) << distance;
}

TEST(Detection, IntervalsCoverThePlantedCurve) {
  const PlantedDetections planted{.near = 0.8, .far = 0.3, .near_range = 2.5};
  int covered[3] = {};
  double bias[3] = {};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const DetectionFit fit = detection_in(planted_detections(planted, seed));
    const std::pair<const char*, double> values[] = {
        {"ball_detection.near", 0.8}, {"ball_detection.far", 0.3}, {"ball_detection.near_range", 2.5}};
    for (int k = 0; k < 3; ++k) {
      const Figure* figure = figure_in(fit.figures, values[k].first);
      ASSERT_TRUE(figure) << values[k].first;
      EXPECT_TRUE(figure->is_known());
      covered[k] += figure->low <= values[k].second && figure->high >= values[k].second;
      bias[k] += (figure->value - values[k].second) / (figure->high - figure->low) / 6;
    }
    EXPECT_TRUE(fit.kept.empty());
  }
  // 95 % of 6; scripts/bench fit counts a hundred
  for (int k = 0; k < 3; ++k) EXPECT_GE(covered[k], 4) << k;
  for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(bias[k]), 0.33) << k;
}

TEST(Detection, HiddenBallsDoNotCount) {
  Sights sights = planted_detections({}, 3);
  const DetectionFit before = detection_in(sights);
  std::vector<Sight> more;
  for (const Sight& sight : sights.sights) {
    more.push_back(sight);
    more.push_back(sight);
    more.back().hidden = true, more.back().seen = false;
  }
  sights.sights = more;
  EXPECT_EQ(figure_in(detection_in(sights).figures, "ball_detection.near")->value,
            figure_in(before.figures, "ball_detection.near")->value);
}

TEST(Detection, DistancesThatAreAlikeCannotTellTheParametersApart) {
  const DetectionFit fit = detection_in(planted_detections({.nearest = 1, .farthest = 1.4}, 1));
  EXPECT_TRUE(fit.figures.empty());
  EXPECT_TRUE(says(fit.kept, "near, far and near_range cannot be told apart: expected distances that differ by 1.0 m"));
  EXPECT_EQ(fit.curve.near, curve_of(planted_base().perception.ball).near);
}

TEST(Detection, WithoutFarBallsTheFarEndStays) {
  const DetectionFit fit = detection_in(planted_detections({.near_range = 2, .farthest = 4}, 1));
  EXPECT_FALSE(figure_in(fit.figures, "ball_detection.far"));
  EXPECT_TRUE(figure_in(fit.figures, "ball_detection.near"));
  EXPECT_TRUE(says(fit.kept, "ball_detection.far: expected at least 5 passes with a ball at 4.5 m or farther, got 0"));
}

TEST(Detection, AShareThatDoesNotFallHasNoNearRange) {
  const DetectionFit fit = detection_in(planted_detections({.near = 0.7, .far = 0.7}, 2));
  EXPECT_FALSE(figure_in(fit.figures, "ball_detection.near_range"));
  EXPECT_TRUE(says(fit.kept, "ball_detection.near_range: expected a share that begins to fall at "));
  EXPECT_NEAR(figure_in(fit.figures, "ball_detection.near")->value, 0.7, 0.05);
}

TEST(Detection, BallsSeenBeyondTheRangeExtendIt) {
  const DetectionFit fit = detection_in(planted_detections({.far_range = 8, .farthest = 9}, 1));
  const Figure* range = figure_in(fit.figures, "ball_detection.far_range");
  ASSERT_TRUE(range);
  EXPECT_LE(range->low, 8);
  EXPECT_GE(range->high, 8);
  EXPECT_FALSE(figure_in(detection_in(planted_detections({}, 1)).figures, "ball_detection.far_range"));
}

TEST(Detection, SingleFalseBallsDoNotExtendTheRange) {
  Sights sights = planted_detections({}, 1);
  const std::vector<Group> passes = passes_of(sights.sights);
  for (const Group& pass : passes) sights.sights[pass.front()].seen = true;
  EXPECT_FALSE(figure_in(detection_in(sights).figures, "ball_detection.far_range"));
}

TEST(Detection, TooFewPassesAreRefused) {
  const DetectionFit fit = detection_in(planted_detections({.hidden = 0, .passes = 12}, 1));
  EXPECT_TRUE(fit.figures.empty());
  EXPECT_TRUE(says(fit.kept,
                   "ball_detection: expected at least 20 passes with a free ball in view, 10 with a seen one and 10 "
                   "with a missed one, got 1"));
}

TEST(Logistic, IntervalsCoverThePlantedWeights) {
  const Logistic::Features weights{2, 0.3, -0.15, -1, 0.5, -0.4, -1.5};
  int covered = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Sights sights = planted_logistic(weights, 150, seed);
    const Logistic fit = fit_logistic(sights.sights, all_of(sights.sights.size()));
    const auto around = deviations_of(fit, sights.sights, passes_of(sights.sights));
    for (std::size_t k = 0; k < weights.size(); ++k)
      covered += std::abs(fit.weights[k] - weights[k]) <= two_sided(149) * around[k];
  }
  EXPECT_GE(covered, 36) << "95 % of 42";
}

TEST(Logistic, AFeatureThatDecidesAloneKeepsAFiniteWeight) {
  Sights sights = planted_logistic({1, 0, 0, 0, 0, 0, 0}, 100, 1);
  for (Sight& sight : sights.sights)
    if (sight.hidden) sight.seen = false;
  const Logistic fit = fit_logistic(sights.sights, all_of(sights.sights.size()));
  EXPECT_LT(fit.weights[6], -3);
  EXPECT_GT(fit.weights[6], -50);
}

TEST(Logistic, PassesThatShareTheirLuckWidenTheInterval) {
  Sights sights = planted_logistic({1, 0, 0, 0, 0, 0, 0}, 150, 1);
  const std::vector<Group> passes = passes_of(sights.sights);
  const Logistic fit = fit_logistic(sights.sights, all_of(sights.sights.size()));
  const double alone = deviations_of(fit, sights.sights, passes)[0];
  for (const Group& pass : passes)
    for (const std::size_t i : pass) sights.sights[i].seen = sights.sights[pass.front()].seen;
  const Logistic shared = fit_logistic(sights.sights, all_of(sights.sights.size()));
  EXPECT_GT(deviations_of(shared, sights.sights, passes)[0], 2 * alone);
}

TEST(Visibility, BothModelsBeatAConstantAndTheDefault) {
  const Report report =
      visibility_of(planted_detections({.near = 0.7, .far = 0.5, .near_range = 1.5}, 5), planted_base());
  for (const char* model : {"log_loss_detection", "log_loss_logistic"}) {
    EXPECT_LT(score_in(report, model), score_in(report, "log_loss_constant")) << model;
    EXPECT_LT(score_in(report, model), score_in(report, "log_loss_default")) << model;
  }
  EXPECT_LT(score_in(report, "brier_logistic"), score_in(report, "brier_default"));
  ASSERT_EQ(report.pictures.size(), 2u);
  for (const Picture& picture : report.pictures)
    for (const Mark& mark : picture.marks) EXPECT_EQ(mark.x.size(), mark.y.size()) << mark.label;
  ASSERT_EQ(report.tables.size(), 1u);
  EXPECT_EQ(report.needs.size(), 3u);
  EXPECT_TRUE(std::isfinite(score_in(report, "log_loss_default")));
}

TEST(Visibility, ThePredictionsAreReliable) {
  const Sights sights = planted_detections({}, 7);
  const SightScores scores = scores_of(sights, passes_of(sights.sights), curve_of(planted_base().perception.ball));
  for (const ReliabilityBin& bin : reliability(sights.sights, scores.models[2].probabilities))
    if (bin.images > 300) {
      EXPECT_NEAR(bin.observed, bin.predicted, 0.1);
    }
}

TEST(Visibility, NothingInViewIsRefusedWithTheReason) {
  const Report report = visibility_of({.near_border = 7}, planted_base());
  EXPECT_TRUE(report.empty());
  ASSERT_EQ(report.kept.size(), 1u);
  EXPECT_EQ(report.kept[0],
            "visibility: expected images with the ball in view, got none (7 with a ball too near to the border)");
  EXPECT_FALSE(report.needs.empty());
}

TEST(Visibility, WithoutRecordingsItSaysWhatIsMissing) {
  const Report report = fit_visibility(Evidence{}, planted_base());
  ASSERT_EQ(report.kept.size(), 1u);
  EXPECT_EQ(report.kept[0], "visibility: expected images of robots beside the truth (topic vision), got none");
}

TEST(Looks, TheReasonIsTheCommonestObstacle) {
  Looks looks;
  looks.without_heading = 5;
  EXPECT_EQ(reason_without(looks), "the truth has no headings of the robots (5 images)");
  looks = {};
  looks.without_camera = 4;
  EXPECT_EQ(reason_without(looks), "expected a camera matrix for each image, got none for all 4");
  looks = {};
  looks.without_truth = 3;
  EXPECT_EQ(reason_without(looks), "the truth does not place robot and ball at the time of any of 3 images");
}

/// A ball 2 m ahead, in the middle of the view and seen.
Looks one_look(const std::function<void(Look&)>& change) {
  Look look{.distance = 2,
            .height = 0.4,
            .placed = 0.02,
            .across = 0.4,
            .upright = 0.4,
            .width = 1,
            .has_ball = true,
            .seen_x = 2.1,
            .seen_y = 0.05};
  change(look);
  return {.looks = {look}, .recordings = {"one"}};
}

TEST(Sights, ABallWellInViewIsOneAndNearTheBorderItIsNot) {
  const sim::Models base = planted_base();
  EXPECT_EQ(sights_of(one_look([](Look&) {}), base).sights.size(), 1u);
  EXPECT_TRUE(sights_of(one_look([](Look&) {}), base).sights[0].seen);
  for (double Look::*way : {&Look::across, &Look::upright}) {
    const Sights cut = sights_of(one_look([&](Look& look) { look.*way = 0.02; }), base);
    EXPECT_TRUE(cut.sights.empty());
    EXPECT_EQ(cut.near_border, 1u);
    const Sights outside = sights_of(one_look([&](Look& look) { look.*way = -0.02; }), base);
    EXPECT_TRUE(outside.sights.empty());
    EXPECT_EQ(outside.near_border, 0u);
  }
}

TEST(Sights, AFarPerceptIsAFalseBallAndNotSeen) {
  const sim::Models base = planted_base();
  EXPECT_TRUE(sights_of(one_look([](Look& look) { look.seen_y = 0.45; }), base).sights[0].seen)
      << "within half a metre";
  EXPECT_FALSE(sights_of(one_look([](Look& look) { look.seen_x = -2; }), base).sights[0].seen);
  EXPECT_FALSE(sights_of(one_look([](Look& look) { look.seen_x = 0.5; }), base).sights[0].seen);
  EXPECT_FALSE(sights_of(one_look([](Look& look) { look.has_ball = false; }), base).sights[0].seen);
}

TEST(Sights, WhetherARobotHidesTheBallMustBeSure) {
  const Sights hidden = sights_of(one_look([](Look& look) { look.hiding = Hiding::hidden; }), planted_base());
  ASSERT_EQ(hidden.sights.size(), 1u);
  EXPECT_TRUE(hidden.sights[0].hidden);
  const Sights unsure = sights_of(one_look([](Look& look) { look.hiding = Hiding::unsure; }), planted_base());
  EXPECT_TRUE(unsure.sights.empty());
  EXPECT_EQ(unsure.unsure, 1u);
}

TEST(Sights, NoiseDropsFarBallsMoreThanNearOnes) {
  const auto plausible = [](double distance) {
    return sights_of(one_look([&](Look& look) { look.distance = distance, look.walking = true; }), planted_base())
        .sights.at(0)
        .plausible;
  };
  EXPECT_NEAR(plausible(1), 1, 1e-6);
  // sim/perception/image.h: at 6 m the noise of 0.03 rad puts 13 % beyond 12 m
  EXPECT_NEAR(plausible(6), 0.866, 0.01);
}

/// A minute of a simulated game whose robots see worse than by default.
struct Recorded : ::testing::Test {
  static Evidence evidence() {
    return tests::simulated_robots(folder().path() / "game",
                                   {.models = "match,ball_detection.near=0.6,ball_filter.false_per_second=0.2",
                                    .seconds = 60,
                                    .place_error = 0.02,
                                    .heading_error = 0.05,
                                    .clock_error = 0.01});
  }
  static const ::tests::TemporaryFolder& folder() {
    static const ::tests::TemporaryFolder one;
    return one;
  }
};

TEST_F(Recorded, SimulatedRobotsShowTheirPlantedDetection) {
  Evidence evidence = Recorded::evidence();
  const Report report = fit_visibility(evidence, planted_base());
  const Figure* near = figure_in(report.figures, "ball_detection.near");
  ASSERT_TRUE(near) << (report.kept.empty() ? "" : report.kept[0]);
  EXPECT_NEAR(near->value, 0.6, 0.05);
  const Report wrong = fit_false_balls(evidence, planted_base());
  ASSERT_EQ(wrong.figures.size(), 1u);
  EXPECT_NEAR(wrong.figures[0].value, 0.2, 0.07);

  // the order of the recordings does not matter
  std::ranges::reverse(evidence.robots);
  EXPECT_NEAR(figure_in(fit_visibility(evidence, planted_base()).figures, "ball_detection.near")->value, near->value,
              1e-3);

  // without cameras, or without headings, nothing is fitted
  Evidence blind = evidence;
  for (WatchedRobot& robot : blind.robots)
    std::erase_if(robot.session.streams,
                  [](const auto& stream) { return stream.topic.find("camera_top_matrix") != std::string::npos; });
  EXPECT_TRUE(says(fit_visibility(blind, planted_base()).kept, "expected a camera matrix for each image, got none"));
  for (WatchedRobot& robot : evidence.robots)
    for (lab::PlaceAt& place : robot.path) place.heading = NAN;
  EXPECT_TRUE(says(fit_visibility(evidence, planted_base()).kept, "the truth has no headings of the robots"));
}

TEST(Passes, AreAtMostTwoSecondsLongAndOfOneRecording) {
  std::vector<Sight> sights;
  for (int i = 0; i < 90; ++i) sights.push_back({.recording = 0, .at = i / 30.});
  sights.push_back({.recording = 0, .at = 4});
  sights.push_back({.recording = 1, .at = 4.01});
  const auto passes = passes_of(sights);
  ASSERT_EQ(passes.size(), 4u);
  EXPECT_EQ(passes[0].size(), 60u);
  EXPECT_EQ(passes[1].size(), 30u);
}

TEST(Along, PlacesAreInterpolatedInAnyOrderAndNotAcrossAJump) {
  lab::Path path;
  for (int i = 0; i < 10; ++i) path.push_back({.at = i / 10., .x = i / 10., .y = 0, .heading = i < 5 ? 3.1 : -3.1});
  path[9].x = 3;
  Along along(path, 3);
  EXPECT_NEAR(along.at(0.55)->x, 0.55, 1e-9);
  EXPECT_NEAR(along.at(0.15)->x, 0.15, 1e-9);
  EXPECT_NEAR(std::abs(std::remainder(along.at(0.45)->heading, 2 * M_PI)), M_PI, 1e-6) << "the short way round";
  EXPECT_FALSE(along.at(0.85)) << "it was put elsewhere";
  EXPECT_FALSE(along.at(-0.1));
  EXPECT_FALSE(along.at(0.95));
  path[5].at = 0.45, path.erase(path.begin() + 2, path.begin() + 5);
  EXPECT_FALSE(Along(path, 3).at(0.3)) << "a pause";
}

foresight::CameraMatrix level_camera() {
  foresight::CameraMatrix matrix;
  for (const float number : {0.f, 0.f, 1.f, -1.f, 0.f, 0.f, 0.f, -1.f, 0.f}) matrix.add_rotation(number);
  matrix.set_z(0.5f);
  matrix.set_width(640), matrix.set_height(480);
  matrix.set_focal_x(600), matrix.set_focal_y(600);
  matrix.set_centre_x(320), matrix.set_centre_y(240);
  return matrix;
}

TEST(View, APointInTheImageIsInside) {
  const auto view = view_of(level_camera(), 0);
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->inside(2, 0, 0.5).across, std::atan2(320, 600), 1e-6);
  EXPECT_NEAR(view->inside(2, 0, 0.5).upright, std::atan2(240, 600), 1e-6);
  EXPECT_NEAR(view->inside(2, 2 * 320 / 600., 0.5).across, 0, 1e-6) << "at the left border";
  EXPECT_NEAR(view->inside(2, 0, 0.5 - 2 * 240 / 600.).upright, 0, 1e-6) << "at the lower border";
  EXPECT_LT(view->inside(-2, 0, 0.5).across, 0) << "behind the robot";
  EXPECT_NEAR(view->inside(2, 0.3, 0).across, view->inside(2, -0.3, 0).across, 1e-6) << "mirrored";
}

TEST(View, ADamagedMatrixHasNone) {
  const auto damaged = [](const std::function<void(foresight::CameraMatrix&)>& change) {
    foresight::CameraMatrix matrix = level_camera();
    change(matrix);
    return !view_of(matrix, 0);
  };
  EXPECT_TRUE(damaged([](auto& matrix) { matrix.clear_rotation(); }));
  EXPECT_TRUE(damaged([](auto& matrix) { matrix.set_rotation(4, NAN); }));
  EXPECT_TRUE(damaged([](auto& matrix) { matrix.set_rotation(2, 0.5f); }));
  EXPECT_TRUE(damaged([](auto& matrix) { matrix.set_z(INFINITY); }));
  EXPECT_TRUE(damaged([](auto& matrix) { matrix.set_width(0); }));
  EXPECT_TRUE(damaged([](auto& matrix) { matrix.set_focal_x(NAN); }));
}

}  // namespace
}  // namespace robot::fit
