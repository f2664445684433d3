// The services that explain a robot's decision: why this skill, and why not another one. And its moment as a file.
#pragma once

#include <string>
#include <vector>

#include "robot/memory/channels.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// The trees and the rules of explained decisions.
struct ReasonsOptions {
  std::vector<std::string> strategies;  // by name or path, beside the embedded ones
  std::string rules;                    // empty: those of the simulation, or the newest of a real game
};

/// Adds these questions about the robots in `channels`, which outlive the server:
///
///   /decision/why      {"robot": "14/2", …}  -> {"ok", "reasons": {…}, "has_truth", "agrees"}
///   /decision/why_not  {"robot": "14/2", "what": "dribble", …}  -> {"ok", "alternative": {…}, "agrees"}
///   /decision/situation  {"robot": "14/2", …}  -> {"ok", "situation": "…"}
///
/// `what` is a skill, the path of a part of the tree, or a name in it. The answers to "why" and "why not" are those of
/// sim/report/reasons.h. "agrees" is false if the robot reached another leaf: the memory of a behaviour is not recorded.
/// "situation" is the text of robot/foresight/believed_situation.h: what the robot believed, as a start of simulated games.
///
/// Without more they explain the newest decision in memory. A client that shows another moment sends its objects
/// (robot/app/asked_moment.h).
///
/// They only compute, and change nothing. In a program that was linked without them (robot_no_reasons), none is added.
void add_reasons_service(net::Services& services, const memory::Channels& channels, const ReasonsOptions& options);

}  // namespace robot::app
