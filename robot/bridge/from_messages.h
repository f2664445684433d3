// A robot's memory of the game as foresight's simulator needs it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/foresight/agent.pb.h"
#include "proto/foresight/ball.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/opponents.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/sim.pb.h"
#include "proto/foresight/team.pb.h"
#include "proto/foresight/vision.pb.h"
#include "robot/bridge/moment.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "sim/foresight/situation.h"
#include "sim/match/params.h"

namespace robot::bridge {

namespace pb = ::foresight;

/// One object of a memory and its capture time.
template <class Message>
struct Remembered {
  Message value;
  std::uint64_t capture_ns = 0;  // [ns since the epoch]
};

/// The tick of the present in a Knowledge made of a memory, unless a Recollection says
/// otherwise. All other ticks are older.
inline constexpr sim::Tick kNow = 1'000'000;

/// The newest values at one moment. An absent object was never written.
struct Recollection {
  std::uint64_t now_ns = 0;  // [ns since the epoch] the moment
  double speed = 1;          // [game seconds per second] of a simulation
  sim::Tick now = kNow;      // [ticks] the same moment; at least an hour after tick 0
  std::optional<Remembered<pb::Ball>> ball;
  std::optional<Remembered<pb::Pose>> pose;
  std::optional<Remembered<pb::Team>> team;
  std::optional<Remembered<pb::Opponents>> opponents;
  std::optional<Remembered<pb::Vision>> vision;
  std::optional<Remembered<pb::GameState>> game;
  std::optional<Remembered<pb::MotionStatus>> motion;
  std::optional<Remembered<pb::DecisionTrace>> decision;

  /// Calls see(name, member) for each object.
  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("ball", self.ball), see("pose", self.pose), see("team", self.team), see("opponents", self.opponents);
    see("vision", self.vision), see("game", self.game), see("motion_status", self.motion);
    see("decision", self.decision);
  }
};

/// Returns the newest message of `topic`, or nothing without such a channel, without a
/// message, or if it is of another type.
template <class Message>
std::optional<Remembered<Message>> newest(const memory::Channels& channels, const std::string& topic) {
  const auto channel = channels.find(topic);
  const auto version = channel ? channel->newest() : nullptr;
  if (!version) return {};
  Remembered<Message> message{.value = {}, .capture_ns = version->capture_ns()};
  const std::string_view bytes = version->bytes();
  if (!message.value.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return {};
  return message;
}

/// Returns the state of a live or recorded simulation, or nothing when the game is not simulated.
inline std::optional<Remembered<pb::Simulation>> simulation_of(const memory::Channels& channels) {
  return newest<pb::Simulation>(channels, memory::kSimulationTopic);
}

/// Returns the moment `now_ns` with the speed of the simulation, or speed 1 without a simulation.
Moment moment_of(const memory::Channels& channels, std::uint64_t now_ns);

/// Returns a sentence about the part of the game that is not soccer, such as a
/// time-out, or null while soccer is played.
const char* why_no_soccer(const pb::GameState& game);

/// Reads the memory of `robot` ("14/2"), live or played, at `now_ns` [ns since the epoch]. The memory of a recording
/// that was moved back may hold later data: these are left out.
Recollection recollect(const memory::Channels& channels, const std::string& robot, std::uint64_t now_ns);

/// Greatest age of a useful pose.
inline constexpr float kStalePose = 3;  // [s]

/// Converts a recollection to the simulator's form. `params` are the rules of the game and, as the home team, the
/// abilities of the own body. Returns an Error when a necessary object is absent or old, such as "the robot does not
/// know where it is: there is no object pose yet". It also returns one when no soccer is played, such as "the game is
/// in a penalty shoot-out".
Result<sim::foresight::Knowledge> knowledge_of(const Recollection& recollection, const sim::Params& params);

}  // namespace robot::bridge
