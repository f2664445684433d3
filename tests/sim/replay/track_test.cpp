#include "sim/replay/track.h"

#include <gtest/gtest.h>

namespace sim::replay {
namespace {

TEST(Track, HasExactlyTheRecordedPlacesAtTheirTicks) {
  const Track track({{10, {1, 2}, 0.5f, true}, {13, {1.3f, 2}, 0.8f, false}});
  const auto place = track.at(10);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->position, (Vec2{1, 2}));
  EXPECT_EQ(place->heading, 0.5f);
  EXPECT_TRUE(place->fallen);
  EXPECT_FALSE(place->held);
  EXPECT_EQ(track.at(13)->position, (Vec2{1.3f, 2}));
}

TEST(Track, ShortGapsAreInterpolated) {
  const Track track({{0, {0, 0}, 3.f}, {kBridged, {3, 0}, -3.f}});
  const auto place = track.at(kBridged / 3);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->position.x, 1, 1e-5f);
  EXPECT_GT(place->heading, 3.f) << "the short way round, over pi";
  EXPECT_FALSE(place->held);
}

TEST(Track, AtALongGapItStandsStillForASecondAndIsAbsentThen) {
  const Track track({{0, {1, 0}, 0.f}, {200, {3, 0}, 0.f}});
  for (const Tick tick : {1u, 15u, 30u}) {
    ASSERT_TRUE(track.at(tick)) << tick;
    EXPECT_EQ(track.at(tick)->position, (Vec2{1, 0}));
    EXPECT_TRUE(track.at(tick)->held);
  }
  EXPECT_FALSE(track.at(31));
  EXPECT_FALSE(track.at(199));
  EXPECT_FALSE(track.at(200)->held);
  EXPECT_FALSE(track.at(231)) << "behind the last data";
}

TEST(Track, IsAbsentBeforeItsFirstData) {
  EXPECT_FALSE(Track({{10, {1, 2}, 0.f}}).at(9));
  EXPECT_FALSE(Track().at(0));
}

TEST(Track, AnUnknownHeadingIsTheDirectionOfTheWalkAndStaysWhileTheRobotStands) {
  std::vector<Sample> samples;
  for (Tick tick = 0; tick < 60; ++tick) samples.push_back({tick, {0, 0.01f * static_cast<float>(tick)}, {}});
  for (Tick tick = 60; tick < 120; ++tick) samples.push_back({tick, {0, 0.6f}, {}});
  const Track track(samples);
  EXPECT_NEAR(track.at(30)->heading, 1.5708f, 1e-3f);
  EXPECT_NEAR(track.at(110)->heading, 1.5708f, 1e-3f);
}

TEST(Track, ItsVelocityIsThatBetweenTheSamples) {
  const Track track({{0, {0, 0}, {}}, {15, {1, -1}, {}}, {100, {5, 5}, {}}});
  EXPECT_NEAR(track.velocity_at(7).x, 2, 1e-4f);
  EXPECT_NEAR(track.velocity_at(7).y, -2, 1e-4f);
  EXPECT_EQ(track.velocity_at(50), (Vec2{})) << "a gap";
  EXPECT_EQ(track.velocity_at(100), (Vec2{}));
}

}  // namespace
}  // namespace sim::replay
