#include "tests/bench/load.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>

namespace bench {
namespace {

using robot::kSecond;
using robot::monotonic_ns;
using robot::thread_cpu_ns;

constexpr std::size_t kImageBytes = 640 * 480 * 2;

/// Noise about a picture: what a camera delivers does not compress.
std::string picture(unsigned seed) {
  std::mt19937 random(seed);
  std::string bytes(kImageBytes, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<char>(100 + 50 * ((i / 1280 / 40) % 2) + random() % 8);
  return bytes;
}

void sleep_until(std::uint64_t time_ns) {
  const timespec until{.tv_sec = static_cast<time_t>(time_ns / kSecond),
                       .tv_nsec = static_cast<long>(time_ns % kSecond)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
  }
}

/// Computes for so much of this thread's CPU time.
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
  for (unsigned seed = 0; seed < 4; ++seed) pictures_.push_back(picture(seed));
}

Load::~Load() { stop(); }

void Load::start() {
  running_ = true;
  cognition_ = std::thread([this] { run_cognition(); });
  if (options_.objects) motion_ = std::thread([this] { run_motion(); });
}

void Load::stop() {
  running_ = false;
  if (cognition_.joinable()) cognition_.join();
  if (motion_.joinable()) motion_.join();
  costs_.insert(costs_.end(), motion_costs_.begin(), motion_costs_.end());
  motion_costs_.clear();
}

void Load::run_cognition() {
  const auto period_ns = static_cast<std::uint64_t>(1e9 / 30 / options_.speed);
  std::uint64_t due = monotonic_ns(), last = 0;
  while (running_) {
    sleep_until(due);
    const std::uint64_t now = monotonic_ns();
    if (last != 0) periods_us_.push_back(static_cast<std::uint32_t>((now - last) / 1000));
    last = now;
    const std::uint64_t capture_ns = clock_.now_ns();
    if (options_.work > 0) compute_for(static_cast<std::uint64_t>(options_.work * static_cast<double>(period_ns)));
    write_frame(capture_ns);
    ++frames_;
    due += period_ns;
  }
}

void Load::run_motion() {
  const auto period_ns = static_cast<std::uint64_t>(1e9 / 100 / options_.speed);
  std::uint64_t due = monotonic_ns();
  while (running_) {
    sleep_until(due);
    write_sensors(clock_.now_ns());
    due += period_ns;
  }
}

template <class Object, class Fill>
void Load::write(Object& object, std::uint64_t capture_ns, std::vector<WriteCost>& costs, Fill&& fill) {
  // taking the draft from the pool counts, filling it does not
  const std::uint64_t wall_0 = monotonic_ns(), cpu_0 = thread_cpu_ns();
  auto draft = object.draft();
  const std::uint64_t cpu_1 = thread_cpu_ns(), wall_1 = monotonic_ns();
  fill(*draft);
  const std::uint64_t wall_2 = monotonic_ns(), cpu_2 = thread_cpu_ns();
  object.write(std::move(draft), capture_ns);
  const std::uint64_t cpu_3 = thread_cpu_ns(), wall_3 = monotonic_ns();
  costs.push_back({static_cast<std::uint32_t>(cpu_1 - cpu_0 + cpu_3 - cpu_2),
                   static_cast<std::uint32_t>(wall_1 - wall_0 + wall_3 - wall_2)});
}

void Load::write_frame(std::uint64_t capture_ns) {
  namespace pb = foresight;
  const auto frame = static_cast<float>(frames_.load() % 1000);
  const std::string& pixels = pictures_[frames_ % pictures_.size()];
  for (int camera = 0; camera < options_.cameras; ++camera)
    write(camera == 0 ? memory_.camera_top : memory_.camera_bottom, capture_ns, costs_, [&](pb::Image& image) {
      image.set_encoding(pb::Image::ENCODING_YUYV);
      image.set_width(640);
      image.set_height(480);
      image.set_data(pixels);
    });
  if (!options_.objects) return;
  for (auto* matrix : {&memory_.camera_top_matrix, &memory_.camera_bottom_matrix})
    write(*matrix, capture_ns, costs_, [&](pb::CameraMatrix& value) {
      for (int i = 0; i < 9; ++i) value.add_rotation(frame + static_cast<float>(i));
      value.set_x(0.05f), value.set_y(0), value.set_z(0.45f);
      value.set_width(640), value.set_height(480), value.set_focal_x(544), value.set_focal_y(544);
    });
  write(memory_.vision, capture_ns, costs_, [&](pb::Vision& value) {
    value.set_image_width(640), value.set_image_height(480);
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
      node.set_name("is the ball near?"), node.set_feature("ball.distance"), node.set_value(frame),
          node.set_threshold(1);
    }
  });
  if (frames_ % 15 == 0) {
    write(memory_.game, capture_ns, costs_, [&](pb::GameState& value) { value.set_seconds_remaining(frame); });
    write(memory_.log, capture_ns, costs_,
          [&](pb::LogText& value) { value.set_text("frame " + std::to_string(frame)); });
  }
}

void Load::write_sensors(std::uint64_t capture_ns) {
  namespace pb = foresight;
  const auto value = static_cast<float>(capture_ns % 1000);
  write(memory_.joints, capture_ns, motion_costs_, [&](pb::Joints& joints) {
    for (int i = 0; i < 25; ++i) {
      joints.add_position(value), joints.add_commanded(value), joints.add_stiffness(1), joints.add_temperature(38);
      joints.add_current(value);
    }
  });
  write(memory_.inertial, capture_ns, motion_costs_,
        [&](pb::Inertial& inertial) { inertial.set_accelerometer_x(value); });
  write(memory_.fsr, capture_ns, motion_costs_, [&](pb::Fsr& fsr) { fsr.set_left_front_left(value); });
  write(memory_.odometry, capture_ns, motion_costs_, [&](pb::Odometry& odometry) { odometry.set_x(value); });
  write(memory_.motion_status, capture_ns, motion_costs_,
        [&](pb::MotionStatus& status) { status.set_remaining(value); });
  write(memory_.touch, capture_ns, motion_costs_, [&](pb::Touch& touch) { touch.set_chest_button(value > 500); });
  write(memory_.sonar, capture_ns, motion_costs_, [&](pb::Sonar& sonar) { sonar.set_left(value); });
  write(memory_.battery, capture_ns, motion_costs_, [&](pb::Battery& battery) { battery.set_charge(value); });
}

}  // namespace bench
