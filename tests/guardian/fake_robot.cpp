// fake_robot: a stand-in for a Nao V6. LoLA's socket, a frame every 12 ms, joints that follow, a torso that falls.
//
//   fake_robot PATH [--busy N] [--seconds S]
//
// Listens at PATH and serves one program at a time. Each line on its standard input is an event. Each line on its standard
// output is JSON:
//
//   chest | head | release | fall | upright | lift | down | heat N | cool | battery N | turn N    act on the body
//   broken | short | huge | reordered | other     form of the next frames: broken numbers, half a frame, one of
//                                                 10 kB, another order of keys, correct
//   vanish                                        the connection ends after the next answer, so that none is lost on
//                                                 the way; the next one is served
//   state                                         prints {"stiffness", "knee", "chest", "eye", "frames", "answers", …}
//   end
//
// --seconds S: ends after S seconds and prints the state. --busy N: starts N threads that compute all the time. The robot
// itself then has a real-time priority, if allowed, as LoLA has: then it waits only for the answer.
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "robot/core/local_listener.h"
#include "tests/support/fake_body.h"
#include "tests/support/input_lines.h"
#include "tests/support/lola_answer.h"
#include "tests/support/lola_frame.h"

namespace {

using namespace robot;
using namespace robot::nao;
using nlohmann::json;

constexpr std::uint64_t kCycle_ns = 12 * kMillisecond;
constexpr int kPriority = 45;  // above the guardian's

class FakeRobot {
 public:
  FakeRobot(FileDescriptor listening, double seconds)
      : listening_(std::move(listening)),
        timer_(timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)),
        ends_ns_(seconds > 0 ? monotonic_ns() + static_cast<std::uint64_t>(seconds * 1e9) : ~std::uint64_t{0}) {
    begin_cycles(1);
  }

  void run() {
    while (!ended_ && monotonic_ns() < ends_ns_) {
      std::array<pollfd, 4> files{{{listening_.get(), POLLIN, 0},
                                   {timer_.get(), POLLIN, 0},
                                   {connection_.get(), POLLIN, 0},
                                   {input_open_ ? STDIN_FILENO : -1, POLLIN, 0}}};
      ::poll(files.data(), files.size(), 100);
      if (files[2].revents) hear();
      if (files[0].revents) take_in();
      if (files[1].revents) cycle();
      if (files[3].revents) read_input();
    }
    tell();
  }

 private:
  void begin_cycles(std::uint64_t in_ns) {
    const itimerspec cycle{.it_interval = {0, static_cast<long>(kCycle_ns)}, .it_value = {0, static_cast<long>(in_ns)}};
    timerfd_settime(timer_.get(), 0, &cycle, nullptr);
    due_ns_ = monotonic_ns() + in_ns;
  }

  void take_in() {
    FileDescriptor connection(::accept4(listening_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    // one program at a time, like LoLA: others are connected and receive nothing
    if (!connection_) {
      connection_ = std::move(connection);
      received_.clear();
      sent_ns_ = 0;
    } else {
      waiting_.push_back(std::move(connection));
    }
  }

  void lose() {
    connection_.reset();
    sent_ns_ = 0;
    if (waiting_.empty()) return;
    connection_ = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
  }

  void cycle() {
    std::uint64_t expirations = 0;
    if (::read(timer_.get(), &expirations, sizeof expirations) < 0) return;
    due_ns_ += expirations * kCycle_ns;
    const bool late = monotonic_ns() + kCycle_ns > due_ns_ + kMillisecond;
    late_ += expirations - 1 + (late ? 1 : 0);
    // after a pause of the machine the next frame is still a whole cycle away, which is the time for the answer
    if (late) begin_cycles(kCycle_ns);
    if (!connection_) return;
    if (sent_ns_ != 0) ++unanswered_;
    const std::string frame = frame_of_kind();
    sent_ns_ = monotonic_ns();
    if (::send(connection_.get(), frame.data(), frame.size(), MSG_NOSIGNAL | MSG_DONTWAIT) < 0) return lose();
    ++frames_;
  }

  std::string frame_of_kind() {
    Sensors sensors = body_.sensors;
    if (kind_ == "broken") sensors.gyroscope[0] = std::nanf("");
    if (kind_ == "reordered") {
      tests::LolaFrame frame;
      sensors.visit([&](std::string_view key, const auto& numbers) {
        frame.floats(key, {numbers.begin(), numbers.end()});
      });
      return frame.identity().frame();
    }
    std::string frame = tests::lola_frame(sensors);
    if (kind_ == "short") frame.resize(frame.size() / 2);
    if (kind_ == "huge") frame = "\xdf\xff\xff\xff\xff" + std::string(10'000, '\xa1');
    return frame;
  }

  void hear() {
    char block[4096];
    const ssize_t n = ::recv(connection_.get(), block, sizeof block, 0);
    if (n == 0 || (n < 0 && errno != EAGAIN)) return lose();
    if (n > 0) received_.append(block, static_cast<std::size_t>(n));
    while (received_.size() >= ActuatorFrame::kBytes) {
      const auto answer = tests::read_answer(received_.substr(0, ActuatorFrame::kBytes));
      received_.erase(0, ActuatorFrame::kBytes);
      if (!answer) {
        ++bad_answers_;
        continue;
      }
      ++answers_;
      if (sent_ns_ != 0) latencies_ns_.push_back(static_cast<std::uint32_t>(monotonic_ns() - sent_ns_));
      sent_ns_ = 0;
      last_ = *answer;
      body_.obey(*answer, 0.012f);
    }
    if (!vanishes_ || !received_.empty()) return;
    vanishes_ = false;
    lose();
  }

  void read_input() {
    input_open_ = input_.read([&](const std::string& line) { obey(line); });
  }

  void obey(const std::string& line) {
    const std::string word = line.substr(0, line.find(' '));
    const float number = line.size() > word.size() ? std::strtof(line.c_str() + word.size(), nullptr) : 0;
    if (word == "chest") body_.press_chest(true);
    if (word == "head") body_.hold_head(true);
    if (word == "release") {
      body_.press_chest(false);
      body_.hold_head(false);
    }
    if (word == "fall") body_.fall();
    if (word == "upright") body_.put_upright();
    if (word == "lift") body_.lift();
    if (word == "down") body_.put_down();
    if (word == "heat") body_.sensors.temperature[l_knee_pitch] = number;
    if (word == "cool") body_.sensors.temperature.fill(38);
    if (word == "battery") body_.sensors.battery[0] = number;
    if (word == "turn") body_.sensors.angles[0] = number;
    if (word == "broken" || word == "short" || word == "huge" || word == "reordered" || word == "other") kind_ = word;
    if (word == "vanish") vanishes_ = true;
    if (word == "state") tell();
    if (word == "end") ended_ = true;
  }

  void tell() {
    std::vector<std::uint32_t> sorted = latencies_ns_;
    std::sort(sorted.begin(), sorted.end());
    const auto quantile_ms = [&](double share) {
      if (sorted.empty()) return 0.0;
      return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))] *
             1e-6;
    };
    const auto& stiffness = body_.sensors.stiffness;
    const json state = {{"stiffness", *std::max_element(stiffness.begin(), stiffness.end())},
                        {"knee", body_.sensors.position[l_knee_pitch]},
                        {"yaw", body_.sensors.position[head_yaw]},
                        {"pitch", body_.sensors.position[head_pitch]},
                        {"chest", last_.lights.chest},
                        {"eye", last_.lights.l_eye},
                        {"connected", static_cast<bool>(connection_)},
                        {"frames", frames_},
                        {"answers", answers_},
                        {"bad_answers", bad_answers_},
                        {"unanswered", unanswered_},
                        {"late_cycles", late_},
                        {"median_ms", quantile_ms(0.5)},
                        {"p999_ms", quantile_ms(0.999)},
                        {"longest_ms", quantile_ms(1)}};
    std::printf("%s\n", state.dump().c_str());
    std::fflush(stdout);
  }

  FileDescriptor listening_, timer_, connection_;
  std::vector<FileDescriptor> waiting_;
  tests::FakeBody body_;
  Actuators last_;
  std::string received_, kind_ = "other";
  tests::InputLines input_;
  bool ended_ = false, input_open_ = true, vanishes_ = false;
  const std::uint64_t ends_ns_;
  std::uint64_t due_ns_ = 0;   // the next cycle
  std::uint64_t sent_ns_ = 0;  // the frame that waits for its answer; 0: none
  std::uint64_t frames_ = 0, answers_ = 0, bad_answers_ = 0, unanswered_ = 0, late_ = 0;
  std::vector<std::uint32_t> latencies_ns_;
};

int fake_robot_main(int argc, char** argv) {
  std::string path;
  int busy = 0;
  double seconds = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--busy" && i + 1 < argc)
      busy = std::atoi(argv[++i]);
    else if (word == "--seconds" && i + 1 < argc)
      seconds = std::atof(argv[++i]);
    else
      path = word;
  }
  auto listening =
      listen_locally(path, {.who = "fake_robot", .another = "another one does", .type = SOCK_STREAM, .backlog = 4});
  if (!listening) {
    std::fprintf(stderr, "%s\n", listening.error().c_str());
    return 2;
  }
  std::printf("{\"ready\": true}\n");
  std::fflush(stdout);
  std::atomic<bool> ended = false;
  std::vector<std::thread> threads;
  for (int i = 0; i < busy; ++i)
    threads.emplace_back([&] {
      while (!ended) {
      }
    });
  const sched_param priority{.sched_priority = kPriority};
  if (busy > 0) sched_setscheduler(0, SCHED_FIFO, &priority);
  FakeRobot(std::move(*listening), seconds).run();
  ended = true;
  for (std::thread& thread : threads) thread.join();
  ::unlink(path.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return fake_robot_main(argc, argv); }
