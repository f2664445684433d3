// Poses of the parts from the joints: laws of the geometry, and a real robot's cameras.
#include "robot/nao/model/kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/sensors.pb.h"
#include "robot/core/files.h"
#include "robot/lab/import/bhuman2009.h"
#include "robot/nao/guardian/key_frames.h"
#include "tests/support/real_data.h"
#include "tests/support/recording_sink.h"

namespace robot::nao {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;

PerJoint<float> random_joints(std::mt19937& random) {
  PerJoint<float> joints;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const Range range = limits_of(joint).range;
    joints[joint] = std::uniform_real_distribution<float>(range.low, range.high)(random);
  }
  return joints;
}

/// Returns the mirror image between left and right.
PerJoint<float> mirrored(const PerJoint<float>& p) {
  PerJoint<float> m = p;
  m[head_yaw] = -p[head_yaw];
  m[l_hip_roll] = -p[r_hip_roll];
  m[r_hip_roll] = -p[l_hip_roll];
  m[l_ankle_roll] = -p[r_ankle_roll];
  m[r_ankle_roll] = -p[l_ankle_roll];
  for (const auto& [left, right] :
       {std::pair{l_hip_pitch, r_hip_pitch}, {l_knee_pitch, r_knee_pitch}, {l_ankle_pitch, r_ankle_pitch}}) {
    m[left] = p[right];
    m[right] = p[left];
  }
  return m;
}

TEST(NaoKinematics, OfStraightLegsIsTheSumOfTheLengths) {
  const Kinematics kinematics;
  const Vector3d left = kinematics.hip_from_sole({}, Side::left).translation();
  EXPECT_TRUE(left.isApprox(Vector3d(0, 0.05, -(0.1 + 0.1029 + 0.04519)), 1e-9));
  const Transform camera = kinematics.robot_from_hip({}, 0, 0) * kinematics.hip_from_camera({}, Camera::top);
  EXPECT_NEAR(camera.translation().z(), 0.24809 + 0.2115 + 0.06364, 1e-9);
  EXPECT_NEAR(camera.translation().x(), 0.05871, 1e-9);
  // the camera looks forward, 1.2 degrees down
  EXPECT_NEAR(camera.linear()(2, 2), -std::sin(1.2 * kDegree), 1e-5);
  EXPECT_NEAR(camera.linear()(0, 2), std::cos(1.2 * kDegree), 1e-5);
}

TEST(NaoKinematics, IsTheSameInAMirror) {
  std::mt19937 random(1);
  const Kinematics kinematics;
  const Vector3d mirror(1, -1, 1);
  for (int i = 0; i < 300; ++i) {
    const PerJoint<float> joints = random_joints(random);
    const Vector3d left = kinematics.hip_from_sole(joints, Side::left).translation();
    const Vector3d right = kinematics.hip_from_sole(mirrored(joints), Side::right).translation();
    EXPECT_TRUE(left.isApprox(mirror.cwiseProduct(right), 1e-6)) << left.transpose() << " / " << right.transpose();
    const Vector3d camera = kinematics.hip_from_camera(joints, Camera::bottom).translation();
    const Vector3d other = kinematics.hip_from_camera(mirrored(joints), Camera::bottom).translation();
    EXPECT_TRUE(camera.isApprox(mirror.cwiseProduct(other), 1e-6));
  }
}

TEST(NaoKinematics, StandsOnItsLowerFoot) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> lean(-0.5, 0.5);
  const Kinematics kinematics;
  for (int i = 0; i < 300; ++i) {
    const PerJoint<float> joints = random_joints(random);
    const double roll = lean(random), pitch = lean(random);
    const Transform robot = kinematics.robot_from_hip(joints, roll, pitch);
    const Vector3d left = (robot * kinematics.hip_from_sole(joints, Side::left)).translation();
    const Vector3d right = (robot * kinematics.hip_from_sole(joints, Side::right)).translation();
    EXPECT_NEAR(std::min(left.z(), right.z()), 0, 1e-9);
    EXPECT_NEAR((left + right).head<2>().norm(), 0, 1e-9) << "the origin is between the feet";
    EXPECT_EQ(kinematics.support_foot(joints, roll, pitch), left.z() <= right.z() ? Side::left : Side::right);
  }
}

TEST(NaoKinematics, FindsTheLeanFromAFlatFoot) {
  const Kinematics kinematics;
  PerJoint<float> joints = stand_pose().position;
  EXPECT_NEAR(kinematics.lean_on(joints, Side::left).pitch, 0, 1e-6) << "the stand is upright";
  joints[l_ankle_pitch] += 0.1f;  // the toes go down; with the foot flat, the torso leans back
  joints[r_ankle_roll] += 0.05f;
  EXPECT_NEAR(kinematics.lean_on(joints, Side::left).pitch, -0.1, 1e-6);
  EXPECT_NEAR(kinematics.lean_on(joints, Side::right).roll, -0.05, 1e-6);
  // and with that lean the sole is flat
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    joints = random_joints(random);
    const auto lean = kinematics.lean_on(joints, Side::left);
    const Transform robot = kinematics.robot_from_hip(joints, lean.roll, lean.pitch);
    EXPECT_NEAR((robot.linear() * kinematics.hip_from_sole(joints, Side::left).linear() * Vector3d::UnitZ()).z(), 1,
                1e-6);
  }
}

TEST(NaoKinematics, ALeanForwardLowersTheView) {
  const Kinematics kinematics;
  const PerJoint<float> joints = stand_pose().position;
  const auto down = [&](double roll, double pitch) {
    return -std::asin((kinematics.robot_from_hip(joints, roll, pitch) * kinematics.hip_from_camera(joints, Camera::top))
                          .linear()(2, 2));
  };
  EXPECT_NEAR(down(0, 0.1) - down(0, 0), 0.1, 1e-6);
  // with a lean to the right, a point to the right of the camera's axis moves down
  EXPECT_LT(kinematics.robot_from_hip(joints, 0.1, 0).linear()(2, 1), 0.2);
  EXPECT_GT((kinematics.robot_from_hip(joints, 0.1, 0) * Vector3d(0, 1, 0)).z(),
            (kinematics.robot_from_hip(joints, 0.1, 0) * Vector3d(0, -1, 0)).z());
}

TEST(NaoKinematics, CalibrationTurnsCamerasAndBodyByItsAngles) {
  Calibration calibration;
  calibration.top.tilt = 0.02;
  calibration.bottom.roll = 0.03;
  calibration.body_pitch = 0.04;
  const Kinematics plan, own(calibration);
  const auto down = [](const Transform& t) { return -std::asin(t.linear()(2, 2)); };
  EXPECT_NEAR(down(own.hip_from_camera({}, Camera::top)) - down(plan.hip_from_camera({}, Camera::top)), 0.02, 1e-9);
  EXPECT_NEAR(down(own.hip_from_camera({}, Camera::bottom)), down(plan.hip_from_camera({}, Camera::bottom)), 1e-9);
  EXPECT_NEAR(std::asin((own.hip_from_camera({}, Camera::bottom).linear().col(0)).dot(Vector3d(0, 0, -1)) /
                        std::cos(down(own.hip_from_camera({}, Camera::bottom)))),
              0.03, 1e-6)
      << "the image's right side goes down";
  EXPECT_TRUE(own.robot_from_hip({}, 0, 0).isApprox(plan.robot_from_hip({}, 0, 0.04), 1e-9));
}

TEST(NaoKinematics, TheHeadTurnsBackToWhereACameraLooks) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> distance(0.3, 9), offset(-0.05, 0.05);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    PerJoint<float> joints = random_joints(random);
    Calibration calibration;
    if (i % 2)
      calibration = {.top = {offset(random), offset(random), offset(random)},
                     .bottom = {0, offset(random), offset(random)}};
    const Kinematics kinematics(calibration);
    for (const Camera camera : {Camera::top, Camera::bottom}) {
      const Vector3d seen = kinematics.hip_from_camera(joints, camera) * Vector3d(0, 0, distance(random));
      const auto head = kinematics.look_at(seen, camera);
      // for a point straight above the neck every yaw is right
      if (std::hypot(seen.x(), seen.y()) < 0.1) continue;
      worst = std::max({worst, std::abs(std::remainder(head.yaw - joints[head_yaw], 2 * std::numbers::pi)),
                        std::abs(head.pitch - joints[head_pitch])});
    }
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(NaoKinematics, LooksAtANearPointAsWellAsPossible) {
  for (const Vector3d& point : {Vector3d(0, 0, 0.2115), Vector3d(0.01, 0, 0.22), Vector3d(0, 0, 0)}) {
    const auto head = Kinematics().look_at(point, Camera::top);
    EXPECT_TRUE(std::isfinite(head.yaw) && std::isfinite(head.pitch)) << point.transpose();
  }
}

/// One sample of the recording of 2009.
struct BodySample {
  double time_s;
  PerJoint<float> joints;
  double roll, pitch;
};

struct Offset {
  double height, tilt;  // [m], [rad] medians of the absolute errors
};

TEST(NaoKinematics, MatchesTheCameraMatricesOfARealRobot) {
  REAL_DATA_OR_SKIP(path, "bhuman2009/logfile.log");
  tests::RecordingSink sink;
  ASSERT_TRUE(lab::import_bhuman2009(*read_file(path, 10'000'000), 0, sink));
  std::vector<BodySample> samples;
  std::vector<std::pair<double, const foresight::CameraMatrix*>> matrices;
  for (const auto& entry : sink.entries) {
    const double time_s = static_cast<double>(entry.capture_ns) * 1e-9;
    if (const auto* matrix = dynamic_cast<const foresight::CameraMatrix*>(entry.value.get()))
      matrices.emplace_back(time_s, matrix);
    if (const auto* joints = dynamic_cast<const foresight::Joints*>(entry.value.get())) {
      samples.push_back({.time_s = time_s});
      for (std::size_t joint = 0; joint < kJoints; ++joint)
        samples.back().joints[joint] = joints->position(static_cast<int>(joint));
    }
    if (const auto* inertial = dynamic_cast<const foresight::Inertial*>(entry.value.get());
        inertial && !samples.empty()) {
      samples.back().roll = inertial->torso_roll();
      samples.back().pitch = inertial->torso_pitch();
    }
  }
  ASSERT_EQ(matrices.size(), 160u);

  // the lower camera of a Nao V3
  Dimensions v3;
  v3.bottom = {.x = 0.0488, .z = 0.02381, .tilt = 40 * kDegree};
  const auto median = [](std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  };
  // joints were recorded at 8 Hz, so those at the image's time are interpolated
  const auto at = [&](double time_s) {
    std::size_t i = 0;
    while (i + 2 < samples.size() && samples[i + 1].time_s <= time_s) ++i;
    const BodySample &from = samples[i], &to = samples[i + 1];
    const double part = std::clamp((time_s - from.time_s) / (to.time_s - from.time_s), 0.0, 1.0);
    BodySample sample = from;
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      sample.joints[joint] += static_cast<float>(part) * (to.joints[joint] - from.joints[joint]);
    sample.roll += part * (to.roll - from.roll);
    sample.pitch += part * (to.pitch - from.pitch);
    return sample;
  };
  // the lean comes from the inertial unit or from a flat support foot; one angle calibrates the mounting
  const auto judge = [&](bool by_foot) {
    Calibration calibration;
    std::vector<double> heights, tilts;
    for (int pass = 0; pass < 2; ++pass) {
      const Kinematics kinematics(calibration, v3);
      heights.clear();
      tilts.clear();
      for (const auto& [time_s, matrix] : matrices) {
        BodySample sample = at(time_s);
        if (by_foot) {
          const auto lean =
              kinematics.lean_on(sample.joints, kinematics.support_foot(sample.joints, sample.roll, sample.pitch));
          sample.roll = lean.roll;
          sample.pitch = lean.pitch;
        }
        const Transform camera = kinematics.robot_from_hip(sample.joints, sample.roll, sample.pitch) *
                                 kinematics.hip_from_camera(sample.joints, Camera::bottom);
        heights.push_back(camera.translation().z() - matrix->z());
        tilts.push_back(std::asin(matrix->rotation(8)) - std::asin(camera.linear()(2, 2)));
      }
      if (pass == 0) calibration.body_pitch = -median(tilts);
    }
    for (double& height : heights) height = std::abs(height);
    for (double& tilt : tilts) tilt = std::abs(tilt);
    return Offset{median(heights), median(tilts)};
  };
  const Offset by_foot = judge(true), by_inertial = judge(false);
  RecordProperty("height_mm_by_foot", std::to_string(by_foot.height * 1000));
  RecordProperty("tilt_deg_by_foot", std::to_string(by_foot.tilt / kDegree));
  RecordProperty("tilt_deg_by_inertial", std::to_string(by_inertial.tilt / kDegree));
  EXPECT_LT(by_foot.height, 0.010);
  EXPECT_LT(by_foot.tilt, 1 * kDegree);
  EXPECT_LT(by_inertial.height, 0.010);
  // the raw angles are noisier than the filtered ones behind the recorded matrices
  EXPECT_LT(by_inertial.tilt, 1.2 * kDegree);
}

}  // namespace
}  // namespace robot::nao
