#include "tests/support/planted_walks.h"

#include <cmath>
#include <random>
#include <string>

#include "sim/motion/motion.h"

namespace robot::tests {
namespace {

using sim::motion::Command;

constexpr double kTickSeconds = 1. / 30;

Command speed_command(float x, float y, float turn) {
  Command command;
  command.body = x == 0 && y == 0 && turn == 0 ? Command::Body::stand : Command::Body::walk_speed;
  command.walk = {x, y};
  command.turn = turn;
  return command;
}

/// The commands of a drill, one part after the other.
class Drill {
 public:
  Drill(const PlantedWalks& planted, std::uint64_t seed) : planted_(planted), random_(seed) {}

  Command next(const sim::Body& body) {
    if (left_ <= 0) begin();
    --left_;
    if (!planted_.to_places || !walks_) return command_;
    // the rest of the way, as the robot sees it now
    Command to;
    to.body = Command::Body::walk_to;
    to.walk = sim::turned_back(place_ - body.position, body.facing);
    to.turn = 0;
    return to;
  }

 private:
  float uniform(double from, double to) {
    return static_cast<float>(std::uniform_real_distribution<double>(from, to)(random_));
  }

  void begin() {
    walks_ = !walks_ || uniform(0, 1) < 0.2f;
    left_ = static_cast<int>(30 * (walks_ ? uniform(3, 7) : uniform(1.5, 3)));
    command_ = walks_ ? part() : Command{};
    place_ = {uniform(-4, 4), uniform(-3, 3)};
  }

  Command part() {
    const float side = uniform(0, 1) < 0.5f ? 1.f : -1.f;
    switch (planted_.ahead_only ? 0 : std::uniform_int_distribution<int>(0, 7)(random_)) {
      case 0: return speed_command(0.6f, 0, 0);
      case 1: return speed_command(0.2f, 0, 0);  // below the limit, which hides the luck of steps
      case 2: return speed_command(-0.6f, 0, 0);
      case 3: return speed_command(0, 0.6f * side, 0);
      case 4: return speed_command(0, 0, 2.5f * side);
      case 5: return speed_command(0.6f, 0, uniform(0.3, 0.9) * side);
      case 6: return speed_command(uniform(0.05, 0.12), 0, 0);
      default: return speed_command(0, 0, uniform(0.2, 0.8) * side);
    }
  }

  const PlantedWalks& planted_;
  std::mt19937_64 random_;
  bool walks_ = true;  // the drill begins with standing
  int left_ = 0;
  Command command_;
  sim::Vec2 place_;
};

/// Returns the mirror image of a command at the robot's x axis.
Command mirrored_command(Command command) {
  command.walk.y = -command.walk.y;
  command.turn = -command.turn;
  return command;
}

/// Notes the stops as the status of a simulated robot has them: at the end of each tick.
class HaltNotes {
 public:
  void add(const sim::Body& before, const sim::Body& after, double at, WalkedDrill& drill) {
    const bool stopping = after.doing == sim::Body::Doing::stopping;
    if (stopping && before.doing != sim::Body::Doing::stopping)
      halt_ = {.robot = 0,
               .at = at,
               .duration = 0,
               .speed = sim::length(before.velocity),
               .turn_rate = std::abs(before.turn_rate),
               .resolution = kTickSeconds};
    if (before.doing == sim::Body::Doing::stopping && after.doing == sim::Body::Doing::standing) {
      halt_.duration = at - halt_.at;
      drill.halts.push_back(halt_);
    }
  }

 private:
  fit::Halt halt_;
};

WalkedDrill walked_drill(const PlantedWalks& planted, int robot, std::uint64_t seed) {
  std::mt19937_64 random(seed * 1000 + static_cast<std::uint64_t>(robot));
  std::normal_distribution<double> normal;
  const double hand = planted.mirrored ? -1 : 1;
  sim::World world;
  world.key = sim::RandomKey{seed};
  world.players = sim::kMaxPlayers;
  world.tick = static_cast<sim::Tick>(random() % 1000);
  const sim::motion::MotionParams params{
      .model = planted.models.motion, .effects = planted.models.effects, .ball = planted.models.ball};
  WalkedDrill drill;
  Drill script(planted, random());
  const double late = planted.late * normal(random);
  HaltNotes halts;
  sim::Body& body = world.bodies[robot];
  for (int i = 0; i < static_cast<int>(planted.seconds * 30); ++i) {
    const double at = i * kTickSeconds;
    drill.path.push_back(
        {.at = at,
         .x = body.position.x + planted.truth_error * normal(random),
         .y = hand * (body.position.y + planted.truth_error * normal(random)),
         .heading = std::remainder(hand * (body.heading + planted.heading_error * normal(random)), 6.283185307179586)});
    const Command command = script.next(body);
    drill.commands.push_back({.at = at + late, .command = hand > 0 ? command : mirrored_command(command)});
    const sim::Body before = body;
    const sim::motion::Mover mover{&command, nullptr, &world, robot, 1, 0};
    sim::motion::move(params, {&mover, 1});
    ++world.tick;
    halts.add(before, body, at, drill);
  }
  const auto words = sim::draw(world.key, static_cast<std::uint32_t>(robot), sim::Draw::walk_pace, 0);
  if (planted.models.effects.walk_spread) drill.pace = 1 - planted.models.motion.walk.spread * sim::uniform(words[0]);
  return drill;
}

}  // namespace

sim::Models walking_models() {
  sim::Models models{};
  models.name = "planted";
  models.effects.walk_acceleration = models.effects.walk_noise = models.effects.walk_delay = true;
  models.motion.walk = {.forward = 0.3f,
                        .backward = 0.22f,
                        .sideward = 0.18f,
                        .turn_rate = 1.4f,
                        .acceleration = 0.7f,
                        .turn_acceleration = 5,
                        .turn_cost = 0.6f,
                        .slow_down = 0.1f,
                        .step_duration = 0.25f,
                        .spread = 0.4f,
                        .speed_noise = 0.12f,
                        .turn_noise = 0.12f,
                        .start_delay = 0.3f,
                        .stop_delay = 0.5f};
  return models;
}

std::vector<WalkedDrill> walked_drills(const PlantedWalks& planted, std::uint64_t seed) {
  std::vector<WalkedDrill> drills;
  for (std::size_t i = 0; i < planted.robots; ++i) drills.push_back(walked_drill(planted, static_cast<int>(i), seed));
  return drills;
}

fit::Drives drives_of(const std::vector<WalkedDrill>& drills, double clock_deviation) {
  fit::Drives drives;
  std::vector<const lab::Path*> paths;
  for (const WalkedDrill& drill : drills) {
    drives.robots.push_back("robot " + std::to_string(drives.robots.size() + 1));
    drives.clock_deviation.push_back(clock_deviation);
    drives.clocks.push_back(drives.clocks.size());
    fit::cut_drives(drill.commands, drill.path, {}, drives);
    for (fit::Halt halt : drill.halts) {
      halt.robot = drives.robots.size() - 1;
      drives.halts.push_back(halt);
    }
    paths.push_back(&drill.path);
  }
  fit::measure_scatter(paths, drives);
  return drives;
}

}  // namespace robot::tests
