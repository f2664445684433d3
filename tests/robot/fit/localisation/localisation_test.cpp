#include "robot/fit/localisation/localisation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "robot/fit/math/angles.h"
#include "tests/support/planted_poses.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

using tests::PlantedPoses;

PoseErrors errors_of(const std::vector<WatchedMotion>& motions) {
  PoseErrors poses;
  for (const WatchedMotion& motion : motions) add_pose_errors(motion, poses);
  return poses;
}

/// The report of the events alone.
Report report_of(const std::vector<WatchedMotion>& motions, const sim::Models& models) {
  return localisation_report({.poses = errors_of(motions), .marks = {}}, models);
}

/// Walks with many falls, penalties and flips.
PlantedPoses eventful(double minutes) {
  PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = minutes;
  planted.falls_per_minute = 1.5;
  planted.penalties_per_minute = 1;
  planted.models.effects.pose_flips = true;
  planted.models.perception.localisation.flips_per_minute = 1.5f;
  return planted;
}

TEST(Localisation, IntervalsCoverThePlantedValuesDespiteTheTruthsErrors) {
  PlantedPoses planted = eventful(6);
  planted.late = 0.02;
  const auto& model = planted.models.perception.localisation;
  const std::map<std::string, double> values{{"localisation.start_deviation", model.start_deviation},
                                             {"localisation.start_deviation_heading", model.start_deviation_heading},
                                             {"localisation.fall_deviation", model.fall_deviation},
                                             {"localisation.fall_deviation_heading", model.fall_deviation_heading},
                                             {"localisation.flips_per_minute", model.flips_per_minute},
                                             {"localisation.flip_duration", model.flip_duration}};
  int covered = 0, figures = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Report report = report_of(tests::planted_poses(planted, 5, seed), planted.models);
    for (const Figure& figure : report.figures) {
      ++figures;
      covered += figure.low <= values.at(figure.name) && values.at(figure.name) <= figure.high;
    }
  }
  EXPECT_GE(figures, 15);
  EXPECT_GE(covered, figures - 3);
}

TEST(Localisation, ErrorsAreThoseOfTheTeamsOwnFrame) {
  PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = 2;
  for (const bool attacks_plus : {true, false}) {
    planted.attacks_plus = attacks_plus;
    const PoseErrors poses = errors_of({tests::planted_pose_walk(planted, 3)});
    std::vector<double> places;
    for (const PoseError& error : poses.errors.at(0)) places.push_back(error.far());
    EXPECT_LT(lab::median_of(places), 0.3) << attacks_plus;
    EXPECT_TRUE(poses.flips.empty());
  }
}

TEST(Localisation, WithoutAGameTheSidesAreThoseThatFitBest) {
  PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = 8, planted.changes_sides = true;
  for (const bool attacks_plus : {true, false}) {
    planted.attacks_plus = attacks_plus;
    WatchedMotion motion = tests::planted_pose_walk(planted, 4);
    motion.games.clear();
    const PoseErrors poses = errors_of({motion});
    EXPECT_EQ(poses.without_sides, 1u);
    std::size_t far = 0;
    for (const PoseError& error : poses.errors.at(0)) far += error.far() > 1.5 ? 1 : 0;
    EXPECT_LT(far, poses.errors.at(0).size() / 50) << attacks_plus;
  }
}

/// A robot that stands at (2, 1) and believes it.
WatchedMotion standing(double seconds) {
  WatchedMotion motion;
  motion.name = "14/2";
  for (int i = 0; i < 30 * seconds; ++i) {
    const double at = i / 30.;
    motion.truth.push_back({.at = at, .x = 2, .y = 1, .heading = 0.5});
    motion.poses.push_back({.at = at, .x = 2, .y = 1, .heading = 0.5, .deviation = 0.2, .deviation_heading = 0.2});
    motion.status.push_back({.at = at});
  }
  motion.games.push_back({.at = 0, .half = 1, .attacks_plus = true});
  return motion;
}

TEST(Localisation, AFlipIsAPoseTurnedRoundUntilItIsBack) {
  WatchedMotion motion = standing(60);
  for (PoseAt& pose : motion.poses)
    if (pose.at >= 20 && pose.at < 32) pose.x = -2, pose.y = -1, pose.heading = wrapped(0.5 + M_PI);
  const PoseErrors poses = errors_of({motion});
  ASSERT_EQ(poses.flips.size(), 1u);
  EXPECT_NEAR(poses.flips[0].duration, 12, 0.1);
  EXPECT_TRUE(poses.flips[0].seen_begin && poses.flips[0].seen_end);
  EXPECT_NEAR(poses.unsure_seconds, 48, 0.2) << "a flipped pose cannot flip";
  for (const PoseError& error : poses.errors[0]) ASSERT_LT(error.far(), 1e-9) << error.at;

  // the end of the recording cuts a flip off
  for (PoseAt& pose : motion.poses)
    if (pose.at >= 55) pose.x = -2, pose.y = -1, pose.heading = wrapped(0.5 + M_PI);
  const PoseErrors open = errors_of({motion});
  ASSERT_EQ(open.flips.size(), 2u);
  EXPECT_FALSE(open.flips[1].seen_end);
}

TEST(Localisation, ARobotThatIsSureOfItsPoseMayNotFlip) {
  WatchedMotion motion = standing(30);
  for (PoseAt& pose : motion.poses) pose.deviation = 0.05, pose.deviation_heading = 0.05;
  EXPECT_EQ(errors_of({motion}).unsure_seconds, 0);
  for (PoseAt& pose : motion.poses) pose.deviation = pose.deviation_heading = NAN;
  EXPECT_NEAR(errors_of({motion}).unsure_seconds, 30, 0.1) << "without deviations it always may";
}

TEST(Localisation, AFallIsTheChangeFromJustBeforeToJustBeforeItStands) {
  WatchedMotion motion = standing(30);
  for (StatusAt& status : motion.status) {
    using Body = StatusAt::Body;
    if (status.at > 10 && status.at < 11) status.body = Body::fallen;
    if (status.at >= 11 && status.at < 13) status.body = Body::getting_up;
    if (status.at >= 13 && status.at < 14) status.body = Body::fallen;  // the attempt fails
    if (status.at >= 14 && status.at < 16) status.body = Body::getting_up;
  }
  for (PoseAt& pose : motion.poses) {
    if (pose.at > 10.01) pose.x += 0.3, pose.heading -= 0.4;
    if (pose.at > 15.99) pose.x = 2.1;  // marks correct it
  }
  const PoseErrors poses = errors_of({motion});
  ASSERT_EQ(poses.falls.size(), 1u);
  EXPECT_NEAR(poses.falls[0].x, 0.3, 1e-9);
  EXPECT_NEAR(poses.falls[0].heading, -0.4, 1e-9);
  EXPECT_EQ(poses.falls[0].events, 2);

  // without a status the truth knows when it lies
  motion.status.clear();
  for (TrueMoment& moment : motion.truth) moment.fallen = moment.at > 10 && moment.at < 16;
  EXPECT_EQ(errors_of({motion}).falls.size(), 1u);
}

TEST(Localisation, AnEntranceIsTheEndOfAPenaltyAndTheBeginOfAHalf) {
  WatchedMotion motion = standing(60);
  motion.games = {{.at = 0, .plays = false, .half = 1, .attacks_plus = true},
                  {.at = 5, .half = 1, .attacks_plus = true},
                  {.at = 20, .penalised = true, .half = 1, .attacks_plus = true},
                  {.at = 30, .half = 1, .attacks_plus = true},
                  {.at = 40, .half = 2, .attacks_plus = true}};
  const PoseErrors poses = errors_of({motion});
  ASSERT_EQ(poses.starts.size(), 3u);
  EXPECT_NEAR(poses.starts[0].at, 0, 0.01);
  EXPECT_NEAR(poses.starts[1].at, 30, 0.05);
  EXPECT_NEAR(poses.starts[2].at, 40, 0.05);
  motion.games.front().plays = true;
  EXPECT_EQ(errors_of({motion}).starts.size(), 2u) << "a recording that begins in play begins with no entrance";
}

TEST(Localisation, TheTruthsNoiseIsThatOfRobotsThatStand) {
  PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = 5, planted.truth_error = 0.03, planted.heading_error = 0.08;
  const TruthNoise noise = truth_noise(tests::planted_pose_walk(planted, 2));
  EXPECT_NEAR(noise.place, 0.03, 0.003);
  EXPECT_NEAR(noise.heading, 0.08, 0.008);
  WatchedMotion walks = standing(20);
  for (StatusAt& status : walks.status) status.speed = 0.2;
  EXPECT_EQ(truth_noise(walks).place, 0);
}

TEST(Localisation, NoFlipGivesAnUpperBound) {
  const Report report = report_of({standing(1200)}, tests::match_models());
  const auto rate = std::ranges::find(report.figures, "localisation.flips_per_minute", &Figure::name);
  ASSERT_NE(rate, report.figures.end());
  EXPECT_EQ(rate->value, 0);
  EXPECT_EQ(rate->low, 0);
  EXPECT_NEAR(rate->high, 3.689 / 20, 0.001);
  EXPECT_FALSE(rate->is_known());
}

TEST(Localisation, TooFewEventsAreRefused) {
  const Report report = report_of({standing(60)}, tests::match_models());
  EXPECT_TRUE(report.empty());
  ASSERT_GE(report.kept.size(), 4u);
  EXPECT_EQ(report.kept[0],
            "localisation.start_deviation and its heading: expected at least 8 entrances beside the truth, got 0");
  EXPECT_EQ(report.kept[1],
            "localisation.fall_deviation and its heading: expected at least 8 falls beside the truth, got 0");
  EXPECT_EQ(report.kept[2],
            "localisation.flips_per_minute: expected at least 10 minutes of robots that are unsure of their pose, "
            "got 1.0");
  EXPECT_EQ(report.kept[3], "localisation.flip_duration: expected at least 3 flips whose end was seen, got 0");
  EXPECT_EQ(fit_localisation({}, tests::match_models()).kept.at(0),
            "localisation: expected a recording with poses beside a truth with headings of the robot, got 0");
}

TEST(Localisation, TheOrderOfRecordingsDoesNotMatter) {
  auto walks = tests::planted_poses(eventful(5), 3, 2);
  const Report one = report_of(walks, tests::match_models());
  std::ranges::reverse(walks);
  const Report two = report_of(walks, tests::match_models());
  ASSERT_EQ(one.figures.size(), two.figures.size());
  for (std::size_t i = 0; i < one.figures.size(); ++i)
    EXPECT_NEAR(one.figures[i].value, two.figures[i].value, 1e-6) << one.figures[i].name;
}

TEST(Localisation, MarksAreFoundByTheSimulatorsOwnLocalisation) {
  PlantedPoses planted = eventful(4);
  auto& model = planted.models.perception.localisation;
  model.mark_deviation = 0.12f, model.mark_deviation_heading = 0.07f;
  PoseEvidence evidence;
  for (const WatchedMotion& walk : tests::planted_poses(planted, 4, 3)) add_poses(walk, evidence);
  const Report report = localisation_report(evidence, tests::match_models());
  const auto place = std::ranges::find(report.figures, "localisation.mark_deviation", &Figure::name);
  const auto heading = std::ranges::find(report.figures, "localisation.mark_deviation_heading", &Figure::name);
  ASSERT_NE(place, report.figures.end());
  ASSERT_NE(heading, report.figures.end());
  EXPECT_TRUE(place->low <= 0.12 && place->high >= 0.12) << to_text(*place);
  EXPECT_TRUE(heading->low <= 0.07 && heading->high >= 0.07) << to_text(*heading);
  EXPECT_EQ(report.pictures.size(), 5u);
}

TEST(Localisation, SimulatedErrorsGrowWithThoseOfTheMarks) {
  PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = 3;
  PoseEvidence evidence;
  add_poses(tests::planted_pose_walk(planted, 5), evidence);
  const auto errors_with = [&](float deviation, std::uint64_t seed) {
    sim::Models models = tests::match_models();
    models.perception.localisation.mark_deviation = deviation;
    return simulated_errors(evidence.marks.walks, models, kFieldOfTheLeague, seed);
  };
  EXPECT_LT(errors_with(0.03f, 1).place, errors_with(0.1f, 1).place);
  EXPECT_LT(errors_with(0.1f, 1).place, errors_with(0.3f, 1).place);
  EXPECT_EQ(errors_with(0.1f, 1).place, errors_with(0.1f, 1).place) << "the same seed gives the same luck";
  EXPECT_NE(errors_with(0.1f, 1).place, errors_with(0.1f, 2).place);
  EXPECT_EQ(errors_with(0.1f, 1).moments, recorded_errors(evidence.marks.walks).moments);
}

TEST(Localisation, MarksNeedOdometryAndTenMinutes) {
  const auto kept_of = [](PlantedPoses planted, bool with_odometry) {
    planted.models = tests::match_models();
    WatchedMotion motion = tests::planted_pose_walk(planted, 1);
    if (!with_odometry) motion.odometry.clear();
    PoseEvidence evidence;
    add_poses(motion, evidence);
    const Report report = localisation_report(evidence, planted.models);
    const auto about_marks = [](const std::string& sentence) {
      return sentence.find("mark_deviation") != sentence.npos;
    };
    const auto sentence = std::ranges::find_if(report.kept, about_marks);
    return sentence == report.kept.end() ? std::string() : *sentence;
  };
  EXPECT_EQ(kept_of({.models = {}, .minutes = 3}, false),
            "localisation.mark_deviation and its heading: expected at least 40 windows of odometry beside the poses "
            "and motion_status, got 0");
  EXPECT_EQ(kept_of({.models = {}, .minutes = 5}, true),
            "localisation.mark_deviation and its heading: expected at least 20 half minutes of upright robots with "
            "poses and motion_status, got 10");
}

TEST(Localisation, RobotsThatKnowTheirPoseExactlyKeepTheMarks) {
  PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = 6, planted.truth_error = 0, planted.heading_error = 0;
  planted.models.effects.odometry_drift = false;
  PoseEvidence evidence;
  for (const WatchedMotion& walk : tests::planted_poses(planted, 2, 3)) add_poses(walk, evidence);
  const Report report = localisation_report(evidence, tests::match_models());
  EXPECT_TRUE(std::ranges::none_of(report.figures,
                                   [](const Figure& figure) { return figure.name.find("mark") != std::string::npos; }));
  EXPECT_TRUE(std::ranges::any_of(report.kept, [](const std::string& sentence) {
    return sentence.starts_with("localisation.mark_deviation: expected errors");
  }));
}

TEST(Localisation, ASimulatedGameIsEvidence) {
  const ::tests::TemporaryFolder folder;
  const Evidence evidence = tests::simulated_robots(
      folder.path() / "game", {.seconds = 15, .place_error = 0.02, .heading_error = 0.05, .clock_error = 0.01});
  const Report report = fit_localisation(evidence, tests::match_models());
  const auto start = std::ranges::find(report.figures, "localisation.start_deviation", &Figure::name);
  ASSERT_NE(start, report.figures.end()) << "ten robots enter the field";
  EXPECT_GE(start->events, 10u);
  EXPECT_LE(start->low, 0.3);
  EXPECT_GE(start->high, 0.3);
  EXPECT_GE(report.pictures.size(), 2u);
  EXPECT_EQ(report.title, "How well the robots know where they are");
}

}  // namespace
}  // namespace robot::fit
