#include "tests/bench/load.h"

#include <pthread.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <random>

namespace bench {
namespace {

using robot::kSecond;
using robot::monotonic_ns;
using robot::thread_cpu_ns;

namespace pb = foresight;

constexpr std::uint64_t kFilling = 2 * kSecond;  // until pools and queues have their steady size
constexpr std::size_t kWidth = 640, kHeight = 480;

/// A field with lines, and the noise of a camera: 640x480 YUYV that takes about 42 kB as a JPEG of quality 75, as
/// pictures of a Nao do.
std::string picture(unsigned seed) {
  std::mt19937 random(seed);
  std::string bytes(kWidth * kHeight * 2, '\0');
  for (std::size_t y = 0; y < kHeight; ++y)
    for (std::size_t x = 0; x < kWidth; ++x) {
      const bool line = (x + seed * 8) % 160 < 6 || y % 120 < 4;
      const std::size_t turf = (x / 2 * 2654435761 + y / 2 * 40503 + seed) % 4093 % 18;
      const std::size_t luma = (line ? 200 : 80) + turf + random() % 12, chroma = 120 + random() % 2;
      bytes[(y * kWidth + x) * 2] = static_cast<char>(luma);
      bytes[(y * kWidth + x) * 2 + 1] = static_cast<char>(chroma);
    }
  return bytes;
}

void sleep_until(std::uint64_t time_ns) {
  if (time_ns <= monotonic_ns()) return;  // a timer that is over already still costs 20 us on a virtual machine
  const timespec until{.tv_sec = static_cast<time_t>(time_ns / kSecond),
                       .tv_nsec = static_cast<long>(time_ns % kSecond)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
  }
}

/// Returns the cost of `work` for this thread: the smaller one of the wall clock and of the CPU time between two readings.
/// The CPU time of the work is below both. Reading CPU time is a system call, which may take longer than the work.
template <class Work>
WriteCost cost_of(Work&& work) {
  const std::uint64_t cpu_0 = thread_cpu_ns(), wall_0 = monotonic_ns();
  work();
  const std::uint64_t wall = monotonic_ns() - wall_0, cpu = thread_cpu_ns() - cpu_0;
  return {static_cast<std::uint32_t>(std::min(cpu, wall)), static_cast<std::uint32_t>(wall)};
}

/// Computes for about 2 us, as long as a write takes on average.
WriteCost cost_of_computing() {
  return cost_of([] {
    volatile double sink = 0;
    for (int i = 0; i < 900; ++i) sink = sink + static_cast<double>(i);
  });
}

/// Computes for this much of the thread's CPU time.
void compute_for(std::uint64_t cpu_ns) {
  const std::uint64_t until = thread_cpu_ns() + cpu_ns;
  volatile double sink = 0;
  while (thread_cpu_ns() < until)
    for (int i = 0; i < 2000; ++i) sink = sink + std::sqrt(static_cast<double>(i));
}

}  // namespace

std::uint32_t percentile(std::vector<std::uint32_t> values, double p) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::size_t>(p * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

Load::Load(robot::memory::Memory& memory, const robot::Clock& clock, Options options)
    : memory_(memory), clock_(clock), options_(options) {
  if (options_.cameras > 0)
    for (unsigned seed = 0; seed < 4; ++seed) pictures_.push_back(picture(seed));
}

Load::~Load() { stop(); }

/// Calls step(time, count) at this rate, on this thread, until stop().
template <class Step>
void Load::run(const char* name, double rate_hz, Step&& step) {
  pthread_setname_np(pthread_self(), name);
  const auto period_ns = static_cast<std::uint64_t>(1e9 / rate_hz / options_.speed);
  std::uint64_t due = monotonic_ns();
  for (std::uint64_t count = 0; running_; ++count, due += period_ns) {
    sleep_until(due);
    step(clock_.now_ns(), count);
  }
}

void Load::start() {
  running_ = true;
  if (options_.measure) measure_from_ns_ = monotonic_ns() + kFilling;
  if (options_.cameras > 0 || options_.objects)
    threads_.emplace_back([this] {
      std::uint64_t last = 0;
      run("cognition", 30, [&](std::uint64_t now_ns, std::uint64_t count) {
        const std::uint64_t started = monotonic_ns();
        if (last != 0 && measures()) periods_us_.push_back(static_cast<std::uint32_t>((started - last) / 1000));
        last = started;
        if (options_.work > 0) compute_for(static_cast<std::uint64_t>(options_.work * 1e9 / 30));
        write_frame(now_ns, count);
        ++frames_;
      });
    });
  if (options_.objects)
    threads_.emplace_back(
        [this] { run("motion", 100, [this](auto now_ns, auto count) { write_sensors(now_ns, count); }); });
  if (options_.truth_hz > 0)
    threads_.emplace_back(
        [this] { run("truth", options_.truth_hz, [this](auto now_ns, auto count) { write_truth(now_ns, count); }); });
}

void Load::stop() {
  running_ = false;
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
  for (auto* costs : {&motion_costs_, &truth_costs_}) {
    costs_.insert(costs_.end(), costs->begin(), costs->end());
    costs->clear();
  }
}

template <class Object, class Fill>
void Load::write(Object& object, std::uint64_t capture_ns, std::vector<WriteCost>& costs, Fill&& fill) {
  if (!measures()) {
    auto draft = object.draft();
    fill(*draft);
    return object.write(std::move(draft), capture_ns);
  }
  // taking the draft from the pool counts, filling it does not
  std::optional<decltype(object.draft())> draft;
  const WriteCost taking = cost_of([&] { draft = object.draft(); });
  fill(**draft);
  const WriteCost writing = cost_of([&] { object.write(std::move(*draft), capture_ns); });
  costs.push_back({taking.cpu_ns + writing.cpu_ns, taking.wall_ns + writing.wall_ns});
  if (&costs == &costs_) control_costs_.push_back(cost_of_computing());
}

void Load::write_frame(std::uint64_t now_ns, std::uint64_t count) {
  const std::uint64_t capture_ns = counting_time(now_ns, count);
  const auto frame = static_cast<float>(count % 1000);
  for (int camera = 0; camera < options_.cameras; ++camera) {
    write(camera == 0 ? memory_.camera_top : memory_.camera_bottom, capture_ns, costs_, [&](pb::Image& image) {
      image.set_encoding(pb::Image::ENCODING_YUYV);
      image.set_width(kWidth);
      image.set_height(kHeight);
      image.set_data(pictures_[count % pictures_.size()]);
    });
    if (!costs_.empty()) image_costs_.push_back(costs_.back());
  }
  if (!options_.objects) return;
  for (auto* matrix : {&memory_.camera_top_matrix, &memory_.camera_bottom_matrix})
    write(*matrix, capture_ns, costs_, [&](pb::CameraMatrix& value) {
      for (int i = 0; i < 9; ++i) value.add_rotation(frame + static_cast<float>(i));
      value.set_x(0.05f), value.set_y(0), value.set_z(0.45f);
      value.set_width(kWidth), value.set_height(kHeight), value.set_focal_x(544), value.set_focal_y(544);
    });
  write(memory_.vision, capture_ns, costs_, [&](pb::Vision& value) {
    value.set_image_width(kWidth), value.set_image_height(kHeight);
    for (int i = 0; i < 6; ++i) {
      auto& line = *value.add_lines();
      line.set_start_x(frame), line.set_start_y(static_cast<float>(i)), line.set_end_x(2), line.set_end_y(3);
    }
    value.mutable_ball()->mutable_detection()->set_distance(frame);
  });
  write(memory_.ball, capture_ns, costs_, [&](pb::Ball& value) {
    value.set_seen_ns(capture_ns), value.set_x(frame), value.set_y(1), value.set_deviation(0.1f);
  });
  write(memory_.pose, capture_ns, costs_, [&](pb::Pose& value) { value.set_x(frame), value.set_heading(1); });
  write(memory_.team, capture_ns, costs_, [&](pb::Team& value) {
    for (std::uint32_t player = 1; player <= 4; ++player) {
      auto& mate = *value.add_teammates();
      mate.set_player(player), mate.set_role("defender"), mate.mutable_pose()->set_x(frame);
    }
  });
  write(memory_.motion_command, capture_ns, costs_,
        [&](pb::MotionCommand& value) { value.mutable_walk_speed()->set_x(frame); });
  write(memory_.decision, capture_ns, costs_, [&](pb::DecisionTrace& value) {
    value.set_strategy("baseline"), value.set_role("striker"), value.set_skill("approach_ball");
    for (int i = 0; i < 8; ++i) {
      auto& node = *value.add_visited();
      node.set_name("is the ball near?"), node.set_feature("ball.distance"), node.set_value(frame);
      node.set_threshold(1);
    }
  });
  if (count % 15 != 0) return;
  write(memory_.game, counting_time(now_ns, count / 15), costs_,
        [&](pb::GameState& value) { value.set_seconds_remaining(frame); });
  write(memory_.log, capture_ns, costs_, [&](pb::LogText& value) { value.set_text("frame " + std::to_string(count)); });
}

void Load::write_sensors(std::uint64_t now_ns, std::uint64_t count) {
  const std::uint64_t capture_ns = counting_time(now_ns, count);
  // noise as of real sensors, because it sets the size of recordings
  std::uint64_t state = count * 0x9e3779b97f4a7c15;
  const auto noise = [&state] {
    state = state * 6364136223846793005 + 1442695040888963407;
    return static_cast<float>(state >> 52) * 1e-4f;
  };
  write(memory_.joints, capture_ns, motion_costs_, [&](pb::Joints& joints) {
    for (int i = 0; i < 25; ++i) {
      joints.add_position(noise()), joints.add_commanded(static_cast<float>(i)), joints.add_stiffness(1);
      joints.add_temperature(38), joints.add_current(noise());
    }
  });
  write(memory_.inertial, capture_ns, motion_costs_, [&](pb::Inertial& inertial) {
    inertial.set_accelerometer_x(noise()), inertial.set_accelerometer_y(noise());
    inertial.set_accelerometer_z(9.81f + noise()), inertial.set_gyroscope_x(noise());
    inertial.set_gyroscope_y(noise()), inertial.set_torso_roll(noise()), inertial.set_torso_pitch(noise());
  });
  write(memory_.fsr, capture_ns, motion_costs_, [&](pb::Fsr& fsr) {
    fsr.set_left_front_left(noise()), fsr.set_left_front_right(noise());
    fsr.set_left_rear_left(noise()), fsr.set_left_rear_right(noise());
    fsr.set_right_front_left(noise()), fsr.set_right_front_right(noise());
    fsr.set_right_rear_left(noise()), fsr.set_right_rear_right(noise());
  });
  write(memory_.odometry, capture_ns, motion_costs_, [&](pb::Odometry& odometry) {
    odometry.set_x(noise()), odometry.set_y(noise()), odometry.set_heading(noise());
  });
  write(memory_.motion_status, capture_ns, motion_costs_,
        [&](pb::MotionStatus& status) { status.set_remaining(noise()); });
  write(memory_.touch, capture_ns, motion_costs_, [&](pb::Touch& touch) { touch.set_chest_button(count % 500 == 0); });
  write(memory_.sonar, capture_ns, motion_costs_, [&](pb::Sonar& sonar) { sonar.set_left(noise()); });
  write(memory_.battery, capture_ns, motion_costs_, [&](pb::Battery& battery) { battery.set_charge(0.9f); });
}

void Load::write_truth(std::uint64_t now_ns, std::uint64_t count) {
  write(memory_.truth, counting_time(now_ns, count), truth_costs_, [&](pb::GroundTruth& truth) {
    const auto along = static_cast<float>(count % 900) * 0.01f;
    truth.mutable_ball()->set_x(along), truth.mutable_ball()->set_y(1);
    for (std::uint32_t player = 1; player <= 4; ++player) {
      auto& robot = *truth.add_robots();
      robot.set_team(14), robot.set_player(player), robot.set_x(along), robot.set_y(static_cast<float>(player));
      robot.set_heading(along);
    }
  });
}

}  // namespace bench
