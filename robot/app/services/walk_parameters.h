// The numbers of our walk, which people change while the robot walks.
#pragma once

#include <functional>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/nao/walk/parameters.h"
#include "robot/net/foxglove/parameters.h"

namespace robot::app {

/// Announces the numbers of the walk of `robot` as live parameters of a process "walk": "walk.lift", with unit, meaning and
/// range as in the file of settings. `settings` are those of that file. Call it after LiveParameterService::open().
/// After each change, `change` gets all of them, from the thread that sets. `table`, `channels` and `clock` outlive the
/// runtime's threads. Returns an Error if the topic is taken.
Result<void> add_walk_parameters(net::Parameters& table, const nao::walk::Parameters& settings,
                                 const std::string& robot, memory::Channels& channels, const Clock& clock,
                                 std::function<void(const nao::walk::Parameters&)> change);

}  // namespace robot::app
