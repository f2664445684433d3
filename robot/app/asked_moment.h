// The moment of a question about a robot: its newest decision, or the one that a client shows.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "proto/foresight/sim.pb.h"
#include "proto/foresight/truth.pb.h"
#include "robot/bridge/from_messages.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"

namespace robot::app {

/// The objects of a robot at one decision.
struct AskedMoment {
  std::string robot;  // "14/2"
  bridge::Recollection objects;
  std::optional<foresight::GroundTruth> truth;
  std::optional<foresight::Simulation> simulation;  // only of sent objects
};

/// Reads the text at `key` of a request, of at most 1000 bytes.
Result<std::string> text_in(const nlohmann::json& request, const char* key);

/// Reads "robot" and, if they are there, "at_ns" and "objects" of a request:
///
///   "at_ns": "1700000000000000000"  capture time of the decision
///   "objects": {"ball": {"capture_ns": "…", "data": "base64"}, …}  newest messages of the robot at that time, by name;
///              "truth" is /truth/world, "simulation" is /sim/state
///
/// Without objects it is the newest decision in `channels`, and what the robot knew then. Returns an Error for a wrong
/// request, and if the robot decides nothing now.
Result<AskedMoment> asked_moment(const memory::Channels& channels, const nlohmann::json& request);

}  // namespace robot::app
