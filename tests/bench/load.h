// What a Nao writes while it plays: every memory object at its usual rate, one or two cameras at 30 Hz.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "robot/memory/memory.h"

namespace bench {

/// What one call of MemoryObject::write cost its thread, beyond filling the message [ns].
struct WriteCost {
  std::uint32_t cpu_ns, wall_ns;
};

/// The p-th part of the sorted values, 0 <= p <= 1; 0 of none.
std::uint32_t percentile(std::vector<std::uint32_t> values, double p);

/// Two threads, as on the robot: motion at 100 Hz writes sensors, cognition at 30 Hz writes images and beliefs.
class Load {
 public:
  struct Options {
    int cameras = 1;      // raw 640x480 YUYV each
    bool objects = true;  // everything but images
    double work = 0;      // [cores] that cognition computes beside writing, such as 0.7
    double speed = 1;     // so many times the usual rates
  };

  Load(robot::memory::Memory& memory, const robot::Clock& clock, Options options);

  /// As stop().
  ~Load();

  void start();

  /// Ends both threads after the frame at hand.
  void stop();

  /// Frames of cognition so far. Any thread.
  std::uint64_t frames() const { return frames_; }

  // once stopped
  const std::vector<WriteCost>& costs() const { return costs_; }
  const std::vector<std::uint32_t>& periods_us() const { return periods_us_; }  // between the starts of two frames

 private:
  void run_cognition();
  void run_motion();
  void write_frame(std::uint64_t capture_ns);
  void write_sensors(std::uint64_t capture_ns);

  template <class Object, class Fill>
  void write(Object& object, std::uint64_t capture_ns, std::vector<WriteCost>& costs, Fill&& fill);

  robot::memory::Memory& memory_;
  const robot::Clock& clock_;
  const Options options_;
  std::vector<std::string> pictures_;  // they change, as a camera's do
  std::vector<WriteCost> costs_, motion_costs_;
  std::vector<std::uint32_t> periods_us_;
  std::atomic<std::uint64_t> frames_ = 0;
  std::atomic<bool> running_ = false;
  std::thread cognition_, motion_;
};

}  // namespace bench
