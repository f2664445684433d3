// tune_walk steps|kicks FIRST_SEED GENERATIONS ROBOTS: searches parameters by CMA-ES on drawn robots.
// Each generation meets robots of its own. Prints the mean of each generation, as words for bench_walk.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <span>
#include <string_view>

#include "robot/nao/walk/named_parameters.h"
#include "tests/walk/dice.h"
#include "tests/walk/our_gait.h"
#include "tests/walk/plans.h"
#include "tests/walk/search.h"

namespace {

using namespace robot::nao::walk;

/// A parameter that is searched, and its bounds.
struct Knob {
  std::string_view name;
  double least, most;
};

constexpr Knob kStepKnobs[] = {
    {"period", 0.23, 0.33},
    {"hip_height", 0.205, 0.228},
    {"ahead", 0, 0.025},
    {"wider", 0, 0.012},
    {"lift", 0.012, 0.03},
    {"landing", 0.7, 1},
    {"share", 0.15, 0.6},
    {"earliest", 0.4, 0.9},
    {"rate_to_ankle_pitch", 0, 0.15},
    {"rate_to_ankle_roll", 0, 0.15},
    {"rate_to_hip_pitch", 0, 0.15},
    {"tilt_to_ankle_pitch", 0, 0.5},
    {"tilt_to_ankle_roll", 0, 0.3},
    {"catch_forward", 0.3, 1.3},
    {"catch_forward_from", 0, 0.04},
    {"catch_forward_most", 0.05, 0.12},
    {"catch_side", 0.3, 1.5},
    {"catch_side_from", 0, 0.05},
    {"counter", 0, 3},
    {"counter_from", 0.02, 0.1},
    {"catch_speed", 0.3, 1.5},
    {"fights_from", 0.015, 0.06},
    {"calm_share", 0.1, 0.8},
    {"smoothing", 0, 0.7},
    {"lookahead", 0, 3},
    {"side_speed", 0.5, 1.5},
    {"counter_most", 0.05, 0.15},
    {"learning", 0.03, 0.25},
    {"sag_learning", 0.002, 0.03},
    {"sag_rise", 0.1, 1},
    {"longer", 0, 0.25},
    {"lag_share", 0.2, 1},
    {"lead_most", 0.04, 0.2},
};
constexpr Knob kKickKnobs[] = {
    {"kick_period", 0.25, 0.5}, {"kick_ahead", 0.06, 0.2}, {"kick_from", 0.05, 0.5},
    {"kick_contact", 0.3, 0.8}, {"kick_over", 0.6, 1.4},   {"kick_lift", 0, 0.03},
};
static_assert(std::ranges::all_of(kStepKnobs, parameter_named, &Knob::name) &&
              std::ranges::all_of(kKickKnobs, parameter_named, &Knob::name));
constexpr double kPart = 10;  // a search step of 1 is this part of a knob's range

Parameters at(std::span<const Knob> knobs, const sim::learn::Vector& point) {
  Parameters parameters;
  for (std::size_t i = 0; i < knobs.size(); ++i) {
    const Knob& knob = knobs[i];
    const auto place = parameter_named(knob.name);
    const double start = Parameters{}.*place, unit = (knob.most - knob.least) / kPart;
    parameters.*place = std::clamp(start + unit * point[i], knob.least, knob.most);
  }
  return parameters;
}

/// Lets robots walk on carpet and turf, also late ones, be pushed and obey quick commands. Falls cost most, earlier ones
/// more; then missing speed.
class Judge {
 public:
  Judge() {
    for (const bool turf : {false, true})
      for (const bool about_origin : {false, true})
        physics_[turf][about_origin] = std::make_unique<Physics>(Scene{.turf = turf, .about_origin = about_origin});
    for (const bool about_origin : {false, true})
      with_ball_[about_origin] = std::make_unique<Physics>(Scene{.ball = true, .about_origin = about_origin});
  }

  /// The cost of kicks: falls, missed balls and slow ones.
  double cost_of_kicks(const Parameters& parameters, std::uint64_t first_seed, int robots) {
    double sum = 0;
    for (int i = 0; i < 2 * robots; ++i) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i / 2);
      const DrawnRobot robot = draw_robot(seed, i % 2 == 0 ? Servos::stiff : Servos::soft);
      OurGait gait(parameters);
      const Plan plan = kick_plan({}, seed);
      const Outcome outcome = robot::nao::walk::run(*with_ball_[robot.about_origin], gait, robot, seed,
                                                    stand(parameters), parameters.hip_height, plan);
      sum += 5 * fall(outcome, plan.duration) + std::max(0.0, 1.5 - outcome.ball_speed) +
             (outcome.ball_speed < 0.2 ? 1 : 0);
    }
    return sum / robots;
  }

  double cost_of_steps(const Parameters& parameters, std::uint64_t first_seed, int robots) {
    double sum = 0;
    for (int i = 0; i < robots; ++i) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
      const DrawnRobot robot = draw_robot(seed, i % 2 == 0 ? Servos::stiff : Servos::soft);
      Dice dice(seed);
      DrawnRobot hard = robot;
      if (i / 2 % 2 == 0)
        hard.delay += 0.02;
      else
        hard.turf = 0.008;
      for (const DrawnRobot& one : {robot, hard}) {
        const Outcome walk = run(parameters, one, seed, 12, [](double) { return Command{.forward = 0.2}; }, {});
        sum += fall(walk, 12) + missing(walk, walk.forward, 0.19);
      }
      const Outcome side = run(parameters, robot, seed, 7, [](double) { return Command{.left = 0.1}; }, {});
      sum += fall(side, 7) + missing(side, side.left, 0.09);
      for (int push = 0; push < 3; ++push) {
        const double when = 2.5 + dice.uniform(), direction = 2 * std::numbers::pi * dice.uniform();
        sum += fall(
            run(parameters, robot, seed, 6, [](double) { return Command{.forward = 0.15}; }, {{when, 1.8, direction}}),
            6);
      }
      std::array<Command, 5> commands;
      for (Command& command : commands)
        command = {-0.1 + 0.3 * dice.uniform(), -0.1 + 0.2 * dice.uniform(), -0.8 + 1.6 * dice.uniform()};
      const auto now = [&](double time) { return commands[static_cast<std::size_t>(time / 2) % commands.size()]; };
      sum += 2 * fall(run(parameters, robot, seed, 10, now, {}), 10);
    }
    return sum / robots;
  }

 private:
  static double fall(const Outcome& outcome, double duration) { return outcome.fell ? 2 - outcome.time / duration : 0; }

  /// Returns the cost of a way that is too short for `speed` [m/s].
  static double missing(const Outcome& outcome, double way, double speed) {
    return 4 * std::max(0.0, 1 - (outcome.measured > 0 ? way / outcome.measured : 0) / speed);
  }

  Outcome run(const Parameters& parameters, const DrawnRobot& robot, std::uint64_t seed, double duration,
              const std::function<Command(double)>& command, std::vector<Push> pushes) {
    OurGait gait(parameters);
    return robot::nao::walk::run(*physics_[robot.turf > 0][robot.about_origin], gait, robot, seed, stand(parameters),
                                 parameters.hip_height,
                                 {.duration = duration, .command = command, .pushes = std::move(pushes)});
  }

  std::array<std::array<std::unique_ptr<Physics>, 2>, 2> physics_;  // by turf, by the reading of the inertias
  std::array<std::unique_ptr<Physics>, 2> with_ball_;               // by the reading of the inertias
};

}  // namespace

int main(int count, char** words) {
  const std::string_view what = count == 5 ? words[1] : "";
  const int generations = count == 5 ? std::atoi(words[3]) : 0, robots = count == 5 ? std::atoi(words[4]) : 0;
  if ((what != "steps" && what != "kicks") || generations < 1 || robots < 2) {
    std::fprintf(stderr,
                 "tune_walk: expected steps|kicks FIRST_SEED GENERATIONS ROBOTS, with at least 1 generation "
                 "of 2 robots\n");
    return 2;
  }
  const std::span<const Knob> knobs = what == "steps" ? std::span<const Knob>(kStepKnobs) : kKickKnobs;
  const auto cost = what == "steps" ? &Judge::cost_of_steps : &Judge::cost_of_kicks;
  const std::uint64_t first_seed = std::strtoull(words[2], nullptr, 10);
  std::array<Judge, 2> judges;
  const Search search{
      .dimensions = knobs.size(), .step = 0.7, .population = 16, .first_seed = first_seed, .generations = generations};
  run(
      search, judges,
      [&](Judge& judge, const sim::learn::Vector& point, std::uint64_t seed) {
        return (judge.*cost)(at(knobs, point), seed, robots);
      },
      [&](const sim::learn::Vector& mean) {
        const Parameters parameters = at(knobs, mean);
        for (const Knob& knob : knobs)
          std::printf("%s=%.4g ", knob.name.data(), parameters.*parameter_named(knob.name));
        std::puts("");
      });
  return 0;
}
