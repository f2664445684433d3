// The body of a Nao without another framework: writes LoLA's values into memory, sends motion commands to the guardian.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/memory/memory.h"
#include "robot/nao/guardian/guardian_client.h"
#include "robot/nao/model/kinematics.h"
#include "robot/nao/motion/motion.h"

namespace robot::body {

/// Link and calibration of one Nao.
struct NaoOptions {
  std::filesystem::path link;  // to the guardian, such as default_link()
  nao::Calibration calibration;
  nao::walk::Parameters walk;
};

/// The body, with a thread that each report of the guardian wakes. Without a guardian it tries to connect once a
/// second.
class NaoBody {
 public:
  /// Returns a sentence if another program has LoLA, else an empty string. Waits at most two seconds for the guardian's
  /// report.
  static std::string taken_by_others(const NaoOptions& options);

  /// `memory` is the memory of this robot. `memory` and `clock` outlive this.
  NaoBody(NaoOptions options, memory::Memory& memory, const SessionClock& clock);

  /// Starts the thread, once. Returns an Error if the system allows no more threads.
  Result<void> start();

  /// Sends a goodbye to the guardian, which then sits the robot down.
  ~NaoBody();
  NaoBody(const NaoBody&) = delete;
  NaoBody& operator=(const NaoBody&) = delete;

  /// Walks with other parameters from the next cycle on, see Walk::change(). Any thread.
  void change_walk(const nao::walk::Parameters& parameters);

  /// Returns the pose of `camera` at `capture_ns` [ns since the epoch], or nothing without joints within 50 ms of that
  /// time. Any thread.
  std::optional<nao::Transform> robot_from_camera(nao::Camera camera, std::uint64_t capture_ns) const;

 private:
  /// Measured joints at one time.
  struct JointSample {
    std::uint64_t capture_ns;  // since the epoch
    nao::PerJoint<float> position;
    std::array<float, 2> angles;
  };

  void run();
  void cycle();
  bool find_guardian();
  void take(const nao::Report& report);
  void write_sensors(const nao::Report& report, std::uint64_t capture_ns);
  void write_body(const nao::Report* report, const std::string& problem);
  nao::Order order_after(const nao::Report& report, std::uint64_t capture_ns);
  void say(const std::string& sentence);

  const NaoOptions options_;
  memory::Memory& memory_;
  const SessionClock& clock_;
  const nao::Kinematics kinematics_;

  // of the thread
  std::optional<nao::GuardianClient> guardian_;
  nao::Motion motion_;
  std::string said_;  // the last reported problem
  foresight::Body body_;
  std::uint64_t body_ns_ = 0, battery_ns_ = 0, sonar_ns_ = 0, next_try_ns_ = 0;

  mutable Mutex lock_;
  std::deque<JointSample> samples_;
  std::optional<nao::walk::Parameters> changed_walk_;  // since the last cycle

  std::atomic<bool> ends_ = false;
  std::thread thread_;  // last: it uses all the others
};

/// Asks the guardian to remove the stiffness, independent of the runtime's orders. Does not wait. Returns an Error if
/// there is no guardian.
Result<void> sit_and_soft(const std::filesystem::path& link);

}  // namespace robot::body
