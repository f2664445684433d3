// lab_robot SOCKET [SERVOS [SEED]]: a robot in the physics that speaks LoLA, in real time, for one guardian at a time.
//
// Each line on its standard input acts on it, and each line on its standard output is JSON:
//
//   push IMPULSE DEGREES   a blow to the torso [N s], 0 from behind, 90 from the right
//   again [SERVOS [SEED]]  puts another robot on its feet: stiff or soft
//   friction X             of soles and ground, 0: as drawn; turf MM: bumps; both with the robot put up again
//   chest, head, release   presses the chest button or the head, or lets go
//   ball AHEAD LEFT        puts the ball there [m, robot]
//   state                  prints {"servos", "turf", "upright", "x", "y", "heading", "ball_away", "ball_towards", "ball_speed",
//                          "ball_direction", "stiffness", "knee", "chest", "frames"}. The robot starts at the world's origin.
//                          The angles of the ball are from the robot's front. Units: m, rad, m/s.
//   end
#include <poll.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

#include "robot/core/files.h"
#include "robot/core/local_listener.h"
#include "tests/support/input_lines.h"
#include "tests/support/lola_answer.h"
#include "tests/support/lola_frame.h"
#include "tests/walk/lola_body.h"

namespace {

using namespace robot;
using namespace robot::nao;
using nlohmann::json;

constexpr long kCycle_ns = 12'000'000;
constexpr double kDegrees = 180 / std::numbers::pi;

/// The robot that people choose.
struct Choice {
  walk::Servos servos = walk::Servos::stiff;
  std::uint64_t seed = 1;
  std::optional<double> friction;
  double turf = 0;  // [m]

  std::unique_ptr<LolaBody> body() const {
    walk::DrawnRobot robot = walk::draw_robot(seed, servos);
    robot.friction = friction.value_or(robot.friction);
    robot.turf = turf;
    return std::make_unique<LolaBody>(robot, seed, true, true);
  }
};

class LabRobot {
 public:
  LabRobot(FileDescriptor listening, const Choice& choice)
      : listening_(std::move(listening)),
        timer_(timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)),
        choice_(choice),
        body_(choice.body()) {
    const itimerspec cycle{.it_interval = {0, kCycle_ns}, .it_value = {0, kCycle_ns}};
    timerfd_settime(timer_.get(), 0, &cycle, nullptr);
  }

  void run() {
    while (!ended_) {
      std::array<pollfd, 4> files{{{connection_ ? -1 : listening_.get(), POLLIN, 0},
                                   {timer_.get(), POLLIN, 0},
                                   {connection_.get(), POLLIN, 0},
                                   {STDIN_FILENO, POLLIN, 0}}};
      ::poll(files.data(), files.size(), 100);
      if (files[0].revents) connection_ = FileDescriptor(::accept4(listening_.get(), nullptr, nullptr, SOCK_CLOEXEC));
      if (files[2].revents) hear();
      if (files[1].revents) cycle();
      if (files[3].revents) read_input();
    }
  }

 private:
  void cycle() {
    std::uint64_t expirations = 0;
    if (::read(timer_.get(), &expirations, sizeof expirations) < 0) return;
    // the last answer counts, as on a robot
    body_->obey(answer_);
    ++frames_;
    if (!connection_) return;
    const std::string frame = tests::lola_frame(body_->sensors);
    if (::send(connection_.get(), frame.data(), frame.size(), MSG_NOSIGNAL | MSG_DONTWAIT) < 0) lose();
  }

  void hear() {
    std::array<char, 4096> block;
    const ssize_t n = ::recv(connection_.get(), block.data(), block.size(), MSG_DONTWAIT);
    if (n == 0 || (n < 0 && errno != EAGAIN)) return lose();
    if (n > 0) received_.append(block.data(), static_cast<std::size_t>(n));
    while (received_.size() >= ActuatorFrame::kBytes) {
      if (const auto answer = tests::read_answer(received_.substr(0, ActuatorFrame::kBytes))) answer_ = *answer;
      received_.erase(0, ActuatorFrame::kBytes);
    }
  }

  /// Forgets the guardian: a robot without one has no stiffness.
  void lose() {
    connection_.reset();
    received_.clear();
    answer_ = {};
  }

  void read_input() {
    const bool open = input_.read([&](const std::string& line) {
      if (!obey(line)) std::fprintf(stderr, "lab_robot: cannot obey '%s'\n", line.c_str());
    });
    ended_ |= !open;
  }

  bool obey(const std::string& line) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    double first = 0, second = 0;
    if (word == "push" && words >> first >> second) {
      body_->push(first, second / kDegrees);
    } else if (word == "again") {
      if (std::string servos; words >> servos)
        choice_.servos = servos == "soft" ? walk::Servos::soft : walk::Servos::stiff;
      words >> choice_.seed;
      put_up();
    } else if (word == "friction" && words >> first) {
      choice_.friction = first > 0 ? std::optional(first) : std::nullopt;
      put_up();
    } else if (word == "turf" && words >> first) {
      choice_.turf = first / 1000;
      put_up();
    } else if (word == "ball" && words >> first >> second) {
      body_->place_ball(first, second);
    } else if (word == "chest" || word == "head" || word == "release") {
      body_->sensors.touch[0] = word == "chest" ? 1 : 0;
      for (const std::size_t head : {1, 2, 3}) body_->sensors.touch[head] = word == "head" ? 1 : 0;
    } else if (word == "state") {
      const walk::Truth truth = body_->truth();
      const double x = truth.ball_x - truth.x, y = truth.ball_y - truth.y;
      const json state = {{"servos", choice_.servos == walk::Servos::soft ? "soft" : "stiff"},
                          {"turf", 1000 * choice_.turf},
                          {"upright", body_->upright()},
                          {"x", truth.x},
                          {"y", truth.y},
                          {"heading", truth.heading},
                          {"ball_away", std::hypot(x, y)},
                          {"ball_towards", std::remainder(std::atan2(y, x) - truth.heading, 2 * std::numbers::pi)},
                          {"ball_speed", truth.ball_speed},
                          {"ball_direction", truth.ball_direction},
                          {"stiffness", body_->sensors.stiffness[l_knee_pitch]},
                          {"knee", body_->sensors.position[l_knee_pitch]},
                          {"chest", answer_.lights.chest},
                          {"frames", frames_}};
      std::printf("%s\n", state.dump().c_str());
      std::fflush(stdout);
    } else if (word == "end") {
      ended_ = true;
    } else {
      return false;
    }
    return true;
  }

  void put_up() {
    body_ = choice_.body();
    answer_ = {};
  }

  FileDescriptor listening_, timer_, connection_;
  Choice choice_;
  std::unique_ptr<LolaBody> body_;
  Actuators answer_;
  std::string received_;
  tests::InputLines input_;
  bool ended_ = false;
  std::uint64_t frames_ = 0;
};

}  // namespace

int main(int count, char** words) {
  const std::string servos = count > 2 ? words[2] : "stiff";
  if (count < 2 || count > 4 || (servos != "stiff" && servos != "soft")) {
    std::fprintf(stderr, "lab_robot: expected SOCKET [stiff|soft [SEED]], got '%s'\n", servos.c_str());
    return 2;
  }
  Choice choice{.servos = servos == "soft" ? walk::Servos::soft : walk::Servos::stiff};
  if (count == 4) choice.seed = std::strtoull(words[3], nullptr, 10);
  auto listening =
      listen_locally(words[1], {.who = "lab_robot", .another = "another one does", .type = SOCK_STREAM, .backlog = 1});
  if (!listening) {
    std::fprintf(stderr, "%s\n", listening.error().c_str());
    return 2;
  }
  std::printf("{\"ready\": true}\n");
  std::fflush(stdout);
  LabRobot(std::move(*listening), choice).run();
  ::unlink(words[1]);
  return 0;
}
