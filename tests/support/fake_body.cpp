#include "tests/support/fake_body.h"

#include <algorithm>

#include "tests/support/lola_frame.h"

namespace tests {

using namespace robot::nao;

FakeBody::FakeBody() : sensors(standing_sensors()) {
  sensors.position[l_hip_pitch] = sensors.position[r_hip_pitch] = -0.87f;
  sensors.position[l_knee_pitch] = sensors.position[r_knee_pitch] = 2.05f;
  sensors.position[l_ankle_pitch] = sensors.position[r_ankle_pitch] = -1.18f;
}

void FakeBody::obey(const Actuators& actuators, float dt) {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    sensors.stiffness[joint] = actuators.stiffness[joint];
    if (actuators.stiffness[joint] <= 0) continue;
    const float step = limits_of(joint).speed * dt;
    sensors.position[joint] += std::clamp(actuators.position[joint] - sensors.position[joint], -step, step);
  }
  sensors.gyroscope[1] = 0;
  if (!falls_ || sensors.angles[1] >= 1.5f) return;
  // like a pole that tips over
  sensors.gyroscope[1] = 0.5f + 4 * sensors.angles[1];
  sensors.angles[1] = std::min(sensors.angles[1] + sensors.gyroscope[1] * dt, 1.5f);
}

void FakeBody::turn(float roll, float pitch) {
  falls_ = false;
  sensors.angles = {roll, pitch};
  sensors.gyroscope = {0, 0, 0};
}

}  // namespace tests
