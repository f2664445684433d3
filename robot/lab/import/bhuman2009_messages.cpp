#include "robot/lab/import/bhuman2009_messages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "robot/image/image_codec.h"

namespace robot::lab::bhuman2009 {
namespace {

static_assert(std::endian::native == std::endian::little, "the layouts are copied from the file");

constexpr double kGravity = 9.81;        // [m/s²]
constexpr float kUnloadedFsr = 0.28f;    // [kg, about] of a sensor without load
constexpr float kNoEcho = 1000;          // [mm]
constexpr std::uint32_t kMaxSide = 640;  // [px] greatest side of these cameras' images

template <class T, std::size_t Count>
std::array<T, Count> array_at(std::string_view bytes, std::size_t offset) {
  std::array<T, Count> values;
  std::memcpy(values.data(), bytes.data() + offset, sizeof(values));
  return values;
}

template <class Numbers>
bool all_finite(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](auto number) { return std::isfinite(number); });
}

/// The source of our joint `to`: our angle = sign * recorded angle `from` + offset.
struct JointMapping {
  int to, from;
  double sign, offset_deg;
};

constexpr JointMapping kJoints[] = {
    {0, 0, 1, 0},    {1, 1, -1, 0},                                                                      // head
    {2, 2, -1, 90},  {3, 3, 1, 90},    {4, 4, 1, 0},   {5, 5, 1, 0},                                     // left arm
    {7, 10, 1, 0},   {8, 11, -1, 0},   {9, 12, 1, 0},  {10, 13, 1, 0}, {11, 14, 1, 0}, {12, 15, -1, 0},  // left leg
    {13, 17, 1, 0},  {14, 18, 1, 0},   {15, 19, 1, 0}, {16, 20, 1, 0}, {17, 21, 1, 0},                   // right leg
    {18, 6, -1, 90}, {19, 7, -1, -90}, {20, 8, -1, 0}, {21, 9, -1, 0},                                   // right arm
};

template <class List>
void fill_joints(List& list) {
  list.Resize(25, 0);
}

/// Halves the width by means of neighbouring pixels: a pair of the result comes from two pairs.
std::string half_width(std::string_view yuyv) {
  std::string half(yuyv.size() / 2, '\0');
  const auto mean = [&](std::size_t a, std::size_t b) {
    return static_cast<char>((static_cast<unsigned char>(yuyv[a]) + static_cast<unsigned char>(yuyv[b]) + 1) / 2);
  };
  for (std::size_t to = 0, from = 0; to + 4 <= half.size(); to += 4, from += 8) {
    half[to] = mean(from, from + 2);
    half[to + 1] = mean(from + 1, from + 5);
    half[to + 2] = mean(from + 4, from + 6);
    half[to + 3] = mean(from + 3, from + 7);
  }
  return half;
}

}  // namespace

std::size_t expected_size(std::uint8_t id) {
  switch (id) {
    case kProcessBegin:
    case kProcessFinished: return 1;
    case kJointData: return 180;
    case kSensorData: return 146;
    case kKeyStates: return 20;
    case kOdometry: return 24;
    case kCameraMatrix: return 100;
    case kImageCoordinates: return 160;
    default: return 0;
  }
}

std::optional<Sensors> sensors_of(std::string_view payload) {
  const auto sensors = array_at<float, 18>(payload, 0);
  if (!all_finite(sensors)) return std::nullopt;
  return sensors;
}

bool read_positions(std::string_view payload, pb::Joints& joints) {
  const auto angles = array_at<double, 22>(payload, 0);
  if (!all_finite(angles)) return false;
  fill_joints(*joints.mutable_position());
  for (const auto& [to, from, sign, offset_deg] : kJoints)
    joints.set_position(
        to, static_cast<float>(sign * angles[static_cast<std::size_t>(from)] + offset_deg * std::numbers::pi / 180));
  return true;
}

void read_motors(std::string_view payload, pb::Joints& joints) {
  const auto milliamperes = array_at<std::uint16_t, 22>(payload, 72);
  const auto celsius = array_at<std::uint8_t, 22>(payload, 116);
  fill_joints(*joints.mutable_current());
  fill_joints(*joints.mutable_temperature());
  for (const auto& mapping : kJoints) {
    const auto from = static_cast<std::size_t>(mapping.from);
    joints.set_current(mapping.to, static_cast<float>(milliamperes[from]) / 1000);
    joints.set_temperature(mapping.to, celsius[from]);
  }
}

std::optional<pb::Inertial> inertial_of(const Sensors& sensors, std::array<float, 2> gyroscope_zero) {
  if (std::abs(sensors[16]) > std::numbers::pi || std::abs(sensors[17]) > std::numbers::pi) return std::nullopt;
  pb::Inertial inertial;
  inertial.set_gyroscope_x(sensors[0] - gyroscope_zero[0]);
  inertial.set_gyroscope_y(sensors[1] - gyroscope_zero[1]);
  inertial.set_accelerometer_x(static_cast<float>(-kGravity * sensors[3]));
  inertial.set_accelerometer_y(static_cast<float>(-kGravity * sensors[4]));
  inertial.set_accelerometer_z(static_cast<float>(-kGravity * sensors[5]));
  inertial.set_torso_roll(sensors[16]);
  inertial.set_torso_pitch(sensors[17]);
  return inertial;
}

pb::Fsr fsr_of(const Sensors& sensors) {
  const auto load = [&](std::size_t index) { return std::max(0.0f, sensors[7 + index] - kUnloadedFsr); };
  pb::Fsr fsr;
  fsr.set_left_front_left(load(0));
  fsr.set_left_front_right(load(1));
  fsr.set_left_rear_left(load(2));
  fsr.set_left_rear_right(load(3));
  fsr.set_right_front_left(load(4));
  fsr.set_right_front_right(load(5));
  fsr.set_right_rear_left(load(6));
  fsr.set_right_rear_right(load(7));
  return fsr;
}

std::optional<pb::Sonar> sonar_of(const Sensors& sensors, std::string_view sensor_data) {
  const auto pair = at<std::uint32_t>(sensor_data, 138);
  const float millimetres = sensors[15];
  pb::Sonar sonar;
  if (millimetres == kNoEcho || (pair != 0 && pair != 3)) return std::nullopt;
  if (pair == 0) sonar.set_left(millimetres / 1000);
  if (pair == 3) sonar.set_right(millimetres / 1000);
  return sonar;
}

pb::Touch touch_of(std::string_view payload) {
  const auto pressed = array_at<std::uint32_t, 5>(payload, 0);
  pb::Touch touch;
  touch.set_right_foot_right(pressed[0] != 0);
  touch.set_right_foot_left(pressed[1] != 0);
  touch.set_left_foot_right(pressed[2] != 0);
  touch.set_left_foot_left(pressed[3] != 0);
  touch.set_chest_button(pressed[4] != 0);
  return touch;
}

std::optional<pb::Odometry> odometry_of(std::string_view payload) {
  const auto [rotation, x, y] = array_at<double, 3>(payload, 0);
  if (!all_finite(std::array{rotation, x, y})) return std::nullopt;
  pb::Odometry odometry;
  odometry.set_x(static_cast<float>(x / 1000));
  odometry.set_y(static_cast<float>(y / 1000));
  odometry.set_heading(static_cast<float>(std::remainder(rotation, 2 * std::numbers::pi)));
  return odometry;
}

std::optional<pb::CameraMatrix> matrix_of(std::string_view payload) {
  const auto numbers = array_at<double, 12>(payload, 0);
  if (!all_finite(numbers)) return std::nullopt;
  pb::CameraMatrix matrix;
  // their camera looks along x, with y to the left and z up; ours are right = -y, down = -z, forward = x
  for (std::size_t row = 0; row < 3; ++row) {
    matrix.add_rotation(static_cast<float>(-numbers[3 + row]));
    matrix.add_rotation(static_cast<float>(-numbers[6 + row]));
    matrix.add_rotation(static_cast<float>(numbers[row]));
  }
  matrix.set_x(static_cast<float>(numbers[9] / 1000));
  matrix.set_y(static_cast<float>(numbers[10] / 1000));
  matrix.set_z(static_cast<float>(numbers[11] / 1000));
  return matrix;
}

void set_projection(std::optional<std::string_view> image_coordinates, pb::CameraMatrix& matrix) {
  const std::uint32_t width = image_coordinates ? at<std::uint32_t>(*image_coordinates, 112) : 0;
  const std::uint32_t height = image_coordinates ? at<std::uint32_t>(*image_coordinates, 116) : 0;
  std::array<double, 3> lens{};
  if (image_coordinates) lens = array_at<double, 3>(*image_coordinates, 136);
  const bool told =
      width > 0 && height > 0 && width <= kMaxSide && height <= kMaxSide && all_finite(lens) && lens[0] > 0;
  if (!told) lens = {160 / std::tan(47.8 / 2 * std::numbers::pi / 180), 160, 120};
  matrix.set_width(told ? width : 320);
  matrix.set_height(told ? height : 240);
  matrix.set_focal_x(static_cast<float>(lens[0]));
  matrix.set_focal_y(static_cast<float>(lens[0]));
  matrix.set_centre_x(static_cast<float>(lens[1]));
  matrix.set_centre_y(static_cast<float>(lens[2]));
}

Result<TimedImage> image_of(std::string_view payload) {
  if (payload.size() < 16 || at<std::uint32_t>(payload, 12) != payload.size() - 16)
    return Error{"its number of bytes is not that of the message"};
  const std::uint32_t width = at<std::uint32_t>(payload, 0), height = at<std::uint32_t>(payload, 4);
  if (width > kMaxSide || height > kMaxSide) return Error{"it is larger than 640x640"};
  Result<image::YuyvImage> decoded = image::decode_jpeg(payload.substr(16));
  if (!decoded) return decoded.failure();
  if (decoded->width != static_cast<int>(2 * width) || decoded->height != static_cast<int>(height))
    return Error{"the JPEG has another size than the message says"};

  TimedImage result{at<std::uint32_t>(payload, 8), {}};
  result.image.set_encoding(pb::Image::ENCODING_YUYV);
  result.image.set_width(width);
  result.image.set_height(height);
  result.image.set_data(half_width(decoded->yuyv));
  return result;
}

}  // namespace robot::lab::bhuman2009
