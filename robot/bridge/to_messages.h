// Beliefs, actions and decisions of simulated robots as messages of a robot's memory. Units and frames are those of the
// .proto.
//
// Each to_proto clears and fills `message`. A message that is filled again keeps its allocated memory. All are
// functions of their arguments, for any thread.
#pragma once

#include <cstdint>
#include <string>

#include "proto/foresight/agent.pb.h"
#include "proto/foresight/ball.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/opponents.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/sim.pb.h"
#include "proto/foresight/team.pb.h"
#include "proto/foresight/truth.pb.h"
#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/agent/trace.h"
#include "sim/field/field.h"
#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/motion/command.h"
#include "sim/motion/model.h"
#include "sim/world/body.h"
#include "sim/world/world.h"

namespace robot::bridge {

namespace pb = foresight;

/// Capture times of a simulated game. At speed 1, 30 ticks are exactly a second, and each
/// tick is exact to the nanosecond.
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

/// Returns the name of the robot with index `robot`, such as "14/2".
std::string robot_name(const TeamNumbers& teams, int robot);

/// Converts the belief about the ball. `deceleration` [m/s²] is the one that the robot assumes for a rolling ball, > 0.
/// Returns false and fills nothing when the ball was never seen.
bool to_proto(const sim::agent::Ball& ball, float deceleration, const Timeline& timeline, pb::Ball& message);

void to_proto(const sim::agent::Pose& pose, pb::Pose& message);

/// Converts the last messages from the teammates of `player` [1..7]. A teammate's ball has no deviation (0). A
/// simulated packet arrives at its send time. The caller fills the number of sent messages.
void to_proto(const sim::agent::Beliefs& beliefs, int player, const Timeline& timeline, pb::Team& message);

/// Converts the last seen places of the opponents.
void to_proto(const sim::agent::Beliefs& beliefs, const Timeline& timeline, pb::Opponents& message);

/// Converts the state that the GameController of a simulated game reports to the robot with index `robot`.
void to_proto(const sim::Params& params, const sim::State& state, int robot, const TeamNumbers& teams,
              const Timeline& timeline, pb::GameState& message);

void to_proto(const sim::motion::Command& command, const sim::motion::Model& model, pb::MotionCommand& message);

/// Converts the state of the body at tick `now`, and its command.
void to_proto(const sim::Body& body, const sim::motion::Command& command, const sim::motion::Model& model,
              sim::Tick now, pb::MotionStatus& message);

void to_proto(const sim::agent::Trace& trace, pb::DecisionTrace& message);

/// Converts everything on the field. Removed robots are left out.
void to_proto(const sim::World& world, const TeamNumbers& teams, pb::GroundTruth& message);

void to_proto(const sim::field::Field& field, pb::Field& message);

}  // namespace robot::bridge
