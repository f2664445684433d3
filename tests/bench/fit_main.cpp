// How exact are fitted models, and how honest are their intervals? Planted parameters, fitted a hundred times.
//
//   bench_fit [REPETITIONS] [GAMES]
//
// Prints a line of JSON for each case:
//   study    the 460 images of the thesis from 0.5 to 3 m; errors of each curve on other recordings, also nearer and farther
//   kicks    50 kicks of a kind: errors of speed and direction, coverage and score of the landing points
//   planted  each fitted figure: share of intervals that cover the planted value, bias in parts of the interval
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/clock.h"
#include "robot/fit/ball_distance/ball_distance.h"
#include "robot/fit/ball_noise/ball_noise.h"
#include "robot/fit/ball_noise/image_noise.h"
#include "robot/fit/ball_noise/latency.h"
#include "robot/fit/falling/falling.h"
#include "robot/fit/kicks/kicks.h"
#include "robot/fit/opponents/opponents.h"
#include "robot/fit/rebounds/rebounds.h"
#include "robot/fit/radio/radio.h"
#include "robot/fit/rolling/rolling.h"
#include "robot/fit/visibility/false_balls.h"
#include "robot/fit/visibility/visibility.h"
#include "robot/fit/walking/walking.h"
#include "sim/io/matchup.h"
#include "sim/match/step.h"
#include "sim/statistics/sample.h"
#include "tests/support/planted_balls.h"
#include "tests/support/planted_kicks.h"
#include "tests/support/planted_sights.h"
#include "tests/support/planted_touches.h"
#include "tests/support/planted_packets.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/planted_looks.h"
#include "tests/support/planted_walks.h"

namespace {

using nlohmann::json;
using robot::fit::BallSize, robot::fit::Curve, robot::fit::CurveKind;
using robot::tests::planted_balls, robot::tests::PlantedBalls;

constexpr double kTruthError = 0.02;  // [m]
constexpr double kLate = 0.02;        // [s]

// --- the study of the thesis ---

double mean_error(const Curve& curve, const std::vector<BallSize>& sizes) {
  double sum = 0;
  for (const BallSize& size : sizes) sum += std::abs(curve.distance(size.radius) - size.distance);
  return sum / static_cast<double>(sizes.size());
}

void study(int repetitions) {
  constexpr std::pair<double, double> kRanges[] = {{0.5, 3}, {0.15, 0.5}, {3, 4.5}};
  std::vector<double> errors[3][3], seconds;
  for (int i = 0; i < repetitions; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const auto trained = planted_balls({.truth_error = kTruthError}, seed).sizes;
    const robot::fit::Group all = robot::fit::all_of(trained.size());
    const CurveKind kinds[] = {CurveKind::pinhole, CurveKind::power_law, CurveKind::constant};
    for (std::size_t range = 0; range < 3; ++range) {
      // the truth of the test is exact, so that its error is not counted
      const auto [nearest, farthest] = kRanges[range];
      const auto other =
          planted_balls({.nearest = nearest, .farthest = farthest, .truth_error = 0, .passes = 60}, 1'000'000 + seed);
      for (std::size_t kind = 0; kind < 3; ++kind)
        errors[kind][range].push_back(mean_error(robot::fit::fit_curve(kinds[kind], trained, all), other.sizes));
    }
    const std::uint64_t start_ns = robot::thread_cpu_ns();
    if (robot::fit::fit_ball_distance(planted_balls({.truth_error = kTruthError}, seed)))
      seconds.push_back(static_cast<double>(robot::thread_cpu_ns() - start_ns) * 1e-9);
  }
  json line{{"case", "study"}, {"images", 460}, {"seconds", sim::statistics::median(seconds)}};
  const char* names[] = {"pinhole", "power_law", "constant"};
  const char* ranges[] = {"in_range_cm", "near_cm", "far_cm"};
  for (std::size_t kind = 0; kind < 3; ++kind)
    for (std::size_t range = 0; range < 3; ++range)
      line[names[kind]][ranges[range]] = 100 * sim::statistics::mean_of(errors[kind][range]);
  std::cout << line.dump() << '\n';
}

// --- planted parameters ---

/// The fits of one figure.
struct Tally {
  sim::statistics::Share covered;
  std::vector<double> bias, half_widths;

  void add(const robot::fit::Figure& figure, double planted) {
    covered.add(planted >= figure.low && planted <= figure.high);
    bias.push_back(figure.value - planted);
    half_widths.push_back((figure.high - figure.low) / 2);
  }

  void print(const std::string& name, double planted) const {
    const double half = sim::statistics::mean_of(half_widths);
    std::cout << json{{"case", "planted"},
                      {"figure", name},
                      {"planted", planted},
                      {"repetitions", covered.cases},
                      {"coverage", covered.value()},
                      {"half_width", half},
                      {"bias", sim::statistics::mean_of(bias)},
                      {"bias_share", std::abs(sim::statistics::mean_of(bias)) / (2 * half)}}
                     .dump()
              << '\n';
  }
};

void ball_distance(int repetitions) {
  const PlantedBalls planted{.truth_error = kTruthError};
  Tally tallies[3];
  std::vector<std::string> names;
  std::mt19937 random(1);
  for (int i = 0; i < repetitions; ++i) {
    PlantedBalls late = planted;
    // the clock's error is one that its interval of 20 ms covers in 95 % of all recordings
    late.late = kLate / 1.96 * std::normal_distribution<double>()(random);
    auto seen = planted_balls(late, 100 + static_cast<std::uint64_t>(i));
    seen.clock_deviation = {kLate / 1.96};
    const auto fit = robot::fit::fit_ball_distance(std::move(seen));
    if (!fit) continue;
    const double values[] = {planted.scale, planted.offset, planted.height};
    names.clear();
    for (std::size_t k = 0; k < 3; ++k) {
      tallies[k].add(fit->figures[k], values[k]);
      names.push_back(fit->figures[k].name);
    }
  }
  const double values[] = {planted.scale, planted.offset, planted.height};
  for (std::size_t k = 0; k < names.size(); ++k) tallies[k].print(names[k], values[k]);
}

/// Returns the ground truth of a simulated game with an error.
robot::lab::TruthRecord true_game(const sim::Params& params, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, kTruthError);
  robot::lab::TruthRecord record;
  record.ball_deviation = kTruthError;
  sim::referee::Events events;
  sim::State state = sim::begin(params, sim::RandomKey{seed}, events);
  const auto place = [&](double at, const sim::Vec2& position) {
    return robot::lab::PlaceAt{.at = at, .x = position.x + normal(random), .y = position.y + normal(random)};
  };
  for (int robot = 0; robot < 2 * sim::kMaxPlayers; ++robot)
    record.robots.push_back({.name = std::to_string(robot), .path = {}});
  for (double at = 0; !sim::finished(state); at += 1 / 30.) {
    record.ball.push_back(place(at, state.world.ball.position));
    record.sightings.push_back({.at = at, .seen = true});
    for (int robot = 0; robot < 2 * sim::kMaxPlayers; ++robot) {
      if (sim::player_of(robot) > params.rules.players) continue;
      if (const sim::Body& body = state.world.bodies[robot]; body.doing != sim::Body::Doing::removed) {
        auto& path = record.robots[static_cast<std::size_t>(robot)].path;
        path.push_back(place(at, body.position));
        path.back().heading = static_cast<double>(body.heading), path.back().fallen = sim::lies(body);
      }
    }
    sim::step(params, state, events);
  }
  return record;
}

void rolling(int repetitions, int games) {
  auto game = sim::io::prepare({});
  if (!game) return void(std::cerr << game.error() << '\n');
  constexpr double kPlanted = 0.36;
  for (sim::Team& team : game->params.teams) team.models.ball.deceleration = static_cast<float>(kPlanted);
  Tally tally;
  for (int i = 0; i < repetitions; ++i) {
    robot::fit::Evidence evidence;
    for (int k = 0; k < games; ++k)
      evidence.games.push_back(std::make_shared<const robot::fit::TrueGame>(
          robot::fit::TrueGame{.name = "game " + std::to_string(k),
                               .record = true_game(game->params, static_cast<std::uint64_t>(games * i + k + 1))}));
    if (const auto fit = robot::fit::fit_rolling(evidence)) tally.add(fit->deceleration, kPlanted);
  }
  tally.print("ball.deceleration", kPlanted);
}

// --- the truth alone ---

/// Adds the planted figures that a report has.
void add_planted(const robot::fit::Report& report, const std::map<std::string, double>& planted,
                 std::map<std::string, Tally>& tallies) {
  for (const robot::fit::Figure& figure : report.figures)
    if (const auto value = planted.find(figure.name); value != planted.end())
      tallies[figure.name].add(figure, value->second);
}

void print_all(const std::map<std::string, Tally>& tallies, const std::map<std::string, double>& planted) {
  for (const auto& [name, tally] : tallies) tally.print(name, planted.at(name));
}

void rebounds(int repetitions) {
  const auto game = sim::io::prepare({});
  if (!game) return void(std::cerr << game.error() << '\n');
  const std::map<std::string, double> planted{
      {"ball.robot_restitution", 0.5}, {"ball.post_restitution", 0.6}, {"contact.push_deviation", 0.4}};
  std::map<std::string, Tally> tallies;
  for (int i = 0; i < repetitions; ++i) {
    robot::fit::Evidence evidence;
    evidence.games.push_back(std::make_shared<const robot::fit::TrueGame>(robot::fit::TrueGame{
        .name = "planted",
        .record = robot::tests::planted_touches({.truth_error = kTruthError, .posts = 20, .pushes = 60},
                                                900 + static_cast<std::uint64_t>(i))}));
    sim::Models models = game->params.teams[0].models;
    models.ball.radius = 0.05F;
    add_planted(robot::fit::fit_rebounds(evidence, models), planted, tallies);
  }
  print_all(tallies, planted);
}

/// Falls and speeds of whole games: two halves of five a side, seen from outside.
void falls_and_speeds(int repetitions) {
  auto game = sim::io::prepare({.rules = "spl2025", .players = 5, .pace = sim::Pace::every_tick});
  if (!game) return void(std::cerr << game.error() << '\n');
  const sim::Models base = game->params.teams[0].models;
  for (sim::Team& team : game->params.teams) {
    team.models.effects.falls = true;
    team.models.motion.falls = {
        .per_minute_walking = 0.5F, .per_second_touching = 0.06F, .lying = 1.2F, .getting_up = 2, .failure = 0.15F};
    team.models.motion.walk.forward = 0.3F, team.models.motion.walk.spread = 0.4F;
  }
  // an image less than 3.2 s: the tick in which a robot falls still shows it upright
  const std::map<std::string, double> planted{{"falls.per_minute_walking", 0.5},
                                              {"falls.per_second_touching", 0.06},
                                              {"falls.down", 3.2 - 1 / 30.},
                                              {"falls.failure", 0.15},
                                              {"walk.forward", 0.3},
                                              {"walk.spread", 0.4}};
  std::map<std::string, Tally> tallies;
  for (int i = 0; i < repetitions; ++i) {
    robot::fit::Evidence evidence;
    evidence.games.push_back(std::make_shared<const robot::fit::TrueGame>(
        robot::fit::TrueGame{.name = "game", .record = true_game(game->params, 5000 + static_cast<std::uint64_t>(i))}));
    add_planted(robot::fit::fit_falling(evidence, base), planted, tallies);
    add_planted(robot::fit::fit_opponents(evidence, base), planted, tallies);
  }
  print_all(tallies, planted);
}

// --- kicks ---

robot::fit::KickFit tracked_kicks(const robot::tests::KickedBalls& game) {
  const robot::fit::KickKind kind{.name = "forward", .ball_x = 0.18, .ball_y = 0.05, .gate_x = 0.1, .gate_y = 0.1};
  robot::fit::KickFit seen;
  seen.kind = kind.name;
  seen.slowest = std::sqrt(2 * 0.3 * 3 * kTruthError);
  for (const robot::fit::KickRun& run : game.runs) {
    const auto kick = robot::fit::tracked(game.truth, game.robot, run, kind, 0.3);
    if (const auto* good = std::get_if<robot::fit::TrackedKick>(&kick)) seen.kicks.push_back(*good);
  }
  return seen;
}

void kicks(int repetitions, double partial) {
  robot::tests::PlantedKicks planted{.truth_error = kTruthError};
  planted.model.partial = partial;
  const robot::fit::KickModel& model = planted.model;
  const double values[] = {model.speed * model.speed / 0.6, model.range_deviation, model.direction,
                           model.direction_deviation, planted.delay};
  std::vector<Tally> tallies(5);
  Tally partials;
  std::vector<double> speeds, directions, covered, scores;
  for (int i = 0; i < repetitions; ++i) {
    const auto fit =
        robot::fit::fit_kind(tracked_kicks(robot::tests::kicked_balls(planted, 500 + static_cast<std::uint64_t>(i))),
                             {"planted"}, {.kinds = {}, .deceleration = 0.3, .spread = planted.spread});
    if (!fit) continue;
    for (std::size_t k = 0; k < tallies.size(); ++k) tallies[k].add(fit->figures[k], values[k]);
    partials.add(fit->partial, partial);
    speeds.push_back(100 * std::abs(fit->model.speed / model.speed - 1));
    directions.push_back(std::abs(fit->model.direction - model.direction) * 180 / 3.14159265);
    covered.push_back(100 * fit->covered);
    scores.push_back(fit->crps / fit->constant_error);
  }
  std::cout << json{{"case", "kicks"},
                    {"partial", partial},
                    {"repetitions", speeds.size()},
                    {"speed_percent", sim::statistics::quantile(speeds, 0.95)},
                    {"direction_degrees", sim::statistics::quantile(directions, 0.95)},
                    {"covered_percent", sim::statistics::mean_of(covered)},
                    {"crps_share", sim::statistics::mean_of(scores)}}
                   .dump()
            << '\n';
  const std::string name =
      partial > 0 ? "kick, " + std::to_string(static_cast<int>(100 * partial)) + " % partial: " : "kick: ";
  const char* names[] = {"range", "range_deviation", "direction", "direction_deviation", "delay"};
  for (std::size_t k = 0; k < tallies.size(); ++k) tallies[k].print(name + names[k], values[k]);
  if (partial > 0) partials.print(name + "partial", partial);
}

// --- places of the ball ---

void sights(int repetitions) {
  const auto game = sim::io::prepare({});
  if (!game) return void(std::cerr << game.error() << '\n');
  const sim::Models& base = game->params.teams[0].models;
  const robot::tests::PlantedSights planted{
      .pixels = robot::fit::image_facts(base).pixels, .truth_error = kTruthError, .late = kLate / 1.96};
  const std::pair<const char*, double> values[] = {{"noise.tilt", planted.tilt},
                                                   {"noise.tilt_walking", planted.tilt_walking},
                                                   {"noise.roll", planted.roll},
                                                   {"camera.latency", planted.lag}};
  std::vector<Tally> tallies(std::size(values));
  for (int i = 0; i < repetitions; ++i) {
    const auto seen = robot::tests::planted_sights(planted, 900 + static_cast<std::uint64_t>(i));
    const robot::fit::BallPlaces places = robot::fit::beside_truth(seen.seen);
    for (const robot::fit::Report& report :
         {robot::fit::fit_ball_noise(places, base), robot::fit::fit_latency(places, base)})
      for (const robot::fit::Figure& figure : report.figures)
        for (std::size_t k = 0; k < tallies.size(); ++k)
          if (figure.name == values[k].first) tallies[k].add(figure, values[k].second);
  }
  for (std::size_t k = 0; k < tallies.size(); ++k) tallies[k].print(values[k].first, values[k].second);
// --- radio ---

void radio(int repetitions, bool ticks, double clock_error) {
  const robot::tests::PlantedPackets planted{.clock_error = clock_error, .ticks = ticks};
  Tally delay, loss;
  for (int i = 0; i < repetitions; ++i) {
    const auto report = robot::fit::fit_packets(
        robot::tests::planted_packets(planted, 900 + static_cast<std::uint64_t>(i)), {.delay = 0.1f, .loss = 0.1f});
    for (const robot::fit::Figure& figure : report.figures) {
      if (figure.name == "radio.delay") delay.add(figure, planted.delay);
      if (figure.name == "radio.loss") loss.add(figure, planted.loss);
    }
  }
  const std::string name = ticks ? "simulated packets: " : "packets: ";
  delay.print(name + "radio.delay", planted.delay);
  loss.print(name + "radio.loss", planted.loss);
}

/// The same from recordings of simulated games, each of two minutes.
void radio_in_games(int repetitions) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("bench-radio-" + std::to_string(getpid()));
  Tally delay, loss;
  for (int i = 0; i < repetitions; ++i) {
    std::filesystem::remove_all(folder);
    const auto evidence = robot::tests::simulated_robots(folder, {.models = "match,radio.delay=0.15,radio.loss=0.25",
                                                                  .seconds = 120,
                                                                  .seed = 300 + static_cast<std::uint64_t>(i),
                                                                  .place_error = kTruthError,
                                                                  .clock_error = kLate / 1.96});
    for (const robot::fit::Figure& figure : robot::fit::fit_radio(evidence, {}).figures) {
      if (figure.name == "radio.delay") delay.add(figure, 0.15);
      if (figure.name == "radio.loss") loss.add(figure, 0.25);
    }
  }
  std::filesystem::remove_all(folder);
  delay.print("games: radio.delay", 0.15);
  loss.print("games: radio.loss", 0.25);
}

void radio(int repetitions) {
  radio(repetitions, true, 0);
  radio(repetitions, false, kLate / 1.96);
  radio_in_games(std::min(repetitions, 20));
// --- which balls are seen ---

/// Adds the figures of a report whose values are planted.
void add_planted(const robot::fit::Report& report, const std::vector<std::pair<std::string, double>>& values,
                 std::vector<Tally>& tallies) {
  tallies.resize(values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    for (const robot::fit::Figure& figure : report.figures)
      if (figure.name == values[k].first) tallies[k].add(figure, values[k].second);
}

void print_planted(const std::vector<std::pair<std::string, double>>& values, const std::vector<Tally>& tallies) {
  for (std::size_t k = 0; k < tallies.size(); ++k)
    if (!tallies[k].bias.empty()) tallies[k].print(values[k].first, values[k].second);
}

void visibility(int repetitions) {
  const sim::Models base = robot::tests::planted_base();
  const std::vector<std::pair<std::string, double>> curve{
      {"ball_detection.near", 0.8}, {"ball_detection.far", 0.3}, {"ball_detection.near_range", 2.5}};
  const robot::fit::Logistic::Features weights{2, 0.3, -0.15, -1, 0.5, -0.4, -1.5};
  const std::vector<std::pair<std::string, double>> logistic{{"visibility.constant", weights[0]},
                                                             {"visibility.distance", weights[1]},
                                                             {"visibility.distance_squared", weights[2]},
                                                             {"visibility.bearing", weights[3]},
                                                             {"visibility.bearing_squared", weights[4]},
                                                             {"visibility.head_speed", weights[5]},
                                                             {"visibility.hidden", weights[6]}};
  const std::vector<std::pair<std::string, double>> wrong{{"ball_filter.false_per_second", 0.05}};
  std::vector<Tally> of_curve, of_logistic, of_wrong;
  for (int i = 0; i < repetitions; ++i) {
    const auto seed = 900 + static_cast<std::uint64_t>(i);
    add_planted(robot::fit::visibility_of(
                    robot::tests::planted_detections({.near = 0.8, .far = 0.3, .near_range = 2.5}, seed), base),
                curve, of_curve);
    add_planted(robot::fit::visibility_of(robot::tests::planted_logistic(weights, 150, seed), base), logistic,
                of_logistic);
    add_planted(robot::fit::false_balls_of(robot::tests::planted_looks({}, seed), base), wrong, of_wrong);
  }
  print_planted(curve, of_curve);
  print_planted(logistic, of_logistic);
  print_planted(wrong, of_wrong);
// --- walking ---

/// Fits drills of six robots, twenty minutes in all, from other models.
void walking(int repetitions) {
  robot::tests::PlantedWalks planted{
      .robots = 6, .seconds = 200, .late = kLate / 1.96, .clock_deviation = kLate / 1.96};
  planted.models.effects.walk_spread = true;
  sim::Models base = planted.models;
  sim::motion::Walk& other = base.motion.walk;
  for (float* const value : {&other.forward, &other.backward, &other.sideward, &other.acceleration}) *value *= 1.2f;
  other.turn_rate = 1.222f, other.turn_cost = 0.73f, other.start_delay = 0.25f, other.spread = 0.5f;
  const sim::motion::Walk& walk = planted.models.motion.walk;
  const std::pair<const char*, float> values[] = {
      {"walk.forward", walk.forward},         {"walk.backward", walk.backward},
      {"walk.sideward", walk.sideward},       {"walk.turn_rate", walk.turn_rate},
      {"walk.turn_cost", walk.turn_cost},     {"walk.acceleration", walk.acceleration},
      {"walk.start_delay", walk.start_delay}, {"walk.turn_acceleration", walk.turn_acceleration},
      {"walk.stop_delay", walk.stop_delay},   {"walk.speed_noise", walk.speed_noise},
      {"walk.turn_noise", walk.turn_noise},   {"walk.spread", walk.spread}};
  std::vector<Tally> tallies(std::size(values));
  for (int i = 0; i < repetitions; ++i) {
    const auto drills = robot::tests::walked_drills(planted, 1000 + static_cast<std::uint64_t>(i));
    const auto report = robot::fit::fit_walking(robot::tests::drives_of(drills, planted.clock_deviation), base);
    for (std::size_t k = 0; k < tallies.size(); ++k)
      for (const robot::fit::Figure& figure : report.figures)
        if (figure.name == values[k].first) tallies[k].add(figure, static_cast<double>(values[k].second));
  }
  for (std::size_t k = 0; k < tallies.size(); ++k)
    tallies[k].print(values[k].first, static_cast<double>(values[k].second));
}

}  // namespace

int main(int count, char** words) {
  const int repetitions = count > 1 ? std::atoi(words[1]) : 100;
  const int games = count > 2 ? std::atoi(words[2]) : 1;
  study(std::min(repetitions, 40));
  ball_distance(repetitions);
  rolling(repetitions, games);
  rebounds(repetitions);
  falls_and_speeds(std::min(repetitions, 40));
  kicks(repetitions, 0);
  kicks(repetitions, 0.6);
  sights(repetitions);
  radio(repetitions);
  visibility(repetitions);
  walking(std::min(repetitions, 100));
  return 0;
}
