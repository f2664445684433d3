#include "robot/nao/lola/actuators.h"

#include <bit>
#include <cassert>
#include <cstdint>

#include "robot/nao/lola/markers.h"

namespace robot::nao {
namespace {

constexpr std::size_t kLightsOfAnEye = 8;

struct Key {
  std::string_view name;
  std::size_t numbers;
};

// in the order in which compose() writes them
constexpr std::array<Key, 10> kKeys{{
    {"Position", kJoints},
    {"Stiffness", kJoints},
    {"Chest", 3},
    {"LFoot", 3},
    {"RFoot", 3},
    {"LEye", 3 * kLightsOfAnEye},
    {"REye", 3 * kLightsOfAnEye},
    {"LEar", 10},
    {"REar", 10},
    {"Skull", 12},
}};

}  // namespace

void ActuatorFrame::begin(std::string_view key, std::size_t numbers) {
  bytes_ += byte_of(kFixText, key.size());
  bytes_ += key;
  if (numbers < 16) {
    bytes_ += byte_of(kFixArray, numbers);
  } else {
    bytes_ += byte_of(kArray16);
    bytes_ += '\0';
    bytes_ += static_cast<char>(numbers);
  }
}

ActuatorFrame::ActuatorFrame() {
  bytes_ += byte_of(kFixMap, kKeys.size() + 1);
  for (const Key& key : kKeys) {
    begin(key.name, key.numbers);
    fields_.push_back(bytes_.size());
    for (std::size_t i = 0; i < key.numbers; ++i) bytes_ += {byte_of(kFloat32), '\0', '\0', '\0', '\0'};
  }
  begin("Sonar", 2);
  fields_.push_back(bytes_.size());
  bytes_ += {byte_of(kTrue), byte_of(kTrue)};
  assert(bytes_.size() == kBytes);
}

void ActuatorFrame::put(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (std::size_t i = 0; i < 4; ++i) bytes_[at_ + 1 + i] = static_cast<char>(bits >> (24 - 8 * i) & 0xff);
  at_ += 5;
}

std::string_view ActuatorFrame::compose(const Actuators& actuators) {
  std::size_t field = 0;
  const auto write = [&](const auto& numbers) {
    at_ = fields_[field++];
    for (const float number : numbers) put(number);
  };
  // eight red values, eight green, eight blue
  const auto write_eye = [&](const Colour& colour) {
    at_ = fields_[field++];
    for (const float share : colour)
      for (std::size_t i = 0; i < kLightsOfAnEye; ++i) put(share);
  };
  write(actuators.position);
  write(actuators.stiffness);
  write(actuators.lights.chest);
  write(actuators.lights.l_foot);
  write(actuators.lights.r_foot);
  write_eye(actuators.lights.l_eye);
  write_eye(actuators.lights.r_eye);
  write(actuators.lights.l_ear);
  write(actuators.lights.r_ear);
  write(actuators.lights.skull);
  for (std::size_t side = 0; side < 2; ++side)
    bytes_[fields_[field] + side] = byte_of(actuators.sonar ? kTrue : kFalse);
  return bytes_;
}

}  // namespace robot::nao
