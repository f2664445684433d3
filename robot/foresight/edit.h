// What a question says of the moment, in place of what the robot believes.
#pragma once

#include "proto/foresight/forecast.pb.h"
#include "robot/bridge/player_map.h"
#include "robot/core/result.h"
#include "sim/foresight/situation.h"
#include "sim/match/params.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// What `edit` says of the robot itself and of the ball, it knows: so it can be asked though it saw no ball for long.
void tell(const pb::WhatIf::Edit& edit, const bridge::PlayerMaps& lineups, sim::foresight::Knowledge& knowledge);

/// Changes the situation to what `edit` says, of which there is no doubt then. An Error where it cannot be so: outside the
/// field, in a goalpost, one robot in another.
Result<void> apply(const pb::WhatIf::Edit& edit, const bridge::PlayerMaps& lineups, const sim::Params& params,
                   sim::foresight::Situation& situation);

}  // namespace robot::foreseeing
