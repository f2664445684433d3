#include "robot/fit/walking/mean_walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/motion/motion.h"
#include "tests/support/planted_walks.h"

namespace robot::tests {
namespace {

using fit::WalkRates;
using sim::motion::Command;

constexpr int kWalks = 600;

Command to_place(float x, float y, float turn) {
  Command command;
  command.body = Command::Body::walk_to;
  command.walk = {x, y};
  command.turn = turn;
  return command;
}

Command at_speed(float x, float y, float turn) {
  Command command;
  command.body = Command::Body::walk_speed;
  command.walk = {x, y};
  command.turn = turn;
  return command;
}

/// Stands, follows the command, and stands again.
std::vector<Command> standing_around(const Command& command) {
  std::vector<Command> commands(20);
  commands.insert(commands.end(), 45, command);
  commands.insert(commands.end(), 30, Command{});
  return commands;
}

/// The mean of many simulated walks, and its standard error.
struct Simulated {
  std::vector<WalkRates> mean, error;
};

Simulated simulated(const sim::Models& models, const std::vector<Command>& commands) {
  const sim::motion::MotionParams params{.model = models.motion, .effects = models.effects, .ball = models.ball};
  Simulated of{std::vector<WalkRates>(commands.size()), std::vector<WalkRates>(commands.size())};
  for (int walk = 0; walk < kWalks; ++walk) {
    sim::World world;
    world.key = sim::RandomKey{static_cast<std::uint64_t>(walk)};
    world.players = sim::kMaxPlayers;
    world.tick = static_cast<sim::Tick>(walk);  // so that the steps have all phases
    const sim::Body& body = world.bodies[0];
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const sim::Body before = body;
      const sim::motion::Mover mover{&commands[i], nullptr, &world, 0, 1, 0};
      sim::motion::move(params, {&mover, 1});
      ++world.tick;
      const sim::Vec2 moved = 30 * sim::turned_back(body.position - before.position, before.facing);
      const double turned = 30 * std::remainder(body.heading - before.heading, 6.283185307179586);
      of.mean[i].x += moved.x, of.mean[i].y += moved.y, of.mean[i].turn += turned;
      of.error[i].x += moved.x * moved.x, of.error[i].y += moved.y * moved.y, of.error[i].turn += turned * turned;
    }
  }
  const auto settle = [](double& mean, double& error) {
    mean /= kWalks;
    error = std::sqrt(std::max(0., error / kWalks - mean * mean) / kWalks);
  };
  for (std::size_t i = 0; i < commands.size(); ++i) {
    settle(of.mean[i].x, of.error[i].x);
    settle(of.mean[i].y, of.error[i].y);
    settle(of.mean[i].turn, of.error[i].turn);
  }
  return of;
}

TEST(MeanWalk, IsTheMeanOfManyWalks) {
  sim::Models models = walking_models();
  models.effects.walk_spread = false;
  for (const Command& command : {at_speed(0.2f, 0, 0), at_speed(0.1f, 0.05f, 0.4f), to_place(2, 0.5f, 0),
                                 to_place(0.2f, 0.05f, 0.3f), to_place(0.05f, 0, 0.5f), to_place(0, 0, 0.3f)}) {
    const std::vector<Command> commands = standing_around(command);
    const std::vector<WalkRates> mean = fit::mean_walk(models.motion.walk, commands);
    const Simulated walks = simulated(models, commands);
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const auto compare = [&](double expected, double error, double got, double rounding, const char* name) {
        EXPECT_NEAR(got, expected, 5 * error + rounding) << name << " at tick " << i << " of walk " << command.walk.x
                                                         << ' ' << command.walk.y << ' ' << command.turn;
      };
      // four phases instead of all, and a body that turns during a tick
      compare(walks.mean[i].x, walks.error[i].x, mean[i].x, 0.01, "x");
      compare(walks.mean[i].y, walks.error[i].y, mean[i].y, 0.01, "y");
      compare(walks.mean[i].turn, walks.error[i].turn, mean[i].turn, 0.05, "turn");
    }
  }
}

}  // namespace
}  // namespace robot::tests
