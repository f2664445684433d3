#include "robot/truth/calibration/fit.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/support/ground_picture.h"

namespace robot::truth {
namespace {

/// Exact sightings of a camera with a lens, and a start some degrees and centimetres beside its pose.
struct Sighted {
  tests::GroundScene scene = tests::mast_scene();
  Projection camera{scene.intrinsics, {.k1 = -0.1}};
  std::vector<Sighting> sightings;

  Sighted() {
    for (const Landmark& landmark : landmarks_of(scene.field)) {
      const Eigen::Vector3d seen = scene.field_from_sensor.inverse() * landmark.position;
      if (camera.shows(seen)) sightings.push_back({landmark.position, camera.pixel(seen)});
    }
  }
  View start(const Projection& known) const {
    const View exact{.field_from_sensor = scene.field_from_sensor, .camera = known};
    return exact.moved((ViewStep() << 0.03, -0.02, 0.04, 0.1, -0.1, 0.05, 0, 0, 0).finished());
  }
  double error_of(const View& view) const {
    return (view.field_from_sensor.matrix() - scene.field_from_sensor.matrix()).norm();
  }
};

TEST(Fit, OfExactSightingsIsExact) {
  const Sighted sighted;
  const Prior prior{.camera = sighted.camera};
  for (const Loss loss : {Loss::squares, Loss::cauchy})
    EXPECT_LT(sighted.error_of(fit_view(sighted.start(sighted.camera), sighted.sightings, {}, prior, loss).view), 1e-6);
}

TEST(Fit, FindsTheFocalLengthAndTheDistortionThatAreFree) {
  const Sighted sighted;
  Projection known = sighted.camera;
  known.intrinsics.focal_x *= 1.08;
  known.intrinsics.focal_y *= 1.08;
  known.lens.k1 = 0;
  // the prior pulls a little: a fortieth of a deviation
  const Prior prior{.camera = known, .focal_deviation = 0.2, .k1_deviation = 0.3};
  const View view = fit_view(sighted.start(known), sighted.sightings, {}, prior, Loss::squares).view;
  EXPECT_NEAR(view.camera.intrinsics.focal_x, sighted.camera.intrinsics.focal_x, 3);
  EXPECT_NEAR(view.camera.lens.k1, -0.1, 0.01);
  EXPECT_LT(sighted.error_of(view), 0.02);
}

TEST(Fit, KeepsNumbersThatAreKnownExactly) {
  const Sighted sighted;
  const Fit fit = fit_view(sighted.start({sighted.scene.intrinsics, {}}), sighted.sightings, {},
                           {.camera = {sighted.scene.intrinsics, {}}}, Loss::squares);
  EXPECT_NEAR(fit.view.depth_scale, 1, 1e-6);
  EXPECT_NEAR(fit.view.camera.intrinsics.focal_x, sighted.scene.intrinsics.focal_x, 0.01);
  EXPECT_NEAR(fit.view.camera.lens.k1, 0, 1e-4);
}

TEST(Fit, WithCauchysLossIsPulledLittleByOneWrongClick) {
  Sighted sighted;
  sighted.sightings[3].pixel += Eigen::Vector2d(50, 30);
  const Prior prior{.camera = sighted.camera};
  const View start = sighted.start(sighted.camera);
  const double squares = sighted.error_of(fit_view(start, sighted.sightings, {}, prior, Loss::squares).view);
  const double cauchy = sighted.error_of(fit_view(start, sighted.sightings, {}, prior, Loss::cauchy).view);
  EXPECT_LT(cauchy, 0.03);
  EXPECT_GT(squares, 3 * cauchy);
}

TEST(Fit, IsAsUncertainAsItsClicks) {
  Sighted sighted;
  const Prior prior{.camera = sighted.camera};
  const View start = sighted.start(sighted.camera);
  const auto once = fit_view(start, sighted.sightings, {}, prior, Loss::squares).covariance;
  for (Sighting& sighting : sighted.sightings) sighting.deviation = 2;
  const auto twice = fit_view(start, sighted.sightings, {}, prior, Loss::squares).covariance;
  EXPECT_TRUE((4 * once.topLeftCorner<6, 6>()).isApprox(twice.topLeftCorner<6, 6>(), 1e-3));
}

TEST(Fit, IsAsFarOffAsItsCovarianceSays) {
  const Sighted sighted;
  const Prior prior{.camera = sighted.camera};
  const View start = sighted.start(sighted.camera);
  std::mt19937 random(1);
  int inside = 0;
  constexpr int kTrials = 60;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Sighting> noisy = sighted.sightings;
    for (Sighting& sighting : noisy)
      sighting.pixel += Eigen::Vector2d(tests::normal_number(random), tests::normal_number(random));
    const Fit fit = fit_view(start, noisy, {}, prior, Loss::squares);

    // the step from the fit to the truth
    const Eigen::Isometry3d &fitted = fit.view.field_from_sensor, &exact = sighted.scene.field_from_sensor;
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(fitted.linear().transpose() * exact.linear()));
    Eigen::Matrix<double, 6, 1> error;
    error << turn.angle() * turn.axis(), exact.translation() - fitted.translation();
    constexpr double kInside95 = 12.592;  // of six normal numbers
    const Eigen::Matrix<double, 6, 6> covariance = fit.covariance.topLeftCorner<6, 6>();
    inside += error.dot(covariance.inverse() * error) < kInside95 ? 1 : 0;
  }
  EXPECT_GE(inside, 53);
  EXPECT_LT(inside, kTrials);
}

TEST(Miss, IsTheDistanceInThePicture) {
  const Sighted sighted;
  const View view{.field_from_sensor = sighted.scene.field_from_sensor, .camera = sighted.camera};
  Sighting sighting = sighted.sightings[0];
  sighting.pixel += Eigen::Vector2d(3, 4);
  EXPECT_NEAR(miss_of(view, sighting), 5, 1e-9);
  sighting.place = {0, -9, 3};
  EXPECT_GT(miss_of(view, sighting), 1000) << "behind the sensor";
}

}  // namespace
}  // namespace robot::truth
