#include "robot/app/truth/sensor_messages.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "robot/core/clock.h"
#include "robot/core/text.h"

namespace robot::app {
namespace {

constexpr int kPoseErrors = 7;                                       // of truth::SensorPose::covariance
constexpr int kUpperTriangle = kPoseErrors * (kPoseErrors + 1) / 2;  // numbers

static_assert(std::endian::native == std::endian::little, "images are sent as they lie in memory");

void begin_image(const truth::DepthFrame& frame, const std::string& frame_id, ::foxglove::RawImage& message) {
  message.Clear();
  message.mutable_timestamp()->set_seconds(static_cast<std::int64_t>(frame.capture_ns / kSecond));
  message.mutable_timestamp()->set_nanos(static_cast<std::int32_t>(frame.capture_ns % kSecond));
  message.set_width(static_cast<std::uint32_t>(frame.intrinsics.width));
  message.set_height(static_cast<std::uint32_t>(frame.intrinsics.height));
  message.set_frame_id(frame_id);
}

Eigen::Matrix2d covariance_of(const pb::GroundTruth::Covariance& message) {
  return Eigen::Matrix2d{{double{message.xx()}, double{message.xy()}}, {double{message.xy()}, double{message.yy()}}};
}

truth::Intrinsics intrinsics_of(const pb::TruthSensor::Pinhole& message) {
  return {.width = static_cast<int>(message.width()),
          .height = static_cast<int>(message.height()),
          .focal_x = double{message.focal_x()},
          .focal_y = double{message.focal_y()},
          .centre_x = double{message.centre_x()},
          .centre_y = double{message.centre_y()}};
}

/// Converts depths of any unit to millimetres.
void in_millimetres(const truth::DepthFrame& frame, std::uint16_t* depths) {
  const double scale = 1000 * frame.unit;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const long millimetres = std::lround(scale * frame.depth[i]);
    depths[i] = millimetres <= 65535 ? static_cast<std::uint16_t>(millimetres) : std::uint16_t{0};
  }
}

}  // namespace

void to_proto(const truth::DepthFrame& frame, const std::string& frame_id, ::foxglove::RawImage& message) {
  begin_image(frame, frame_id, message);
  message.set_encoding("16UC1");
  message.set_step(2 * static_cast<std::uint32_t>(frame.intrinsics.width));
  std::string& data = *message.mutable_data();
  if (frame.unit == 0.001) {
    data.assign(reinterpret_cast<const char*>(frame.depth.data()), 2 * frame.depth.size());
    return;
  }
  std::vector<std::uint16_t> depths(frame.depth.size());
  in_millimetres(frame, depths.data());
  data.assign(reinterpret_cast<const char*>(depths.data()), 2 * depths.size());
}

bool colour_to_proto(const truth::DepthFrame& frame, const std::string& frame_id, ::foxglove::RawImage& message) {
  if (frame.rgb.empty()) return false;
  begin_image(frame, frame_id, message);
  message.set_encoding("rgb8");
  message.set_step(3 * static_cast<std::uint32_t>(frame.intrinsics.width));
  message.mutable_data()->assign(reinterpret_cast<const char*>(frame.rgb.data()), frame.rgb.size());
  return true;
}

void to_proto(const truth::Intrinsics& intrinsics, pb::TruthSensor::Pinhole& message) {
  message.set_width(static_cast<std::uint32_t>(intrinsics.width));
  message.set_height(static_cast<std::uint32_t>(intrinsics.height));
  message.set_focal_x(static_cast<float>(intrinsics.focal_x));
  message.set_focal_y(static_cast<float>(intrinsics.focal_y));
  message.set_centre_x(static_cast<float>(intrinsics.centre_x));
  message.set_centre_y(static_cast<float>(intrinsics.centre_y));
}

void to_proto(const truth::SensorPose& pose, pb::TruthSensor::SensorPlace& message) {
  message.Clear();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      message.add_rotation(static_cast<float>(pose.field_from_sensor.linear()(row, column)));
  message.set_x(static_cast<float>(pose.field_from_sensor.translation().x()));
  message.set_y(static_cast<float>(pose.field_from_sensor.translation().y()));
  message.set_z(static_cast<float>(pose.field_from_sensor.translation().z()));
  message.set_depth_scale(static_cast<float>(pose.depth_scale));
  if (pose.covariance.isZero(0)) return;
  for (int row = 0; row < kPoseErrors; ++row)
    for (int column = row; column < kPoseErrors; ++column)
      message.add_covariance(static_cast<float>(pose.covariance(row, column)));
}

void to_proto(const truth::tags::RefusedTags& refused, pb::TruthSensor::RefusedTags& message) {
  message.set_unknown(refused.unknown);
  message.set_repeated(refused.repeated);
  message.set_implausible(refused.implausible);
  message.set_contradictory(refused.contradictory);
}

void to_proto(const Eigen::Matrix2d& covariance, pb::GroundTruth::Covariance& message) {
  message.set_xx(static_cast<float>(covariance(0, 0)));
  message.set_xy(static_cast<float>(covariance(0, 1)));
  message.set_yy(static_cast<float>(covariance(1, 1)));
}

void to_proto(const truth::Detections& detections, pb::TruthSensor& message) {
  message.clear_robots();
  message.clear_ball();
  for (const truth::SeenRobot& robot : detections.robots) {
    pb::GroundTruth::TrueRobot& seen = *message.add_robots();
    seen.set_x(static_cast<float>(robot.place.position.x()));
    seen.set_y(static_cast<float>(robot.place.position.y()));
    to_proto(robot.place.covariance, *seen.mutable_covariance());
    if (robot.heading) seen.set_heading(static_cast<float>(*robot.heading));
    if (robot.heading_deviation) seen.set_heading_deviation(static_cast<float>(*robot.heading_deviation));
    if (robot.team) seen.set_team(*robot.team);
    if (robot.player) seen.set_player(*robot.player);
    if (robot.height > 0) seen.set_height(static_cast<float>(robot.height));
    seen.set_sensors(1);
  }
  if (!detections.ball) return;
  message.mutable_ball()->set_x(static_cast<float>(detections.ball->place.position.x()));
  message.mutable_ball()->set_y(static_cast<float>(detections.ball->place.position.y()));
  to_proto(detections.ball->place.covariance, *message.mutable_ball()->mutable_covariance());
  message.mutable_ball()->set_sensors(1);
}

truth::Detections detections_of(const pb::TruthSensor& message, std::uint64_t capture_ns) {
  truth::Detections detections{.capture_ns = capture_ns};
  for (const pb::GroundTruth::TrueRobot& robot : message.robots()) {
    truth::SeenRobot& seen = detections.robots.emplace_back();
    seen.place = {.position = {robot.x(), robot.y()}, .covariance = covariance_of(robot.covariance())};
    seen.height = robot.height();
    if (robot.has_heading()) seen.heading = robot.heading();
    if (robot.has_heading_deviation()) seen.heading_deviation = robot.heading_deviation();
    if (robot.has_team()) seen.team = robot.team();
    if (robot.has_player()) seen.player = robot.player();
  }
  if (message.has_ball())
    detections.ball = truth::SeenBall{.place = {.position = {message.ball().x(), message.ball().y()},
                                                .covariance = covariance_of(message.ball().covariance())}};
  return detections;
}

Result<truth::SensorPose> pose_of(const pb::TruthSensor& message) {
  const pb::TruthSensor::SensorPlace& place = message.place();
  if (place.rotation_size() != 9)
    return Error{formatted("its place has a rotation of %d numbers, expected 9", place.rotation_size())};
  if (place.covariance_size() != 0 && place.covariance_size() != kUpperTriangle)
    return Error{formatted("its place has a covariance of %d numbers, expected %d or none", place.covariance_size(),
                           kUpperTriangle)};
  truth::SensorPose pose{.intrinsics = intrinsics_of(message.pinhole()), .depth_scale = double{place.depth_scale()}};
  Eigen::Matrix3d rotation;
  for (int i = 0; i < 9; ++i) rotation(i / 3, i % 3) = double{place.rotation(i)};
  pose.field_from_sensor.linear() = rotation;
  pose.field_from_sensor.translation() = Eigen::Vector3d(place.x(), place.y(), place.z());
  int next = 0;
  for (int row = 0; row < kPoseErrors && place.covariance_size() > 0; ++row)
    for (int column = row; column < kPoseErrors; ++column)
      pose.covariance(row, column) = pose.covariance(column, row) = double{place.covariance(next++)};
  const bool turns = rotation.isUnitary(1e-4) && rotation.determinant() > 0;
  if (!turns || !pose.field_from_sensor.matrix().allFinite() || !pose.covariance.allFinite())
    return Error{"its place is no pose"};
  return pose;
}

}  // namespace robot::app
