#include "robot/lab/clocks/start_gesture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace robot::lab {
namespace {

/// The ball is away in these stretches [s].
using Absences = std::vector<std::pair<double, double>>;

const Absences kThrice{{3, 3.8}, {4.9, 5.6}, {6.8, 7.9}};

/// Sightings of 30 Hz for 20 s by a clock that is ahead, with every `miss`th image missed; 0: none.
std::vector<Sighting> sightings_of(const Absences& absences, double ahead = 0, int miss = 0) {
  std::vector<Sighting> sightings;
  for (int i = 0; i < 600; ++i) {
    const double at = i / 30.0;
    bool seen = miss == 0 || i % miss != 0;
    for (const auto& [from, to] : absences) seen = seen && !(at >= from && at < to);
    sightings.push_back({.at = at + ahead, .seen = seen});
  }
  return sightings;
}

TEST(StartGesture, IsFoundWhereTheBallVanishesThrice) {
  const auto gestures = gestures_in(sightings_of(kThrice, 0, 7));
  ASSERT_EQ(gestures.size(), 1u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(gestures[0][2 * i], kThrice[i].first, 0.05);
    EXPECT_NEAR(gestures[0][2 * i + 1], kThrice[i].second, 0.05);
  }
}

TEST(StartGesture, IsNotFoundInDataWithoutOne) {
  EXPECT_TRUE(gestures_in({}).empty());
  EXPECT_TRUE(gestures_in({{.at = 1, .seen = false}}).empty());
  EXPECT_TRUE(gestures_in(sightings_of({}, 0, 3)).empty()) << "missed images";
  EXPECT_TRUE(gestures_in(sightings_of({{3, 4}, {5, 6}})).empty()) << "twice";
  EXPECT_TRUE(gestures_in(sightings_of({{3, 3.2}, {5, 5.2}, {6, 6.2}})).empty()) << "too short";
  EXPECT_TRUE(gestures_in(sightings_of({{3, 4}, {5, 10}, {11, 12}})).empty()) << "too long";
  EXPECT_TRUE(gestures_in(sightings_of({{0.5, 1}, {2, 3}, {4, 5}})).empty()) << "no calm before";
  EXPECT_TRUE(gestures_in(sightings_of({{3, 4}, {4.8, 5.6}, {6.4, 7.2}, {8, 8.8}})).empty()) << "four times";
}

TEST(StartGesture, AStreamThatFellSilentIsNoAbsence) {
  auto sightings = sightings_of({});
  std::erase_if(sightings, [](const Sighting& sighting) {
    for (const auto& [from, to] : kThrice)
      if (sighting.at >= from && sighting.at < to) return true;
    return false;
  });
  EXPECT_TRUE(gestures_in(sightings).empty());
}

TEST(StartGesture, DisorderAndNaNChangeNothing) {
  auto sightings = sightings_of(kThrice);
  std::swap(sightings[100], sightings[200]);
  sightings.push_back({.at = std::numeric_limits<double>::quiet_NaN(), .seen = true});
  EXPECT_EQ(gestures_in(sightings), gestures_in(sightings_of(kThrice)));
}

TEST(GestureLag, IsTheShiftBetweenBothSides) {
  for (const double ahead : {-47.3, 0.0, 0.4, 31.0}) {
    const auto lag = gesture_lag(gestures_in(sightings_of(kThrice)), gestures_in(sightings_of(kThrice, ahead, 5)), {});
    ASSERT_TRUE(lag) << ahead;
    EXPECT_NEAR(lag->seconds, ahead, 0.03);
    EXPECT_GE(lag->deviation, 0.01);
    EXPECT_LT(lag->deviation, 0.05);
  }
}

TEST(GestureLag, IsNotFoundOutsideOfTheRangeOrWithAnotherRhythm) {
  const auto truth = gestures_in(sightings_of(kThrice));
  EXPECT_FALSE(gesture_lag(truth, gestures_in(sightings_of(kThrice, 5)), {.middle = 0, .reach = 4}));
  EXPECT_FALSE(gesture_lag(truth, gestures_in(sightings_of({{3, 3.4}, {4.9, 5.6}, {6.8, 7.9}})), {}));
  EXPECT_FALSE(gesture_lag(truth, {}, {}));
}

TEST(GestureLag, PairsThatContradictEachOtherAreNoLag) {
  const auto once = gestures_in(sightings_of(kThrice));
  std::vector<Gesture> twice = once;
  Gesture later = once[0];
  for (double& moment : later) moment += 30;
  twice.push_back(later);
  EXPECT_FALSE(gesture_lag(once, twice, {}));
  EXPECT_TRUE(gesture_lag(once, twice, {.middle = 0, .reach = 10}));
}

}  // namespace
}  // namespace robot::lab
