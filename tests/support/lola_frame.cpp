#include "tests/support/lola_frame.h"

#include <bit>

namespace tests {

LolaFrame& LolaFrame::bytes(std::string_view bytes) {
  bytes_ += bytes;
  return *this;
}

LolaFrame& LolaFrame::key(std::string_view name) {
  ++keys_;
  return text(name);
}

LolaFrame& LolaFrame::array(std::size_t count) {
  if (count < 16) {
    bytes_ += static_cast<char>(0x90 | count);
  } else {
    bytes_ += '\xdc';
    bytes_ += static_cast<char>(count >> 8);
    bytes_ += static_cast<char>(count & 0xff);
  }
  return *this;
}

LolaFrame& LolaFrame::text(std::string_view text) {
  bytes_ += static_cast<char>(0xa0 | text.size());
  return bytes(text);
}

LolaFrame& LolaFrame::floating(float number) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  bytes_ += '\xca';
  for (int shift = 24; shift >= 0; shift -= 8) bytes_ += static_cast<char>(bits >> shift & 0xff);
  return *this;
}

LolaFrame& LolaFrame::floats(std::string_view name, const std::vector<float>& numbers) {
  key(name).array(numbers.size());
  for (const float number : numbers) floating(number);
  return *this;
}

LolaFrame& LolaFrame::identity() {
  return key("RobotConfig")
      .array(4)
      .text("P0000073A03S83I00011")
      .text("6.0.0")
      .text("P0000074A03S84F00006")
      .text("6.0.0");
}

std::string LolaFrame::frame() const { return static_cast<char>(0x80 | keys_) + bytes_; }

std::string lola_frame(robot::nao::Sensors sensors) {
  LolaFrame frame;
  frame.identity();
  const auto put = [&](std::string_view wanted) {
    sensors.visit([&](std::string_view key, const auto& numbers) {
      if (key == wanted) frame.floats(key, {numbers.begin(), numbers.end()});
    });
  };
  for (const char* key : {"Accelerometer", "Angles", "Battery", "Current", "FSR", "Gyroscope", "Position", "Sonar",
                          "Stiffness", "Temperature", "Touch"})
    put(key);
  frame.key("Status").array(sensors.status.size());
  for (const float status : sensors.status) frame.bytes(std::string(1, static_cast<char>(status)));
  return frame.frame();
}

robot::nao::Sensors standing_sensors() {
  using namespace robot::nao;
  Sensors sensors;
  sensors.accelerometer = {0, 0, -9.81f};
  sensors.position[l_hip_pitch] = sensors.position[r_hip_pitch] = -0.41f;
  sensors.position[l_knee_pitch] = sensors.position[r_knee_pitch] = 0.8f;
  sensors.position[l_ankle_pitch] = sensors.position[r_ankle_pitch] = -0.39f;
  sensors.position[l_shoulder_pitch] = sensors.position[r_shoulder_pitch] = 1.5f;
  sensors.position[l_elbow_roll] = -0.4f;
  sensors.position[r_elbow_roll] = 0.4f;
  sensors.temperature.fill(38);
  sensors.battery = {0.8f, 0, -1, 30};
  sensors.fsr.fill(0.65f);
  return sensors;
}

}  // namespace tests
