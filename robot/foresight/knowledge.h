// What a robot's memory holds of the game, as foresight's simulator needs it.
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
#include "robot/core/result.h"
#include "robot/foresight/moment.h"
#include "robot/memory/channels.h"
#include "sim/foresight/situation.h"
#include "sim/match/params.h"

// Not `robot::foresight`: within robot, `foresight` is the package of the messages.
namespace robot::foreseeing {

namespace pb = ::foresight;

/// One object of a memory and when it was sensed.
template <class Message>
struct Remembered {
  Message value;
  std::uint64_t capture_ns = 0;  // [ns since the epoch]
};

/// The newest values of one moment; what is absent was never written.
struct Recollection {
  std::uint64_t now_ns = 0;  // [ns since the epoch] the moment
  double speed = 1;          // [game seconds per second] of a simulation
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

/// The newest message of `topic`; nothing where there is no such channel, or it has none, or not of that kind.
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

inline constexpr const char* kSimulationTopic = "/sim/state";

/// How a simulation goes, live or recorded; nothing where the game is none.
inline std::optional<Remembered<pb::Simulation>> simulation_of(const memory::Channels& channels) {
  return newest<pb::Simulation>(channels, kSimulationTopic);
}

/// The moment `now_ns`, in game time as the simulation goes, if there is one.
Moment moment_of(const memory::Channels& channels, std::uint64_t now_ns);

/// The part of the game that is no soccer, as a sentence; nullptr: soccer is played.
const char* why_no_soccer(const pb::GameState& game);

/// What the memory of `robot` ("14/2"), live or played, holds at `now_ns` [ns since the epoch]. Of a recording that was moved
/// back it may hold what came later: that is left out.
Recollection recollect(const memory::Channels& channels, const std::string& robot, std::uint64_t now_ns);

/// The tick that is now in every Knowledge made of a memory: everything else is older.
inline constexpr sim::Tick kNow = 1'000'000;

/// A pose that is older tells nothing of now.
inline constexpr float kStalePose = 3;  // [s]

/// As the simulator has it. `params`: the rules of the game, and at home what the own body can do. An Error, one sentence,
/// where something without which nothing can be told is absent or old, "the robot does not know where it is: there is no
/// object pose yet", and where no soccer is played: "the game is in a penalty shoot-out".
Result<sim::foresight::Knowledge> knowledge_of(const Recollection& recollection, const sim::Params& params);

}  // namespace robot::foreseeing
