#include "robot/app/run_simulation.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robot/agent/agent.h"
#include "robot/app/runtime.h"
#include "robot/app/services/foresight_service.h"
#include "robot/app/services/futures_service.h"
#include "robot/app/services/reasons_service.h"
#include "robot/app/services/simulation_service.h"
#include "robot/body/sim/sim_body.h"
#include "robot/core/report.h"
#include "robot/foresight/following.h"
#include "sim/io/matchup.h"

namespace robot::app {
namespace {

Result<body::GameSetup> setup_of(const RobotOptions& options, sim::Side side) {
  // every robot decides at 30 Hz, as on a real robot
  const std::string rules = rules_of(options);
  auto game = sim::io::prepare({.rules = rules,
                                .strategies = {options.home, options.away},
                                .models = {models_of(options, sim::Side::home), models_of(options, sim::Side::away)},
                                .pace = sim::Pace::every_tick});
  if (!game) return game.failure();
  const auto own = static_cast<std::uint32_t>(robot_named_by(options).team);
  const auto opponent = static_cast<std::uint32_t>(options.opponent);
  const bool home = side == sim::Side::home;
  return body::GameSetup{
      .game = std::move(*game),
      .names = {.rules = rules, .teams = {.home = home ? own : opponent, .away = home ? opponent : own}}};
}

/// Makes the own side follow its captain's choice among `strategies`, if the own side plays the first of them.
/// Otherwise reports a warning and changes nothing.
Result<void> follow_captain(const std::vector<std::string>& strategies, const RobotOptions& options, sim::Side side,
                            sim::io::PreparedGame& game) {
  const std::string& own = own_strategy_of(options);
  if (own != strategies.front()) {
    report(Level::warning, "foresight",
           "the own side plays " + own + ", but the first of --strategies is " + strategies.front() +
               ": it does not follow the captain's choice");
    return {};
  }
  auto follower = agent::follower_of(strategies, foreseeing::Following::kStaleTicks);
  if (!follower) return follower.failure();
  const auto index = static_cast<std::size_t>(side);
  game.behaviours[index] = std::move(*follower);
  game.params.teams[index].behaviour = game.behaviours[index].get();
  return {};
}

}  // namespace

Result<void> run_simulation(const RobotOptions& options) {
  const RobotName robot = robot_named_by(options);
  const sim::Side side = own_side_of(options);
  if (robot.player > sim::kMaxPlayers)
    return Error{"--player: body sim has players 1 .. " + std::to_string(sim::kMaxPlayers) + ", got " +
                 std::to_string(robot.player)};
  if (options.game_controller) return Error{"--game-controller: not with body sim, which plays a game of its own"};
  Result<body::GameSetup> setup = setup_of(options, side);
  if (!setup) return setup.failure();
  const foreseeing::ForeseerOptions foreseeing = foreseer_options(options);
  if (Result<void> led = follow_captain(foreseeing.strategies, options, side, setup->game); !led) return led;

  const SessionClock clock;
  auto body = body::SimBody::open(
      std::move(*setup),
      {.robot = sim::robot_of(side, robot.player), .seed = options.seed, .speed = options.speed, .loop = options.loop},
      clock);
  if (!body) return body.failure();
  Runtime runtime(runtime_options(options, robot), clock, own_objects(*(*body)->memory()));
  if (Result<void> listed = (*body)->list(runtime.channels()); !listed) return listed;
  add_simulation_service(**body, runtime.services());
  std::vector<std::string> trees = foreseeing.strategies;
  trees.insert(trees.end(), {options.home, options.away});
  add_reasons_service(runtime.services(), runtime.channels(), {.strategies = trees, .rules = {}});
  add_futures_service(runtime.services(), runtime.channels(),
                      {.strategies = std::move(trees), .rules = {}, .game = body->get()});
  // time of foresight: it stops while the game is paused
  const auto shown_ns = [&simulation = (*body)->memory()->simulation] { return simulation.read()->capture_ns(); };
  const auto foresight = ForesightService::open(foreseeing, options.foresight.value_or(true), runtime,
                                                *(*body)->memory(), robot.text(), shown_ns);
  if (!foresight) return foresight.failure();
  const Result<bool> begun = begin(runtime, options);
  if (!begun) return begun.failure();
  if (!*begun) return {};
  if (Result<void> started = (*body)->start(); !started) return started;
  runtime.run([] { return true; });
  (*body)->stop();
  return {};
}

}  // namespace robot::app
