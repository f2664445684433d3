// The conversion of B-Human's messages of 2009 to ours. bhuman2009.h describes the layouts.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/sensors.pb.h"
#include "robot/core/result.h"

namespace robot::lab::bhuman2009 {

namespace pb = foresight;

/// The kind of a message: its first byte.
enum Id : std::uint8_t {
  kProcessBegin = 1,
  kProcessFinished = 2,
  kImage = 4,
  kJointData = 5,
  kSensorData = 6,
  kKeyStates = 7,
  kOdometry = 8,
  kCameraMatrix = 17,
  kImageCoordinates = 18,
};

/// Returns the size [bytes] of a payload of the kind `id`, or 0 if any size is valid. The functions below expect
/// payloads of that size.
std::size_t expected_size(std::uint8_t id);

/// Returns the value at byte `offset`, which must lie within `bytes`.
template <class T>
T at(std::string_view bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

/// The 18 numbers at the beginning of sensor data. sensors_of returns nothing if one of them is not a number.
using Sensors = std::array<float, 18>;
std::optional<Sensors> sensors_of(std::string_view payload);

/// Sets the positions. Returns false and sets nothing if an angle is not a number.
bool read_positions(std::string_view joint_data, pb::Joints& joints);

/// Sets currents and temperatures.
void read_motors(std::string_view sensor_data, pb::Joints& joints);

/// Converts inertial data. Returns nothing if the board failed: a torso angle beyond half a turn.
std::optional<pb::Inertial> inertial_of(const Sensors& sensors, std::array<float, 2> gyroscope_zero);

pb::Fsr fsr_of(const Sensors& sensors);
pb::Touch touch_of(std::string_view key_states);

/// Converts sonar data. Returns nothing without an echo on the side that sent.
std::optional<pb::Sonar> sonar_of(const Sensors& sensors, std::string_view sensor_data);

/// Converts odometry or a camera matrix. Returns nothing if a value is not a number.
std::optional<pb::Odometry> odometry_of(std::string_view payload);
std::optional<pb::CameraMatrix> matrix_of(std::string_view payload);

/// Sets the projection from the image coordinates, or from the V3's field of view if they are absent or invalid.
void set_projection(std::optional<std::string_view> image_coordinates, pb::CameraMatrix& matrix);

/// An image and its time.
struct TimedImage {
  std::uint32_t time_ms;  // of the robot's clock
  pb::Image image;
};
Result<TimedImage> image_of(std::string_view payload);

}  // namespace robot::lab::bhuman2009
