// What a robot's memory holds of the game, as foresight's simulator needs it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

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
