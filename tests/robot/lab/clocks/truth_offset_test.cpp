// The offset from the records of both sides, with and without the start gesture.
#include "robot/lab/clocks/truth_offset.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/planted_offset.h"

namespace robot::lab {
namespace {

struct Records {
  TruthRecord truth;
  RobotRecord robot{.name = "14/2", .balls = {}, .poses = {}, .sightings = {}, .ranges = {}};
};

/// Reports whether the ball lies on the field in the start gesture, 4 s after the beginning.
bool lies_there(double at) { return at < 4 || at > 9 || std::fmod(at - 4, 2) > 1; }

/// The only robot stands at the origin, the ball on the x axis. With `gesture`, the ball is lifted three times.
Records records_of(const tests::PlantedPlan& plan, bool gesture) {
  Records records;
  const auto distances = tests::planted_distances(plan);
  records.truth.robots.push_back({.name = "track 7", .path = {}});
  for (const auto& [at, far] : tidied(distances.truth)) {
    const bool seen = !gesture || lies_there(at);
    records.truth.sightings.push_back({.at = at, .seen = seen});
    if (seen) records.truth.ball.push_back({.at = at, .x = far, .y = 0});
    records.truth.robots[0].path.push_back({.at = at, .x = 0, .y = 0});
  }
  for (const Sample& sample : tidied(distances.seen)) {
    const bool seen = !gesture || lies_there(sample.at - plan.offset);
    records.robot.sightings.push_back({.at = sample.at, .seen = seen});
    if (seen) records.robot.ranges.push_back(sample);
  }
  return records;
}

TEST(OffsetFromData, IsThatOfTheBallWhereItWasKicked) {
  const auto [truth, robot] = records_of({.offset = -3.5, .seed = 3}, false);
  const auto found = offset_from_data(truth, robot, {});
  ASSERT_TRUE(found) << found.error();
  EXPECT_NEAR(found->clock.offset, -3.5, 3 * found->clock.deviation);
  EXPECT_EQ(found->by, "the ball, as track 7 of the truth (by the only robot)");
}

TEST(OffsetFromData, TheStartGestureTellsItWhereTheBallWasNotKicked) {
  for (const double offset : {-42.0, 17.25}) {
    const auto [truth, robot] = records_of({.kicks = false, .offset = offset, .seed = 3}, true);
    const auto found = offset_from_data(truth, robot, {});
    ASSERT_TRUE(found) << found.error();
    EXPECT_NEAR(found->clock.offset, offset, 0.03);
    EXPECT_EQ(found->by, "the start gesture");
    EXPECT_GE(found->clock.deviation, 0.01);
  }
}

TEST(OffsetFromData, WithoutKicksAndGestureTheReasonIsTold) {
  const auto [truth, robot] = records_of({.kicks = false, .offset = 0.2, .seed = 3}, false);
  const auto refused = offset_from_data(truth, robot, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(),
            "the ball was not kicked or moved fast enough; kick it a few times or lift it three times at the start");
}

TEST(OffsetFromData, EmptyRecordsAreRefused) {
  const auto [truth, robot] = records_of({}, false);
  EXPECT_FALSE(offset_from_data({}, robot, {}));
  EXPECT_FALSE(offset_from_data(truth, {}, {}));
  EXPECT_FALSE(offset_from_data({}, {}, {}));
}

TEST(DriftText, SaysWhetherItIsSignificant) {
  EXPECT_EQ(drift_text({}), "");
  EXPECT_EQ(drift_text({.drift = 30e-6, .drift_deviation = 1e-6}), "30.0 ppm (± 2.0 ppm)");
  EXPECT_EQ(drift_text({.drift = 1e-6, .drift_deviation = 1e-6}), "not significant: 1.0 ppm (± 2.0 ppm)");
}

TEST(ToClockOffset, ItsErrorCovers95Percent) {
  const ClockOffset offset = to_clock_offset({.offset = -0.25, .deviation = 0.01});
  EXPECT_EQ(offset.offset_ns, -250'000'000);
  EXPECT_EQ(offset.error_ns, 19'600'000u);
}

}  // namespace
}  // namespace robot::lab
