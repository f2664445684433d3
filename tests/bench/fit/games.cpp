// Whole recordings of simulated games: perception, packet loss, and a truth with errors of 2 cm and 20 ms.
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <string>

#include "robot/core/text.h"
#include "robot/fit/ball_noise/ball_noise.h"
#include "robot/fit/ball_noise/latency.h"
#include "robot/fit/falling/falling.h"
#include "robot/fit/localisation/localisation.h"
#include "robot/fit/localisation/odometry.h"
#include "robot/fit/radio/radio.h"
#include "robot/fit/visibility/false_balls.h"
#include "robot/fit/visibility/visibility.h"
#include "robot/fit/walking/walking.h"
#include "sim/io/models.h"
#include "tests/bench/fit/planted.h"
#include "tests/support/simulated_robots.h"

namespace bench {
namespace {

constexpr double kHeadingError = 0.02;  // [rad] of the truth
constexpr double kSeconds = 240;

/// The planted values: others than those of the models that the fits begin with.
const std::map<std::string, double>& planted_values() {
  static const std::map<std::string, double> values{
      {"ball_detection.near", 0.8},
      {"ball_detection.far", 0.3},
      {"ball_detection.near_range", 2.8},
      {"ball_filter.false_per_second", 0.05},
      {"noise.tilt", 0.015},
      {"noise.tilt_walking", 0.025},
      {"noise.roll", 0.015},
      {"camera.latency", 2 / 30.},
      {"walk.forward", 0.3},
      {"walk.turn_rate", 1.0},
      {"walk.turn_cost", 0.6},
      {"walk.acceleration", 0.5},
      {"walk.turn_acceleration", 3},
      {"walk.start_delay", 8 / 30.},
      {"walk.stop_delay", 0.4},
      {"walk.spread", 0.4},
      {"falls.per_minute_walking", 0.6},
      {"falls.per_second_touching", 0.08},
      {"localisation.translation_noise", 0.08},
      {"localisation.rotation_noise", 0.08},
      {"localisation.rotation_per_metre", 0.06},
      {"localisation.fall_deviation", 0.4},
      {"localisation.mark_deviation", 0.1},
      {"radio.delay", 0.15},
      {"radio.loss", 0.25},
  };
  return values;
}

std::string planted_models() {
  std::string models = "match";
  for (const auto& [name, value] : planted_values()) models += robot::formatted(",%s=%.6g", name.c_str(), value);
  return models;
}

}  // namespace

void games(int repetitions) {
  const auto base = sim::io::load_models("match");
  if (!base) return void(std::cerr << base.error() << '\n');
  const auto folder = std::filesystem::temp_directory_path() / ("bench-fit-" + std::to_string(getpid()));
  Planted planted(planted_values(), "games: ");
  for (int i = 0; i < repetitions; ++i) {
    std::filesystem::remove_all(folder);
    const auto evidence = robot::tests::simulated_robots(folder, {.models = planted_models(),
                                                                  .seconds = kSeconds,
                                                                  .seed = 7000 + static_cast<std::uint64_t>(i),
                                                                  .place_error = kTruthError,
                                                                  .heading_error = kHeadingError,
                                                                  .clock_error = kClockError});
    planted.add(robot::fit::fit_ball_noise(evidence, *base));
    planted.add(robot::fit::fit_latency(evidence, *base));
    planted.add(robot::fit::fit_visibility(evidence, *base));
    planted.add(robot::fit::fit_false_balls(evidence, *base));
    planted.add(robot::fit::fit_walking(evidence, *base));
    planted.add(robot::fit::fit_falling(evidence, *base));
    planted.add(robot::fit::fit_radio(evidence, *base));
    planted.add(robot::fit::fit_odometry(evidence, *base));
    planted.add(robot::fit::fit_localisation(evidence, *base));
  }
  std::filesystem::remove_all(folder);
  planted.print();
}

}  // namespace bench
