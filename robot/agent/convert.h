// What simulated robots believe, do and decide, as messages of a robot's memory; units and frames are those of the .proto.
//
// Each to_proto fills `message` from nothing and may be called again and again with the same one, which then keeps its
// memory. All are functions of their arguments, used from any thread.
#pragma once

#include <cstdint>
#include <string>

#include "proto/foresight/agent.pb.h"
#include "proto/foresight/ball.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/opponents.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/team.pb.h"
#include "proto/foresight/truth.pb.h"
#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/agent/trace.h"
#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/motion/command.h"
#include "sim/motion/model.h"
#include "sim/world/body.h"
#include "sim/world/world.h"

namespace robot::agent {

namespace pb = foresight;

/// Capture times of a simulated game: at speed 1, 30 ticks are a second exactly, and no tick is off by a nanosecond.
struct Timeline {
  std::uint64_t epoch_ns = 0;  // [ns since the epoch] of tick 0
  double speed = 1;            // [game seconds per second]

  std::uint64_t at(sim::Tick tick) const { return epoch_ns + since_start_ns(tick); }

  std::uint64_t since_start_ns(sim::Tick tick) const {
    return static_cast<std::uint64_t>(static_cast<double>(std::uint64_t{tick} * 100'000'000) / (3 * speed));
  }
};

/// Team numbers by sim::Side.
struct TeamNumbers {
  std::uint32_t home = 14;
  std::uint32_t away = 5;

  std::uint32_t of(sim::Side side) const { return side == sim::Side::home ? home : away; }
};

/// "14/2"
std::string robot_name(const TeamNumbers& teams, int robot);

/// Where the ball is believed to be. `deceleration` [m/s²] of rolling, as the robot reckons with it, > 0.
/// False, and then nothing is filled: not seen once.
bool to_proto(const sim::agent::Ball& ball, float deceleration, const Timeline& timeline, pb::Ball& message);

void to_proto(const sim::agent::Pose& pose, pb::Pose& message);

/// What the teammates of `player` [1..7] last told. A told ball has no deviation (0), a simulated packet arrives
/// when it was sent. The number of messages is not known here.
void to_proto(const sim::agent::Beliefs& beliefs, int player, const Timeline& timeline, pb::Team& message);

/// Where the opponents were seen.
void to_proto(const sim::agent::Beliefs& beliefs, const Timeline& timeline, pb::Opponents& message);

/// What the GameController of a simulated game told the robot with index `robot`.
void to_proto(const sim::Params& params, const sim::State& state, int robot, const TeamNumbers& teams,
              const Timeline& timeline, pb::GameState& message);

void to_proto(const sim::motion::Command& command, const sim::motion::Model& model, pb::MotionCommand& message);

/// What the body does at tick `now`, and under which command.
void to_proto(const sim::Body& body, const sim::motion::Command& command, const sim::motion::Model& model,
              sim::Tick now, pb::MotionStatus& message);

void to_proto(const sim::agent::Trace& trace, pb::DecisionTrace& message);

/// All that is on the field; removed robots are not.
void to_proto(const sim::World& world, const TeamNumbers& teams, pb::GroundTruth& message);

}  // namespace robot::agent
