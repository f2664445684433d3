// What LoLA tells every 12 ms, and how a frame of it is read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/nao/lola/joints.h"
#include "robot/nao/lola/message_pack.h"

namespace robot::nao {

/// One frame of sensors, as LoLA has them. Which touch field and which foot sensor is where: proto/foresight/sensors.proto.
struct Sensors {
  PerJoint<float> position{};            // [rad]; hands 0 closed .. 1 open
  PerJoint<float> stiffness{};           // [0..1]; negative: motor off
  PerJoint<float> temperature{};         // [°C]
  PerJoint<float> current{};             // [A]
  PerJoint<float> status{};              // 0: no complaint
  std::array<float, 3> accelerometer{};  // [m/s²] opposite to the specific force: about (0, 0, -9.81) standing still
  std::array<float, 3> gyroscope{};      // [rad/s]
  std::array<float, 2> angles{};         // [rad] roll, pitch of the torso
  std::array<float, 4> battery{};        // charge [0..1], status, current [A], temperature [°C]
  std::array<float, 8> fsr{};            // [kg]
  std::array<float, 2> sonar{};          // [m] left, right
  std::array<float, 14> touch{};         // 0 or 1
  static constexpr std::size_t kNumbers = 5 * kJoints + 3 + 3 + 2 + 4 + 8 + 2 + 14;

  /// Calls see(key, array) for each field, by its key in a frame.
  template <class See>
  void visit(See&& see) {
    see("Position", position);
    see("Stiffness", stiffness);
    see("Temperature", temperature);
    see("Current", current);
    see("Status", status);
    see("Accelerometer", accelerometer);
    see("Gyroscope", gyroscope);
    see("Angles", angles);
    see("Battery", battery);
    see("FSR", fsr);
    see("Sonar", sonar);
    see("Touch", touch);
  }
};

/// Which robot this is.
struct RobotIdentity {
  std::string body_id, body_version, head_id, head_version;
};

/// Reads the frames of one connection. Where each number lies is found once and remembered: from then on a frame is read
/// in place, as long as all bytes between the numbers are the same; otherwise it is looked through anew.
/// What a frame says beside is passed over; one that lacks something, has too much of it, or holds what is no finite
/// number, is refused. Nothing is allocated while frames look alike.
class SensorFrames {
 public:
  static constexpr std::size_t kMaxBytes = 4096;  // a frame has 896

  /// The size of the frame that `bytes` begin with; 0 while more of them are needed. An Error: no frame begins here.
  Result<std::size_t> size_of_first(std::string_view bytes) const;

  /// Reads `frame`, which is one as size_of_first() found it. After an Error `sensors` are as they were.
  Result<void> read(std::string_view frame, Sensors& sensors);

  /// Of the last frame that was read.
  const RobotIdentity& identity() const { return identity_; }

 private:
  bool fits(std::string_view frame) const;
  Result<void> learn(std::string_view frame);

  RobotIdentity identity_;
  std::array<NumberSlot, Sensors::kNumbers> slots_{};  // in the order of visit()
  std::vector<std::uint64_t> known_, fixed_;           // a frame like it; which of its bits are the same in all
  std::size_t bytes_ = 0;                              // of such a frame; 0: none yet
};

}  // namespace robot::nao
