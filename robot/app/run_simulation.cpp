#include "robot/app/run_simulation.h"

#include <utility>

#include "robot/app/foresight_control.h"
#include "robot/app/runtime.h"
#include "robot/app/simulation_control.h"
#include "robot/body/sim/sim_body.h"
#include "sim/io/setup.h"

namespace robot::app {
namespace {

Result<body::Setup> setup_of(const RobotOptions& options, sim::Side side) {
  // everything at 30 Hz, as on a robot
  auto game = sim::io::prepare({.rules = options.rules,
                                .strategies = {options.home, options.away},
                                .models = {options.home_models.empty() ? options.models : options.home_models,
                                           options.away_models.empty() ? options.models : options.away_models},
                                .pace = sim::Pace::every_tick});
  if (!game) return Error{game.error()};
  const auto own = static_cast<std::uint32_t>(robot_named_by(options).team);
  const auto opponent = static_cast<std::uint32_t>(options.opponent);
  const bool home = side == sim::Side::home;
  return body::Setup{.game = std::move(*game),
                     .rules = options.rules,
                     .teams = {.home = home ? own : opponent, .away = home ? opponent : own}};
}

}  // namespace

Result<void> run_simulation(const RobotOptions& options) {
  const RobotName robot = robot_named_by(options);
  const sim::Side side = options.side == "home" ? sim::Side::home : sim::Side::away;
  if (robot.player > sim::kMaxPlayers)
    return Error{"--player: body sim has players 1 .. " + std::to_string(sim::kMaxPlayers) + ", got " +
                 std::to_string(robot.player)};
  if (options.game_controller) return Error{"--game-controller: body sim plays a game of its own"};
  Result<body::Setup> setup = setup_of(options, side);
  if (!setup) return Error{setup.error()};

  const SessionClock clock;
  auto body = body::SimBody::open(
      std::move(*setup),
      {.robot = sim::robot_of(side, robot.player), .seed = options.seed, .speed = options.speed, .loop = options.loop},
      clock);
  if (!body) return Error{body.error()};
  Runtime runtime(runtime_options(options, robot), clock, own_objects(*(*body)->memory()));
  if (Result<void> listed = (*body)->list(runtime.channels()); !listed) return listed;
  add_simulation_control(**body, runtime.services());
  // a game that is paused stands still for foresight, too
  const auto shown_ns = [&simulation = (*body)->memory()->simulation] { return simulation.read()->capture_ns(); };
  const auto foresight = ForesightControl::open(foreseer_options(options), options.foresight.value_or(true), runtime,
                                                *(*body)->memory(), robot.text(), shown_ns);
  if (!foresight) return Error{foresight.error()};
  const Result<bool> begun = begin(runtime, options);
  if (!begun) return Error{begun.error()};
  if (!*begun) return {};
  (*body)->start();
  runtime.run([] { return true; });
  (*body)->stop();
  return {};
}

}  // namespace robot::app
