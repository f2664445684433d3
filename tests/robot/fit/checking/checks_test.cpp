// Each kind of situations by itself, planted in memory.
#include "robot/fit/checking/checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "tests/support/planted_kicks.h"
#include "tests/support/planted_looks.h"
#include "tests/support/planted_packets.h"
#include "tests/support/planted_sights.h"
#include "tests/support/planted_walks.h"

namespace robot::tests {
namespace {

using fit::Statistic, fit::Verdict;

std::size_t count_outside(const std::vector<Statistic>& statistics) {
  const std::vector<Verdict> verdicts = fit::judge(statistics);
  return static_cast<std::size_t>(std::ranges::count(verdicts, false, &Verdict::inside));
}

const Statistic* statistic_in(const std::vector<Statistic>& statistics, const std::string& name) {
  const auto found = std::ranges::find(statistics, name, &Statistic::name);
  return found == statistics.end() ? nullptr : &*found;
}

bool is_said(const std::vector<std::string>& sentences, const std::string& sentence) {
  return std::ranges::find(sentences, sentence) != sentences.end();
}

// --- verdicts ---

TEST(Judge, RightModelsHaveAllStatisticsInsideIn95PercentOfRecordings) {
  constexpr std::size_t kStatistics = 12, kRecordings = 2000;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Statistic> statistics(kStatistics);
  for (Statistic& one : statistics)
    for (std::size_t i = 0; i < fit::kCheckSamples; ++i) one.simulated.push_back(normal(random));
  const std::vector<Verdict> verdicts = fit::judge(statistics);
  std::size_t all_inside = 0;
  for (std::size_t i = 0; i < kRecordings; ++i)
    all_inside += std::ranges::all_of(verdicts, [&](const Verdict& verdict) {
      const double recorded = normal(random);
      return recorded >= verdict.low && recorded <= verdict.high;
    });
  EXPECT_NEAR(static_cast<double>(all_inside) / kRecordings, 0.95, 0.02);
}

TEST(Judge, TheDistanceIsInHalfIntervals) {
  const Verdict verdict{.middle = 2, .low = 1, .high = 6};
  EXPECT_EQ(verdict.distance(2), 0);
  EXPECT_EQ(verdict.distance(1), -1);
  EXPECT_EQ(verdict.distance(6), 1);
  EXPECT_EQ(verdict.distance(10), 2);
  const Verdict exact{.middle = 2, .low = 2, .high = 2};
  EXPECT_EQ(exact.distance(2), 0);
  EXPECT_EQ(exact.distance(3), INFINITY);
}

// --- walks ---

sim::Models spread_models() {
  sim::Models models = walking_models();
  models.effects.walk_spread = true;
  return models;
}

fit::Drives planted_drives(const sim::Models& models, std::uint64_t seed, std::size_t robots = 8,
                           double seconds = 100) {
  return drives_of(walked_drills({.models = models, .robots = robots, .seconds = seconds}, seed), 0);
}

TEST(CheckWalk, RightModelsAreInsideAndFasterOnesAreNot) {
  const sim::Models models = spread_models();
  sim::Models fast = models;
  fast.motion.walk.forward *= 1.3f;
  std::size_t inside = 0, flagged = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const fit::Drives drives = planted_drives(models, seed);
    std::vector<std::string> missing;
    const auto right = fit::check_walk(drives, models, missing), wrong = fit::check_walk(drives, fast, missing);
    EXPECT_EQ(right.size(), 5u);
    EXPECT_TRUE(missing.empty());
    inside += count_outside(right) == 0 ? 1 : 0;
    flagged += count_outside(wrong) > 0 ? 1 : 0;
  }
  EXPECT_EQ(inside, 5u);
  EXPECT_GE(flagged, 4u);
}

TEST(CheckWalk, OneRobotWithoutSpreadShowsTenPercentOfItsSpeed) {
  const sim::Models models = walking_models();
  const fit::Drives drives = planted_drives(models, 6, 1, 600);
  std::vector<std::string> missing;
  EXPECT_EQ(count_outside(fit::check_walk(drives, models, missing)), 0u);
  sim::Models fast = models;
  fast.motion.walk.forward *= 1.1f;
  const auto statistics = fit::check_walk(drives, fast, missing);
  ASSERT_TRUE(statistic_in(statistics, "walk: speed ahead"));
  EXPECT_EQ(count_outside({*statistic_in(statistics, "walk: speed ahead")}), 1u);
  EXPECT_FALSE(statistic_in(statistics, "walk: speed ahead of the fastest robot")) << "three robots at least";
  sim::Models turning = models;
  turning.motion.walk.turn_rate *= 1.3f;
  const auto turns = fit::check_walk(drives, turning, missing);
  ASSERT_TRUE(statistic_in(turns, "walk: turn rate"));
  EXPECT_EQ(count_outside({*statistic_in(turns, "walk: turn rate")}), 1u);
}

TEST(CheckWalk, AMirroredFieldGivesTheSame) {
  const PlantedWalks one{.robots = 2, .seconds = 100};
  PlantedWalks other = one;
  other.mirrored = true;
  std::vector<std::string> missing;
  const auto here = fit::check_walk(drives_of(walked_drills(one, 7), 0), one.models, missing);
  const auto there = fit::check_walk(drives_of(walked_drills(other, 7), 0), one.models, missing);
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i].recorded, there[i].recorded, 0.003) << i;
}

TEST(CheckWalk, TheErrorOfTheClockWidensTheInterval) {
  const auto drills = walked_drills({.seconds = 100}, 8);
  std::vector<std::string> missing;
  const auto exact = fit::judge(fit::check_walk(drives_of(drills, 0), walking_models(), missing));
  const auto loose = fit::judge(fit::check_walk(drives_of(drills, 0.2), walking_models(), missing));
  EXPECT_GT(loose[0].high - loose[0].low, exact[0].high - exact[0].low);
}

// --- kicks ---

sim::Models kicking_models(const PlantedKicks& planted) {
  sim::Models models{};
  models.effects.kick_noise = models.effects.partial_hits = true;
  models.ball.deceleration = static_cast<float>(planted.deceleration);
  models.motion.kick_count = 1;
  const double range = planted.model.speed * planted.model.speed / (2 * planted.deceleration);
  models.motion.kicks[0] = {.name = "forward",
                            .ball_x = 0.18f,
                            .ball_y = 0.05f,
                            .gate_x = 0.1f,
                            .gate_y = 0.1f,
                            .delay = 0.6f,
                            .duration = 1.5f,
                            .range = static_cast<float>(range),
                            .range_deviation = static_cast<float>(planted.model.range_deviation),
                            .direction = static_cast<float>(planted.model.direction),
                            .direction_deviation = static_cast<float>(planted.model.direction_deviation)};
  models.motion.hits = {.partial = static_cast<float>(planted.model.partial), .spread = 3};
  return models;
}

fit::KickFit tracked_kicks(const PlantedKicks& planted, const sim::Models& models, std::uint64_t seed) {
  const KickedBalls game = kicked_balls(planted, seed);
  fit::KickFit seen{.kind = "forward", .kicks = {}, .model = {}, .figures = {}, .partial = {}, .slowest = 0.2};
  for (const fit::KickRun& run : game.runs) {
    const auto kick = fit::tracked(game.truth, game.robot, run, fit::kick_facts_of(models).kinds[0], 0.3);
    if (const auto* good = std::get_if<fit::TrackedKick>(&kick)) seen.kicks.push_back(*good);
  }
  return seen;
}

TEST(CheckKicks, RightModelsAreInsideAndFartherOnesAreNot) {
  std::size_t inside = 0, flagged = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    PlantedKicks planted{.kicks = 25};
    planted.model.partial = seed % 2 == 0 ? 0.3 : 0;
    const sim::Models models = kicking_models(planted);
    sim::Models far = models;
    far.motion.kicks[0].range += 2;
    const fit::KickFit seen = tracked_kicks(planted, models, seed);
    std::vector<std::string> missing;
    const auto right = fit::check_kicks({seen}, models, missing);
    EXPECT_EQ(right.size(), 4u);
    inside += count_outside(right) == 0 ? 1 : 0;
    const auto wrong = fit::check_kicks({seen}, far, missing);
    flagged += count_outside({*statistic_in(wrong, "kick forward: mean distance")});
    flagged += count_outside({*statistic_in(wrong, "kick forward: likeliest range of full hits")});
  }
  EXPECT_GE(inside, 5u);
  EXPECT_EQ(flagged, 12u);
}

TEST(CheckKicks, ARangeThatIsTooLongIsSeenAmongPartialHits) {
  std::size_t inside = 0, flagged = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    PlantedKicks planted{.kicks = 60};
    planted.model.partial = 0.95;
    const sim::Models models = kicking_models(planted);
    sim::Models far = models;
    far.motion.kicks[0].range *= 1.5f;
    const fit::KickFit seen = tracked_kicks(planted, models, seed);
    std::vector<std::string> missing;
    const auto right = fit::check_kicks({seen}, models, missing);
    inside += count_outside(right) == 0 ? 1 : 0;
    EXPECT_NEAR(statistic_in(right, "kick forward: likeliest range of full hits")->recorded,
                models.motion.kicks[0].range, 1);
    flagged += count_outside(fit::check_kicks({seen}, far, missing)) > 0 ? 1 : 0;
  }
  EXPECT_GE(inside, 5u);
  EXPECT_EQ(flagged, 6u);
}

TEST(CheckKicks, TheDirectionAndItsDeviationAreChecked) {
  const PlantedKicks planted{.kicks = 40};
  const sim::Models models = kicking_models(planted);
  const fit::KickFit seen = tracked_kicks(planted, models, 11);
  std::vector<std::string> missing;
  sim::Models left = models, wide = models;
  left.motion.kicks[0].direction += 0.15f, wide.motion.kicks[0].direction_deviation *= 2.5f;
  EXPECT_EQ(count_outside({*statistic_in(fit::check_kicks({seen}, left, missing), "kick forward: median direction")}),
            1u);
  EXPECT_EQ(
      count_outside({*statistic_in(fit::check_kicks({seen}, wide, missing), "kick forward: deviation of directions")}),
      1u);
}

TEST(CheckKicks, AWrongKickAndNaNHardlyCount) {
  const PlantedKicks planted{.kicks = 25};
  const sim::Models models = kicking_models(planted);
  fit::KickFit seen = tracked_kicks(planted, models, 1);
  seen.kicks[3].speed = 7, seen.kicks[4].speed = NAN;
  std::vector<std::string> missing;
  EXPECT_EQ(count_outside(fit::check_kicks({seen}, models, missing)), 0u);
}

TEST(CheckKicks, SlowKicksAreCutHereAndThere) {
  PlantedKicks planted{.kicks = 40};
  planted.model.partial = 0.9;
  const sim::Models models = kicking_models(planted);
  fit::KickFit seen = tracked_kicks(planted, models, 12);
  seen.slowest = 0.7;
  std::vector<std::string> missing;
  const auto statistics = fit::check_kicks({seen}, models, missing);
  EXPECT_EQ(count_outside(statistics), 0u);
  EXPECT_LT(statistics[0].events, seen.kicks.size());
}

// --- rolls and falls ---

TEST(CheckRolls, TheMedianDecelerationOfRollsWithTheirErrors) {
  sim::Models models{};
  models.ball.deceleration = 0.3f;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::vector<fit::Roll> rolls;
  for (int i = 0; i < 30; ++i) rolls.push_back({.deceleration = 0.3 + 0.03 * normal(random), .deviation = 0.03});
  rolls[4].deceleration = 3;  // a wrong one
  std::vector<std::string> missing;
  EXPECT_EQ(count_outside(fit::check_rolls(rolls, models, missing)), 0u);
  models.ball.deceleration = 0.35f;
  EXPECT_EQ(count_outside(fit::check_rolls(rolls, models, missing)), 1u);
}

sim::Models falling_ones() {
  sim::Models models{};
  models.effects.falls = true;
  models.motion.falls = {
      .per_minute_walking = 1, .per_second_touching = 0.05f, .lying = 1, .getting_up = 2.2f, .failure = 0.1f};
  return models;
}

fit::FallsSeen seen_falls(std::size_t falls) {
  fit::FallsSeen seen;
  seen.robots.push_back({.robot = "14/2", .walking = 1200, .upright = 2000});
  seen.robots[0].falls.assign(falls, {.at = 0, .walking = true, .down = {}});
  for (std::size_t i = 0; i < falls; ++i) {
    seen.phases.lying.push_back(0.97 + 0.03 * static_cast<double>(i % 3));
    seen.phases.getting_up.push_back(2.2);
  }
  seen.phases.attempts = falls, seen.phases.failures = falls / 10, seen.phases.interval = 1. / 30;
  return seen;
}

TEST(CheckFalls, TheirNumberFollowsTheTimeAtRisk) {
  std::vector<std::string> missing;
  const auto right = fit::check_falls(seen_falls(22), falling_ones(), missing);
  EXPECT_EQ(right.size(), 4u);
  EXPECT_EQ(count_outside(right), 0u);
  sim::Models models = falling_ones();
  models.motion.falls.per_minute_walking = 3;
  EXPECT_EQ(count_outside(fit::check_falls(seen_falls(22), models, missing)), 1u);
  models = falling_ones();
  models.effects.falls = false;
  EXPECT_EQ(count_outside(fit::check_falls(seen_falls(22), models, missing)), 1u);
}

TEST(CheckFalls, OfATableTheNumberIsNotChecked) {
  std::vector<std::string> missing;
  sim::Models models = falling_ones();
  models.motion.falls.table.given = true;
  const auto checked = fit::check_falls(seen_falls(22), models, missing);
  EXPECT_EQ(checked.size(), 3u);
  EXPECT_EQ(missing,
            std::vector<std::string>{
                "falls: the models have a table of falls, and a recording does not tell how hard robots collide"});
}

TEST(CheckFalls, TheDurationsAndFailuresAreChecked) {
  std::vector<std::string> missing;
  for (float sim::motion::Falls::*const part :
       {&sim::motion::Falls::lying, &sim::motion::Falls::getting_up, &sim::motion::Falls::failure}) {
    sim::Models models = falling_ones();
    models.motion.falls.*part += 0.4f;
    EXPECT_EQ(count_outside(fit::check_falls(seen_falls(22), models, missing)), 1u);
  }
}

// --- packets ---

sim::Models radio_models(float delay, float loss) {
  sim::Models models{};
  models.effects.packet_delay = models.effects.packet_loss = true;
  models.perception.radio = {.delay = delay, .loss = loss};
  return models;
}

TEST(CheckPackets, RightModelsAreInsideAndOthersAreNot) {
  std::vector<std::string> missing;
  std::size_t inside = 0;
  for (const bool ticks : {false, true})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const auto records = planted_packets({.minutes = 5, .ticks = ticks}, seed);
      const auto right = fit::check_packets(records, radio_models(0.15f, 0.25f), missing);
      EXPECT_EQ(right.size(), 2u);
      inside += count_outside(right) == 0 ? 1 : 0;
      EXPECT_EQ(count_outside({fit::check_packets(records, radio_models(0.2f, 0.25f), missing)[0]}), 1u);
      EXPECT_EQ(count_outside({fit::check_packets(records, radio_models(0.15f, 0.4f), missing)[1]}), 1u);
    }
  EXPECT_GE(inside, 7u);
}

// --- vision ---

TEST(CheckSights, RightModelsAreInsideAndOthersAreNot) {
  sim::Models models = planted_base();
  models.effects.missed_ball = models.effects.occlusion = true;
  sim::Models blind = models;
  blind.perception.ball.near = 0.6f;
  std::vector<std::string> missing;
  std::size_t inside = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const fit::Sights sights = planted_detections({}, seed);
    inside += count_outside(fit::check_sights(sights, models, missing)) == 0 ? 1 : 0;
    EXPECT_GE(count_outside(fit::check_sights(sights, blind, missing)), 2u);
  }
  EXPECT_GE(inside, 4u);
}

TEST(CheckNoise, RightModelsAreInsideAndOthersAreNot) {
  const PlantedSights planted;
  sim::Models models = planted_base();
  models.effects.ball_noise = true;
  models.perception.noise.tilt = static_cast<float>(planted.tilt);
  models.perception.noise.tilt_walking = static_cast<float>(planted.tilt_walking);
  models.perception.noise.roll = static_cast<float>(planted.roll);
  models.perception.noise.pixels = 1, models.perception.camera.pixel_angle = static_cast<float>(planted.pixels);
  models.perception.camera.height = static_cast<float>(planted.height) + models.ball.radius;
  std::vector<std::string> missing;
  std::size_t inside = 0;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const SightsOfGames games = planted_sights(planted, seed);
    const fit::BallPlaces places = fit::beside_truth(games.seen);
    const auto right = fit::check_noise(places, models, missing);
    EXPECT_EQ(right.size(), 3u);
    inside += count_outside(right) == 0 ? 1 : 0;
    sim::Models shaky = models;
    shaky.perception.noise.tilt *= 1.5f, shaky.perception.noise.roll *= 1.5f;
    const auto wrong = fit::check_noise(places, shaky, missing);
    EXPECT_EQ(count_outside({wrong[0]}) + count_outside({wrong[2]}), 2u);
    EXPECT_EQ(count_outside({wrong[1]}), 0u);
  }
  EXPECT_GE(inside, 2u);
}

TEST(CheckFalseBalls, RightModelsAreInsideAndOthersAreNot) {
  sim::Models models = planted_base();
  models.effects.false_balls = true;
  models.perception.filter.false_per_second = 0.05f;
  std::vector<std::string> missing;
  const fit::Looks looks = planted_looks({}, 1);
  EXPECT_EQ(count_outside(fit::check_false_balls(looks, models, missing)), 0u);
  models.perception.filter.false_per_second = 0.5f;
  EXPECT_EQ(count_outside(fit::check_false_balls(looks, models, missing)), 1u);
}

TEST(Checks, SayWhatTheRecordingsDoNotShow) {
  std::vector<std::string> missing;
  const sim::Models models = kicking_models({});
  EXPECT_TRUE(fit::check_walk({}, models, missing).empty());
  EXPECT_TRUE(fit::check_kicks({}, models, missing).empty());
  EXPECT_TRUE(fit::check_rolls({}, models, missing).empty());
  EXPECT_TRUE(fit::check_falls({}, models, missing).empty());
  EXPECT_TRUE(fit::check_packets({}, models, missing).empty());
  EXPECT_TRUE(fit::check_sights({}, models, missing).empty());
  EXPECT_TRUE(fit::check_noise({}, models, missing).empty());
  EXPECT_TRUE(fit::check_false_balls({}, models, missing).empty());
  for (const char* sentence :
       {"walk: speed back: expected at least 5 stretches of robots that do so for 2 s, got 0",
        "kick forward: expected at least 5 kicks in place that nobody disturbs, got 0",
        "rolling: expected at least 5 free rolls of half a second, got 0",
        "falls: expected at least 300 s of robots that walk or touch in a truth that judges falls, got 0",
        "getting up: expected at least 5 attempts in the status of robots, got 0",
        "radio: expected at least 50 packets with the times of sending and arrival, got 0",
        "radio: expected at least 50 packets in the recordings of their sender and of a mate, got 0",
        "vision: expected at least 10 passes of a ball in view at 2-4 m, got 0",
        "vision: deviation of the bearing: expected at least 40 images of a ball that lies, in 8 passes, got 0 in 0",
        "vision: expected at least 60 s of images that would show a false ball, got 0"})
    EXPECT_TRUE(is_said(missing, sentence)) << sentence;
}

}  // namespace
}  // namespace robot::tests
