#include "robot/lab/clocks/data_offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "tests/support/planted_offset.h"

namespace robot::lab {
namespace {

constexpr const char* kNotFastEnough =
    "the ball was not kicked or moved fast enough; kick it a few times or lift it three times at the start";

Result<DataOffset> found(const tests::PlantedDistances& distances, const LagRange& range = {.middle = 0, .reach = 2}) {
  return find_offset(tests::shared_distance(distances), range);
}

TEST(DataOffset, PlantedOffsetsOfBothSignsAreFoundWithinTheirError) {
  for (const double offset : {-0.7, -0.004, 0.35}) {
    const auto clock = found(tests::planted_distances({.offset = offset, .seed = 3}));
    ASSERT_TRUE(clock) << clock.error();
    EXPECT_NEAR(clock->offset, offset, 3 * clock->deviation);
    EXPECT_LT(clock->deviation, kLargestDeviation);
    EXPECT_FALSE(clock->drifts());
  }
}

TEST(DataOffset, ALargeOffsetIsFoundInALargeRange) {
  const auto clock = found(tests::planted_distances({.offset = -41.3, .seed = 4}), {.middle = 0, .reach = 60});
  ASSERT_TRUE(clock) << clock.error();
  EXPECT_NEAR(clock->offset, -41.3, 3 * clock->deviation);
}

TEST(DataOffset, AShiftOfTheRobotsTimesShiftsTheEstimateByAsMuch) {
  auto distances = tests::planted_distances({.offset = 0.1, .seed = 5});
  const auto before = found(distances);
  for (Sample& seen : distances.seen) seen.at += 0.5;
  const auto after = found(distances);
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(after->offset - before->offset, 0.5, 0.003);
}

TEST(DataOffset, AShiftOfBothSidesChangesNothing) {
  auto distances = tests::planted_distances({.offset = 0.1, .seed = 5});
  const auto before = found(distances);
  for (Series* series : {&distances.truth, &distances.seen})
    for (Sample& sample : *series) sample.at += 1000;
  const auto after = found(distances);
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(after->offset, before->offset, 0.003);
}

TEST(DataOffset, ARecordingWithoutAKickIsRefused) {
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    const auto refused = found(tests::planted_distances({.kicks = false, .offset = 0.2, .seed = seed}));
    ASSERT_FALSE(refused) << seed;
    EXPECT_EQ(refused.error(), kNotFastEnough);
  }
}

TEST(DataOffset, TooLittleDataAreRefused) {
  const auto refused = found(tests::planted_distances({.seconds = 8}));
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().starts_with("only ")) << refused.error();
  EXPECT_TRUE(refused.error().ends_with(" distances of the ball have a truth, expected 150 or more, ten a second"));
  EXPECT_FALSE(found({}));
  auto without_truth = tests::planted_distances({});
  without_truth.truth.clear();
  EXPECT_FALSE(found(without_truth));
}

TEST(DataOffset, RecordingsOfDifferentGamesAreRefused) {
  auto distances = tests::planted_distances({.seed = 1});
  distances.seen = tests::planted_distances({.seed = 2}).seen;
  EXPECT_FALSE(found(distances, {.middle = 0, .reach = 60}));
}

TEST(DataOffset, DisorderDuplicatesAndNaNChangeNothing) {
  auto distances = tests::planted_distances({.offset = 0.3, .seed = 6});
  const auto before = found(distances);
  std::mt19937 random(1);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (Series* series : {&distances.truth, &distances.seen}) {
    const Series copy(series->begin() + 10, series->begin() + 200);
    series->insert(series->end(), copy.begin(), copy.end());
    series->push_back({.at = kNan, .value = 1});
    series->push_back({.at = 20, .value = kNan});
    std::shuffle(series->begin(), series->end(), random);
  }
  const auto after = found(distances);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->offset, before->offset);
}

TEST(DataOffset, ALargerReachThanTheLongestIsCut) {
  const auto clock = found(tests::planted_distances({.offset = 0.3, .seed = 7}), {.middle = 0, .reach = 1e9});
  ASSERT_TRUE(clock) << clock.error();
  EXPECT_NEAR(clock->offset, 0.3, 0.03);
}

TEST(DataOffset, GapsOfTheTruthAndStrayTimesDoNoHarm) {
  auto distances = tests::planted_distances({.seconds = 90, .offset = 0.3, .seed = 7});
  std::erase_if(distances.truth, [](const Sample& sample) { return sample.at > 30 && sample.at < 40; });
  std::erase_if(distances.seen, [](const Sample& sample) { return sample.at > 60 && sample.at < 65; });
  for (Series* series : {&distances.truth, &distances.seen})
    for (const double stray : {-1e18, -1e9, 1e9, 1e18}) series->push_back({.at = stray, .value = 1});
  const auto clock = found(distances);
  ASSERT_TRUE(clock) << clock.error();
  EXPECT_NEAR(clock->offset, 0.3, 0.03);
}

TEST(DataOffset, ADriftIsFound) {
  const auto clock = found(tests::planted_distances({.seconds = 1200, .offset = 0.1, .drift = 100e-6, .seed = 8}));
  ASSERT_TRUE(clock) << clock.error();
  EXPECT_TRUE(clock->drifts());
  EXPECT_NEAR(clock->drift, 100e-6, 4 * clock->drift_deviation);
  EXPECT_LT(clock->drift_deviation, 20e-6);
  EXPECT_NEAR(clock->at(1000), 0.1 + 0.1, 0.02);
}

TEST(LineThrough, IsTheWeightedLineAndGrowsWithTheScatter) {
  const auto part = [](double middle, double seconds, double deviation) {
    return PartOffset{.middle = middle, .lag = {.seconds = seconds, .deviation = deviation}};
  };
  const DataOffset exact = line_through({part(0, 1, 0.01), part(100, 1.1, 0.02), part(300, 1.3, 0.01)});
  EXPECT_NEAR(exact.drift, 0.001, 1e-9);
  EXPECT_NEAR(exact.at(0), 1, 1e-9);
  const DataOffset wild = line_through({part(0, 1, 0.01), part(100, 1.5, 0.02), part(300, 1.3, 0.01)});
  EXPECT_GT(wild.deviation, 5 * exact.deviation);
  EXPECT_GT(exact.deviation_at(300), exact.deviation) << "the error of the drift grows with the time";
}

TEST(LineThrough, AnInsignificantDriftIsNotApplied) {
  const DataOffset clock{.offset = 1, .deviation = 0.01, .middle = 50, .drift = 1e-6, .drift_deviation = 1e-6};
  EXPECT_FALSE(clock.drifts());
  EXPECT_EQ(clock.at(5000), 1);
}

}  // namespace
}  // namespace robot::lab
