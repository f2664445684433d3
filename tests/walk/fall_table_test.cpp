#include "tests/walk/fall_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "sim/io/models.h"

namespace robot::nao::walk {
namespace {

using Json = nlohmann::json;

constexpr std::array<double, kDirections> kPlanted = {2, 2.3, 2.6, 2.4, 3, 2.8, 2.5, 2.1};  // [N s]
constexpr double kPlantedSlope = 7;

double chance(double impulse, double half) { return 1 / (1 + std::pow(half / impulse, kPlantedSlope)); }

/// Returns the counts that are expected of the planted toppling.
std::vector<Pushed> planted(int trials) {
  std::vector<Pushed> all;
  for (const double impulse : {1.2, 1.8, 2.4, 3.0, 4.0}) {
    Pushed& pushed = all.emplace_back(Pushed{.impulse = impulse, .to = {}});
    for (std::size_t i = 0; i < kDirections; ++i)
      pushed.to[i] = {trials, static_cast<int>(std::lround(trials * chance(impulse, kPlanted[i])))};
  }
  return all;
}

/// Returns counts in which all robots fall from `from` [N s] on, and no others.
std::vector<Pushed> all_from(double from, int trials = 20) {
  std::vector<Pushed> all = planted(trials);
  for (Pushed& pushed : all)
    for (Trials& to : pushed.to) to.falls = pushed.impulse >= from ? to.trials : 0;
  return all;
}

TEST(FallTable, TheFitFindsThePlantedPushes) {
  const Toppling fit = fit_toppling(planted(5000));
  EXPECT_NEAR(fit.slope, kPlantedSlope, 0.1);
  for (std::size_t i = 0; i < kDirections; ++i) EXPECT_NEAR(fit.half[i], kPlanted[i], 0.02) << i;
}

TEST(FallTable, FewTrialsOfOneDirectionLeanOnTheOthers) {
  std::vector<Pushed> pushes = planted(5000);
  for (Pushed& pushed : pushes) pushed.to[3] = {0, 0};
  const Toppling fit = fit_toppling(pushes);
  double mean = 0;
  for (const double half : kPlanted) mean += std::log(half) / kDirections;
  EXPECT_NEAR(fit.half[3], std::exp(mean), 0.1);
}

TEST(FallTable, CountsWithoutAMiddleGiveNumbersBeyondTheirEnds) {
  for (const double half : fit_toppling(all_from(100)).half) EXPECT_TRUE(half > 4 && half < 50) << half;
  for (const double half : fit_toppling(all_from(0)).half) EXPECT_TRUE(half > 0.1 && half < 1.2) << half;
  for (const double half : fit_toppling(all_from(2.4)).half) EXPECT_TRUE(half > 1.8 && half < 2.4) << half;
  for (const double half : fit_toppling({}).half) EXPECT_NEAR(half, 2.4, 1e-6);
  EXPECT_NEAR(fit_toppling({}).slope, 6, 1e-6);
}

TEST(FallTable, MirroredCountsGiveAMirroredFit) {
  std::vector<Pushed> mirrored = planted(50);
  for (Pushed& pushed : mirrored)
    for (std::size_t i = 1; i < 4; ++i) std::swap(pushed.to[i], pushed.to[kDirections - i]);
  const Toppling fit = fit_toppling(planted(50)), other = fit_toppling(mirrored);
  EXPECT_NEAR(other.slope, fit.slope, 1e-6);
  for (std::size_t i = 0; i < kDirections; ++i)
    EXPECT_NEAR(other.half[i], fit.half[(kDirections - i) % kDirections], 1e-6);
}

TEST(FallTable, TheSimulatorReadsWhatIsPrinted) {
  FallCounts counts{.walks = {}, .standing = planted(40), .walking = all_from(1.8)};
  for (const char* manner : {"standing", "slow", "ahead", "fast", "sideways", "turning", "shoved_standing"})
    counts.walks.push_back({manner, 0, 20});
  counts.walks.push_back({"shoved_walking", 3, 20});
  counts.alone = {1, 4, 0};
  counts.lying = 1.5;
  counts.risen = {{{40, 38, 8.6}, {40, 30, 13.5}, {80, 70, 10}}};
  const std::string table = fall_table({.walk = "./libtheirs.so", .robots = 40}, {counts, counts});
  const auto models = sim::io::parse_models(
      R"({"name": "mine", "based_on": "match", "falls": {"table": )" + table + "}}", "models 'mine'");
  ASSERT_TRUE(models) << models.error();
  const sim::motion::FallTable& read = models->motion.falls.table;
  EXPECT_NEAR(read.soft.rates.shoved_walking, 3. / 20, 1e-4);
  const Toppling fit = fit_toppling(counts.standing);
  EXPECT_NEAR(read.stiff.standing.slope, fit.slope, 1e-2);
  for (std::size_t i = 0; i < kDirections; ++i) EXPECT_NEAR(read.stiff.standing.half[i], fit.half[i], 1e-3);
  EXPECT_NEAR(read.alone.front, 8.5 / 11.5, 1e-3) << "of both classes, and half a fall more to each side";
  EXPECT_NEAR(read.alone.back, 2.5 / 11.5, 1e-3);
  const sim::motion::GettingUp& up = read.soft.getting_up;
  EXPECT_EQ(up.lying, 1.5f);
  EXPECT_EQ(up.seconds(sim::Lying::on_back), 8.6f);
  EXPECT_EQ(up.seconds(sim::Lying::on_front), 13.5f);
  EXPECT_EQ(up.seconds(sim::Lying::on_right), 10);
  EXPECT_NEAR(up.failure(sim::Lying::on_back), 2.5 / 41, 1e-4);
  EXPECT_NEAR(up.failure(sim::Lying::on_front), 10.5 / 41, 1e-4);
  EXPECT_NEAR(up.failure(sim::Lying::on_left), 10.5 / 81, 1e-4);
}

TEST(FallTable, AWalkThatGivesNoGaitHasNone) {
  const Tested none{.stand = stand(), .hip_height = 0.2, .begin = [] { return std::unique_ptr<Gait>(); }};
  const auto counted = count_falls(none, Servos::stiff, 1, 1);
  ASSERT_FALSE(counted);
  EXPECT_EQ(counted.error(), "expected a walk from foresight_walk_begin, got none");
}

/// Targets that no robot stands with: both knees fold up.
class Collapse final : public Gait {
 public:
  Legs tick(const Sensors&, const Command&, double) override {
    Legs legs = stand();
    for (auto& leg : legs) leg[2] = -1.5, leg[3] = 2, leg[4] = 0.9;
    return legs;
  }
  bool steps() const override { return false; }
};

TEST(FallTable, RobotsThatFallBeforeTheirPushProveNothing) {
  const Tested falls{.stand = stand(), .hip_height = 0.2, .begin = [] { return std::make_unique<Collapse>(); }};
  int seen = 0;
  EXPECT_TRUE(play(pushes(1.2, {}), falls, Servos::stiff, 1, 1, [&](const Outcome&, const Plan&, int) { ++seen; }));
  EXPECT_EQ(seen, 0);
  const auto counted = count_falls(falls, Servos::stiff, 1, 1);
  ASSERT_FALSE(counted);
  EXPECT_EQ(counted.error(), "expected robots on their feet until they are pushed, got none while shoved_standing");
}

TEST(FallTable, ShovesComeFromEachOfEightDirectionsWithEachStep) {
  const Case shoved = shoves({});
  ASSERT_EQ(shoved.repetitions, kDirections);
  for (int direction = 0; direction < kDirections; ++direction) {
    const Plan plan = shoved.plan(3, direction);
    EXPECT_GE(plan.pushes.size(), 28u);
    EXPECT_GE(plan.pushes.front().time, kShoved);
    for (const Push& push : plan.pushes) EXPECT_NEAR(push.direction, direction * std::numbers::pi / 4, 1e-9);
  }
}

TEST(FallTable, AnotherParameterIsAnotherWalk) {
  Parameters other;
  other.period += 1e-9;
  EXPECT_NE(hash_of(other), hash_of({}));
  EXPECT_EQ(hash_of({}), hash_of({}));
  Parameters kicks;
  kicks.kick_ahead += 0.01;
  EXPECT_EQ(hash_of(kicks), hash_of({})) << "no trial of the table kicks";
}

Json embedded() { return Json::parse(std::ifstream(FALLS "/foresight.json")); }

TEST(EmbeddedFalls, AreThoseOfTheWalkAsItIs) {
  EXPECT_EQ(embedded()["made_by"]["parameters"], hash_of({}))
      << "the walk has other numbers now: bench_walk falls 970000 40 > sim/data/falls/foresight.json, and the "
         "signature";
  EXPECT_EQ(embedded()["made_by"]["getting_up"], hash_of_getting_up()) << "getting up has other key frames: likewise";
}

TEST(EmbeddedFalls, FollowFromTheirCounts) {
  const Json table = embedded();
  const Json& alone = table["counts"]["alone"];
  const int falls = alone["back"].get<int>() + alone["front"].get<int>() + alone["side"].get<int>();
  for (const char* side : {"front", "back"})
    EXPECT_NEAR(table["alone"][side]["value"].get<double>(), share_of(alone[side], falls), 1e-3) << side;
  constexpr const char* kNames[] = {"front", "front_left", "left",  "back_left",
                                    "back",  "back_right", "right", "front_right"};
  for (const std::string servos : {"stiff", "soft"}) {
    for (const auto& [manner, counted] : table["counts"][servos + "_rates"].items())
      EXPECT_NEAR(table[servos + "_rates"][manner]["value"].get<double>(),
                  counted["falls"].get<double>() / counted["minutes"].get<double>(), 1e-3)
          << manner;
    for (const std::string state : {"_standing", "_walking"}) {
      std::vector<Pushed> pushes;
      for (const Json& row : table["counts"][servos + state]) {
        Pushed& pushed = pushes.emplace_back(Pushed{.impulse = row["impulse"], .to = {}});
        for (std::size_t i = 0; i < kDirections; ++i) pushed.to[i] = {row["trials"][i], row["falls"][i]};
      }
      const Toppling fit = fit_toppling(pushes);
      EXPECT_NEAR(table[servos + state]["slope"].get<double>(), fit.slope, 1e-2);
      for (std::size_t i = 0; i < kDirections; ++i)
        EXPECT_NEAR(table[servos + state][kNames[i]]["value"].get<double>(), fit.half[i], 1e-3) << kNames[i];
    }
    for (const std::string side : kDownOn) {
      const Json& counted = table["counts"][servos + "_getting_up"][side];
      EXPECT_NEAR(table[servos + "_getting_up"][side + "_failure"]["value"].get<double>(),
                  failure_of({counted["robots"], counted["first"], 0}), 1e-3)
          << side;
    }
  }
}

}  // namespace
}  // namespace robot::nao::walk
