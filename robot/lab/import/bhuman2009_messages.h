// The payloads of B-Human's messages of 2009 as our messages; see bhuman2009.h for the layouts.
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

/// What a message is; its first byte.
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

/// Bytes that a payload of the kind `id` has; 0 for any number. The functions below expect payloads of that size.
std::size_t expected_size(std::uint8_t id);

/// The value at byte `offset`, which must lie within.
template <class T>
T at(std::string_view bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

/// The 18 numbers that sensor data begin with; nothing if one is not a number.
using Sensors = std::array<float, 18>;
std::optional<Sensors> sensors_of(std::string_view payload);

/// Sets the positions; false, and nothing set, if an angle is not a number.
bool read_positions(std::string_view joint_data, pb::Joints& joints);

/// Sets currents and temperatures.
void read_motors(std::string_view sensor_data, pb::Joints& joints);

/// Nothing where the board failed: a torso angle beyond half a turn.
std::optional<pb::Inertial> inertial_of(const Sensors& sensors, std::array<float, 2> gyroscope_zero);

pb::Fsr fsr_of(const Sensors& sensors);
pb::Touch touch_of(std::string_view key_states);

/// Nothing without an echo that came back to the side that sent it.
std::optional<pb::Sonar> sonar_of(const Sensors& sensors, std::string_view sensor_data);

/// Nothing if a value is not a number.
std::optional<pb::Odometry> odometry_of(std::string_view payload);
std::optional<pb::CameraMatrix> matrix_of(std::string_view payload);

/// The projection: from the image coordinates, or as the V3's field of view has it.
void set_projection(std::optional<std::string_view> image_coordinates, pb::CameraMatrix& matrix);

struct TimedImage {
  std::uint32_t time_ms;  // of the robot's clock
  pb::Image image;
};
Result<TimedImage> image_of(std::string_view payload);

}  // namespace robot::lab::bhuman2009
