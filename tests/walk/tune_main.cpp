// tune_walk FIRST_SEED GENERATIONS ROBOTS: searches the parameters of the walk by CMA-ES on drawn robots. Each generation
// meets robots of its own. Prints the mean of each generation, as lines for parameters.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>

#include "sim/learn/cma.h"
#include "tests/walk/dice.h"
#include "tests/walk/our_gait.h"

namespace {

using namespace robot::nao::walk;

/// A parameter that is searched, and its bounds.
struct Knob {
  const char* name;
  double Parameters::*place;
  double least, most;
};

constexpr Knob kKnobs[] = {
    {"period", &Parameters::period, 0.23, 0.33},
    {"hip_height", &Parameters::hip_height, 0.205, 0.228},
    {"ahead", &Parameters::ahead, 0, 0.025},
    {"wider", &Parameters::wider, 0, 0.012},
    {"lift", &Parameters::lift, 0.012, 0.03},
    {"landing", &Parameters::landing, 0.7, 1},
    {"share", &Parameters::share, 0.15, 0.6},
    {"earliest", &Parameters::earliest, 0.4, 0.9},
    {"rate_to_ankle_pitch", &Parameters::rate_to_ankle_pitch, 0, 0.15},
    {"rate_to_ankle_roll", &Parameters::rate_to_ankle_roll, 0, 0.15},
    {"rate_to_hip_pitch", &Parameters::rate_to_hip_pitch, 0, 0.15},
    {"tilt_to_ankle_pitch", &Parameters::tilt_to_ankle_pitch, 0, 0.5},
    {"tilt_to_ankle_roll", &Parameters::tilt_to_ankle_roll, 0, 0.3},
    {"catch_forward", &Parameters::catch_forward, 0.3, 1.3},
    {"catch_forward_from", &Parameters::catch_forward_from, 0, 0.04},
    {"catch_forward_most", &Parameters::catch_forward_most, 0.05, 0.12},
    {"catch_side", &Parameters::catch_side, 0.3, 1.5},
    {"catch_side_from", &Parameters::catch_side_from, 0, 0.05},
    {"counter", &Parameters::counter, 0, 3},
    {"counter_from", &Parameters::counter_from, 0.02, 0.1},
    {"catch_speed", &Parameters::catch_speed, 0.3, 1.5},
    {"fights_from", &Parameters::fights_from, 0.015, 0.06},
    {"calm_share", &Parameters::calm_share, 0.1, 0.8},
    {"slip", &Parameters::slip, 0, 0.25},
    {"lag_share", &Parameters::lag_share, 0.2, 1},
    {"lead_most", &Parameters::lead_most, 0.04, 0.2},
};
constexpr std::size_t kNumber = std::size(kKnobs);
constexpr double kPart = 10;  // a search step of 1 is this part of a knob's range

Parameters at(const sim::learn::Vector& point) {
  Parameters parameters;
  for (std::size_t i = 0; i < kNumber; ++i) {
    const Knob& knob = kKnobs[i];
    const double start = Parameters{}.*knob.place, unit = (knob.most - knob.least) / kPart;
    parameters.*knob.place = std::clamp(start + unit * point[i], knob.least, knob.most);
  }
  return parameters;
}

/// Lets robots walk, be pushed and obey quick commands. Falls cost most, earlier ones more; then missing speed.
class Judge {
 public:
  Judge() {
    for (const bool about_origin : {false, true})
      physics_[about_origin] = std::make_unique<Physics>(Scene{.about_origin = about_origin});
  }

  double cost(const Parameters& parameters, std::uint64_t first_seed, int robots) {
    double sum = 0;
    for (int i = 0; i < robots; ++i) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
      const Servos servos = i % 2 == 0 ? Servos::stiff : Servos::soft;
      Dice dice(seed);
      const Outcome walk = run(parameters, servos, seed, 14, [](double) { return Command{.forward = 0.2}; }, {});
      const double speed = walk.measured > 0 ? walk.forward / walk.measured : 0;
      sum += fall(walk, 14) + 4 * std::max(0.0, 0.19 - speed) / 0.19;
      for (int push = 0; push < 2; ++push) {
        const double when = 2.5 + dice.uniform(), direction = 2 * std::numbers::pi * dice.uniform();
        sum += fall(run(parameters, servos, seed, 6.5, [](double) { return Command{.forward = 0.15}; },
                        {{when, 1.8, direction}}),
                    6.5);
      }
      std::array<Command, 6> commands;
      for (Command& command : commands)
        command = {-0.1 + 0.3 * dice.uniform(), -0.1 + 0.2 * dice.uniform(), -0.8 + 1.6 * dice.uniform()};
      const auto now = [&](double time) { return commands[static_cast<std::size_t>(time / 2) % commands.size()]; };
      sum += 2 * fall(run(parameters, servos, seed, 12, now, {}), 12);
    }
    return sum / robots;
  }

 private:
  static double fall(const Outcome& outcome, double duration) { return outcome.fell ? 2 - outcome.time / duration : 0; }

  Outcome run(const Parameters& parameters, Servos servos, std::uint64_t seed, double duration,
              const std::function<Command(double)>& command, std::vector<Push> pushes) {
    const DrawnRobot robot = draw_robot(seed, servos);
    OurGait gait(parameters);
    return robot::nao::walk::run(*physics_[robot.about_origin], gait, robot, seed, stand(parameters),
                                 parameters.hip_height,
                                 {.duration = duration, .command = command, .pushes = std::move(pushes)});
  }

  std::array<std::unique_ptr<Physics>, 2> physics_;
};

}  // namespace

int main(int count, char** words) {
  const int generations = count == 4 ? std::atoi(words[2]) : 0, robots = count == 4 ? std::atoi(words[3]) : 0;
  if (generations < 1 || robots < 2) {
    std::fprintf(stderr, "tune_walk: expected FIRST_SEED GENERATIONS ROBOTS, with at least 1 generation of 2 robots\n");
    return 2;
  }
  const std::uint64_t first_seed = std::strtoull(words[1], nullptr, 10);
  sim::learn::Cma search(sim::learn::Vector(kNumber, 0.0), 0.7, 12, first_seed);
  Judge judge;
  for (int generation = 0; generation < generations; ++generation) {
    std::vector<double> costs;
    for (const auto& point : search.ask())
      costs.push_back(judge.cost(at(point), first_seed + static_cast<std::uint64_t>(generation) * 1000, robots));
    search.tell(costs);
    const Parameters mean = at(search.mean());
    std::printf("// generation %d: best %.3f, worst %.3f, deviation %.3f\n", generation,
                *std::min_element(costs.begin(), costs.end()), *std::max_element(costs.begin(), costs.end()),
                search.deviation());
    for (const Knob& knob : kKnobs) std::printf("%s=%.4g ", knob.name, mean.*knob.place);
    std::puts("");
    std::fflush(stdout);
  }
  return 0;
}
