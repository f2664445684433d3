// The writes of a Nao in a game: every memory object at its usual rate, one or two cameras at 30 Hz.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "robot/memory/memory.h"

namespace bench {

/// Cost of one call of MemoryObject::write for its thread, beyond filling the message [ns].
struct WriteCost {
  std::uint32_t cpu_ns, wall_ns;
};

/// The value below which the part `p` of all values lies, 0 <= p <= 1; 0 of none.
std::uint32_t percentile(std::vector<std::uint32_t> values, double p);

/// Capture times count: the last five digits of the `count`-th one captured at `now_ns` are those of `count`. So
/// a receiver of some of them knows the number of missing ones. The time is wrong by 0.1 ms at most.
inline constexpr std::uint64_t kCountedNs = 100'000;
inline std::uint64_t counting_time(std::uint64_t now_ns, std::uint64_t count) {
  return now_ns - now_ns % kCountedNs + count % kCountedNs;
}

/// The objects that Load does not write, or not alone: their capture times do not count.
inline bool is_counted(std::string_view topic) {
  return !topic.ends_with("/clock") && !topic.ends_with("/runtime") && topic.find("/log") == std::string_view::npos;
}

/// Threads as on the robot: motion at 100 Hz writes sensors, cognition at 30 Hz writes images and beliefs; and as in the
/// lab: ground truth.
class Load {
 public:
  struct Options {
    int cameras = 1;      // raw 640x480 YUYV each
    bool objects = true;  // everything except images and ground truth
    double truth_hz = 0;  // of ground truth
    double work = 0;      // [cores] that cognition computes beside writing, such as 0.7
    double speed = 1;     // factor on the usual rates; the clock has to run as fast
    bool measure = true;  // keeps the cost of each write after the pools are filled
  };

  Load(robot::memory::Memory& memory, const robot::Clock& clock, Options options);

  /// As stop().
  ~Load();

  void start();

  /// Ends all threads after the current frame.
  void stop();

  /// Frames of cognition so far. Any thread.
  std::uint64_t frames() const { return frames_; }

  // once stopped
  const std::vector<WriteCost>& costs() const { return costs_; }
  const std::vector<WriteCost>& image_costs() const { return image_costs_; }  // those of the images, also in costs()
  // those of computing for about as long as a write takes, right after each: what the machine itself adds, interrupts
  // above all
  const std::vector<WriteCost>& control_costs() const { return control_costs_; }
  const std::vector<std::uint32_t>& periods_us() const { return periods_us_; }  // between the starts of two frames

 private:
  template <class Step>
  void run(const char* name, double rate_hz, Step&& step);
  void write_frame(std::uint64_t now_ns, std::uint64_t count);
  void write_sensors(std::uint64_t now_ns, std::uint64_t count);
  void write_truth(std::uint64_t now_ns, std::uint64_t count);

  bool measures() const { return robot::monotonic_ns() >= measure_from_ns_; }

  template <class Object, class Fill>
  void write(Object& object, std::uint64_t capture_ns, std::vector<WriteCost>& costs, Fill&& fill);

  robot::memory::Memory& memory_;
  const robot::Clock& clock_;
  const Options options_;
  std::vector<std::string> pictures_;  // they change from frame to frame, as a camera's do
  std::vector<WriteCost> costs_, image_costs_, control_costs_, motion_costs_, truth_costs_;
  std::vector<std::uint32_t> periods_us_;
  std::atomic<std::uint64_t> frames_ = 0;
  std::uint64_t measure_from_ns_ = UINT64_MAX;  // [monotonic]
  std::atomic<bool> running_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace bench
