// The table of parameters as an object in memory, so that a team's own processes can read what people set.
#pragma once

#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/net/foxglove/parameters.h"

namespace robot::app {

/// Adds the channel "/<robot>/parameters": JSON {"name": value, …} of all parameters, written now and at each change.
/// `clock` outlives the channels. All parameters are declared before. Returns an Error if the topic is taken.
Result<void> add_parameter_service(net::Parameters& parameters, const std::string& robot, memory::Channels& channels,
                                   const Clock& clock);

}  // namespace robot::app
