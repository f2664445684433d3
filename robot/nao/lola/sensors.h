// Sensor values from LoLA, sent every 12 ms, and the reader of their frames.
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

/// One frame of sensors in LoLA's units. proto/foresight/sensors.proto has the order of touch fields and foot sensors.
struct Sensors {
  PerJoint<float> position{};            // [rad]; hands 0 closed .. 1 open
  PerJoint<float> stiffness{};           // [0..1]; negative: motor off
  PerJoint<float> temperature{};         // [°C]
  PerJoint<float> current{};             // [A]
  PerJoint<float> status{};              // 0: no error
  std::array<float, 3> accelerometer{};  // [m/s²] opposite to the specific force: about (0, 0, -9.81) standing still
  std::array<float, 3> gyroscope{};      // [rad/s]
  std::array<float, 2> angles{};         // [rad] roll, pitch of the torso
  std::array<float, 4> battery{};        // charge [0..1], status, current [A], temperature [°C]
  std::array<float, 8> fsr{};            // [kg]
  std::array<float, 2> sonar{};          // [m] left, right
  std::array<float, 14> touch{};         // 0 or 1
  static constexpr std::size_t kNumbers = 5 * kJoints + 3 + 3 + 2 + 4 + 8 + 2 + 14;

  /// Calls see(key, array) for each field, with its key in a frame.
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

/// Identity of the robot.
struct RobotIdentity {
  std::string body_id, body_version, head_id, head_version;
};

/// The reader of one connection's frames. It finds the position of each number once and remembers it. Later frames are
/// read in place while all bytes between the numbers are equal; otherwise the frame is parsed again. Unknown keys are
/// skipped. A frame is refused if a key is missing or repeated, if a field has a wrong count, or if a number is not
/// finite. Nothing is allocated while frames have the same layout.
class SensorFrames {
 public:
  static constexpr std::size_t kMaxBytes = 4096;  // a real frame has 896

  /// Returns the size of the first frame in `bytes`, or 0 while bytes are missing. Returns an Error if they are no
  /// frame.
  Result<std::size_t> size_of_first(std::string_view bytes) const;

  /// Reads `frame`, as size_of_first() found it. After an Error `sensors` are unchanged.
  Result<void> read(std::string_view frame, Sensors& sensors);

  /// Returns the identity in the last frame that was read.
  const RobotIdentity& identity() const { return identity_; }

 private:
  bool fits(std::string_view frame) const;
  Result<void> learn(std::string_view frame);

  RobotIdentity identity_;
  std::array<NumberSlot, Sensors::kNumbers> slots_{};  // in the order of visit()
  std::vector<std::uint64_t> known_, fixed_;           // the parsed frame; mask of the bits that must be equal
  std::size_t bytes_ = 0;                              // of the parsed frame; 0: none yet
};

}  // namespace robot::nao
