#include "robot/truth/calibration/start.h"

#include <gtest/gtest.h>

#include "tests/support/ground_picture.h"

namespace robot::truth {
namespace {

/// Sightings of a scene without noise, and its ground.
struct Exact {
  tests::GroundScene scene = tests::mast_scene();
  Projection camera{scene.intrinsics, {}};
  std::vector<Sighting> sightings;
  Ground ground{.normal = scene.field_from_sensor.linear().row(2).transpose(),
                .height = scene.field_from_sensor.translation().z()};

  Exact() {
    for (const Landmark& landmark : landmarks_of(scene.field))
      if (camera.shows(scene.field_from_sensor.inverse() * landmark.position))
        sightings.push_back({landmark.position, scene.pose().pixel(landmark.position)});
  }
  double error_of(const Result<View>& view) const {
    return view ? (view->field_from_sensor.matrix() - scene.field_from_sensor.matrix()).norm() : 1e9;
  }
};

TEST(Start, IsTheTruePoseForExactSightings) {
  const Exact exact;
  EXPECT_LT(exact.error_of(start_view(exact.sightings, exact.camera, exact.ground)), 1e-9);
  EXPECT_LT(exact.error_of(start_view(exact.sightings, exact.camera, std::nullopt)), 1e-9);
}

TEST(Start, FollowsMostSightingsWhenSomeAreWrong) {
  Exact exact;
  exact.sightings[2].pixel.x() += 90;
  exact.sightings[6].pixel.y() += 60;
  EXPECT_LT(exact.error_of(start_view(exact.sightings, exact.camera, exact.ground)), 1e-9);
  EXPECT_LT(exact.error_of(start_view(exact.sightings, exact.camera, std::nullopt)), 1e-9);
}

TEST(Start, RefusesAMirroredField) {
  Exact exact;
  for (Sighting& sighting : exact.sightings) sighting.place.y() *= -1;
  for (const auto& ground : {std::optional<Ground>(exact.ground), std::optional<Ground>()})
    EXPECT_EQ(start_view(exact.sightings, exact.camera, ground).error(),
              "the clicks fit a mirrored field: exchange the landmarks of left and right");
}

TEST(Start, RefusesSightingsAboveTheHorizon) {
  Exact exact;
  for (Sighting& sighting : exact.sightings) sighting.pixel.y() = 0;
  exact.ground.normal = Eigen::Vector3d(0, -1, 0);
  EXPECT_EQ(start_view(exact.sightings, exact.camera, exact.ground).error(),
            "no place of the sensor above the carpet fits the clicks: check each one");
}

}  // namespace
}  // namespace robot::truth
