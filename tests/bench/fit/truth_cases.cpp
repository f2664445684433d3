// Figures that the truth alone gives, from simulated games and planted touches.
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <string>

#include "robot/fit/falling/falling.h"
#include "robot/fit/opponents/opponents.h"
#include "robot/fit/rebounds/rebounds.h"
#include "robot/fit/rolling/rolling.h"
#include "sim/io/matchup.h"
#include "sim/match/step.h"
#include "tests/bench/fit/planted.h"
#include "tests/support/planted_touches.h"

namespace bench {
namespace {

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

}  // namespace

void rolling(int repetitions) {
  auto game = sim::io::prepare({});
  if (!game) return void(std::cerr << game.error() << '\n');
  constexpr double kPlanted = 0.36;
  for (sim::Team& team : game->params.teams) team.models.ball.deceleration = static_cast<float>(kPlanted);
  Planted planted({{"ball.deceleration", kPlanted}});
  for (int i = 0; i < repetitions; ++i) {
    robot::fit::Evidence evidence;
    evidence.games.push_back(std::make_shared<const robot::fit::TrueGame>(
        robot::fit::TrueGame{.name = "game", .record = true_game(game->params, static_cast<std::uint64_t>(i + 1))}));
    if (const auto fit = robot::fit::fit_rolling(evidence)) planted.add({fit->deceleration});
  }
  planted.print();
}

void rebounds(int repetitions) {
  const auto game = sim::io::prepare({});
  if (!game) return void(std::cerr << game.error() << '\n');
  Planted planted({{"ball.robot_restitution", 0.5}, {"ball.post_restitution", 0.6}, {"contact.push_deviation", 0.4}});
  for (int i = 0; i < repetitions; ++i) {
    robot::fit::Evidence evidence;
    evidence.games.push_back(std::make_shared<const robot::fit::TrueGame>(robot::fit::TrueGame{
        .name = "planted",
        .record = robot::tests::planted_touches({.truth_error = kTruthError, .posts = 20, .pushes = 60},
                                                900 + static_cast<std::uint64_t>(i))}));
    sim::Models models = game->params.teams[0].models;
    models.ball.radius = 0.05F;
    planted.add(robot::fit::fit_rebounds(evidence, models));
  }
  planted.print();
}

void falls(int repetitions) {
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
  Planted planted({{"falls.per_minute_walking", 0.5},
                   {"falls.per_second_touching", 0.06},
                   {"falls.down", 3.2 - 1 / 30.},
                   {"falls.failure", 0.15},
                   {"walk.forward", 0.3},
                   {"walk.spread", 0.4}});
  for (int i = 0; i < repetitions; ++i) {
    robot::fit::Evidence evidence;
    evidence.games.push_back(std::make_shared<const robot::fit::TrueGame>(
        robot::fit::TrueGame{.name = "game", .record = true_game(game->params, 5000 + static_cast<std::uint64_t>(i))}));
    planted.add(robot::fit::fit_falling(evidence, base));
    planted.add(robot::fit::fit_opponents(evidence, base));
  }
  planted.print();
}

}  // namespace bench
