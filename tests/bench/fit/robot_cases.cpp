// Figures of robots beside the truth: percepts, packets and drills, planted one by one.
#include <iostream>
#include <utility>
#include <vector>

#include "robot/fit/ball_noise/ball_noise.h"
#include "robot/fit/ball_noise/image_noise.h"
#include "robot/fit/ball_noise/latency.h"
#include "robot/fit/radio/radio.h"
#include "robot/fit/visibility/false_balls.h"
#include "robot/fit/visibility/visibility.h"
#include "robot/fit/walking/walking.h"
#include "sim/io/models.h"
#include "tests/bench/fit/planted.h"
#include "tests/support/planted_looks.h"
#include "tests/support/planted_packets.h"
#include "tests/support/planted_sights.h"
#include "tests/support/planted_walks.h"

namespace bench {
namespace {

std::uint64_t seed_of(int repetition) { return 900 + static_cast<std::uint64_t>(repetition); }

/// Packets with exact times, or with those of whole ticks as in recordings of simulated games.
void packets(int repetitions, bool ticks) {
  const robot::tests::PlantedPackets sent{.clock_error = kClockError, .ticks = ticks};
  Planted planted({{"radio.delay", sent.delay}, {"radio.loss", sent.loss}}, ticks ? "in ticks: " : "");
  for (int i = 0; i < repetitions; ++i)
    planted.add(
        robot::fit::fit_packets(robot::tests::planted_packets(sent, seed_of(i)), {.delay = 0.1f, .loss = 0.1f}));
  planted.print();
}

}  // namespace

void sights(int repetitions) {
  const auto base = sim::io::load_models("match");
  if (!base) return void(std::cerr << base.error() << '\n');
  const robot::tests::PlantedSights seen{
      .pixels = robot::fit::image_facts(*base).pixels, .truth_error = kTruthError, .late = kClockError};
  Planted planted({{"noise.tilt", seen.tilt},
                   {"noise.tilt_walking", seen.tilt_walking},
                   {"noise.roll", seen.roll},
                   {"camera.latency", seen.lag}});
  for (int i = 0; i < repetitions; ++i) {
    const auto games = robot::tests::planted_sights(seen, seed_of(i));
    const robot::fit::BallPlaces places = robot::fit::beside_truth(games.seen);
    planted.add(robot::fit::fit_ball_noise(places, *base));
    planted.add(robot::fit::fit_latency(places, *base));
  }
  planted.print();
}

void visibility(int repetitions) {
  const sim::Models base = robot::tests::planted_base();
  const robot::fit::Logistic::Features weights{2, 0.3, -0.15, -1, 0.5, -0.4, -1.5};
  Planted curve({{"ball_detection.near", 0.8}, {"ball_detection.far", 0.3}, {"ball_detection.near_range", 2.5}});
  Planted logistic({{"visibility.constant", weights[0]},
                    {"visibility.distance", weights[1]},
                    {"visibility.distance_squared", weights[2]},
                    {"visibility.bearing", weights[3]},
                    {"visibility.bearing_squared", weights[4]},
                    {"visibility.head_speed", weights[5]},
                    {"visibility.hidden", weights[6]}});
  Planted wrong({{"ball_filter.false_per_second", 0.05}});
  for (int i = 0; i < repetitions; ++i) {
    const auto detections = robot::tests::planted_detections({.near = 0.8, .far = 0.3, .near_range = 2.5}, seed_of(i));
    curve.add(robot::fit::visibility_of(detections, base));
    logistic.add(robot::fit::visibility_of(robot::tests::planted_logistic(weights, 150, seed_of(i)), base));
    wrong.add(robot::fit::false_balls_of(robot::tests::planted_looks({}, seed_of(i)), base));
  }
  curve.print(), logistic.print(), wrong.print();
}

void radio(int repetitions) {
  packets(repetitions, false);
  packets(repetitions, true);
}

/// Drills of six robots, twenty minutes in all, fitted from other models.
void walking(int repetitions) {
  robot::tests::PlantedWalks drill{.robots = 6, .seconds = 200, .late = kClockError, .clock_deviation = kClockError};
  drill.models.effects.walk_spread = true;
  sim::Models base = drill.models;
  sim::motion::Walk& other = base.motion.walk;
  for (float* const value : {&other.forward, &other.backward, &other.sideward, &other.acceleration}) *value *= 1.2f;
  other.turn_rate = 1.222f, other.turn_cost = 0.73f, other.start_delay = 0.25f, other.spread = 0.5f;
  const sim::motion::Walk& walk = drill.models.motion.walk;
  Planted planted({{"walk.forward", walk.forward},
                   {"walk.backward", walk.backward},
                   {"walk.sideward", walk.sideward},
                   {"walk.turn_rate", walk.turn_rate},
                   {"walk.turn_cost", walk.turn_cost},
                   {"walk.acceleration", walk.acceleration},
                   {"walk.start_delay", walk.start_delay},
                   {"walk.turn_acceleration", walk.turn_acceleration},
                   {"walk.stop_delay", walk.stop_delay},
                   {"walk.speed_noise", walk.speed_noise},
                   {"walk.turn_noise", walk.turn_noise},
                   {"walk.spread", walk.spread}},
                  "drill: ");
  for (int i = 0; i < repetitions; ++i) {
    const auto drills = robot::tests::walked_drills(drill, seed_of(i));
    planted.add(robot::fit::fit_walking(robot::tests::drives_of(drills, drill.clock_deviation), base));
  }
  planted.print();
}

}  // namespace bench
