// The table of parameters as an object in memory: what people set, a team's own processes can read.
#pragma once

#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/net/foxglove/parameters.h"

namespace robot::app {

/// Lists "/<robot>/parameters": JSON, {"name": value, …} of all parameters, written now and whenever one changes.
/// `clock` outlives the channels, `parameters` are declared before. An Error if the topic is taken.
Result<void> add_parameter_service(net::Parameters& parameters, const std::string& robot, memory::Channels& channels,
                                   const Clock& clock);

}  // namespace robot::app
