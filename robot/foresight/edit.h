// The edit of a question: it replaces beliefs about the moment.
#pragma once

#include "proto/foresight/forecast.pb.h"
#include "robot/bridge/player_map.h"
#include "robot/core/result.h"
#include "sim/foresight/situation.h"
#include "sim/match/params.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// Makes the edited place of the robot and of the ball its knowledge. So it can be asked even if it has
/// not seen the ball for a long time.
void tell(const pb::WhatIf::Edit& edit, const bridge::PlayerMaps& lineups, sim::foresight::Knowledge& knowledge);

/// Changes the situation as `edit` says, without uncertainty. Returns an Error for an impossible situation: outside the
/// field, in a goalpost, one robot in another.
Result<void> apply(const pb::WhatIf::Edit& edit, const bridge::PlayerMaps& lineups, const sim::Params& params,
                   sim::foresight::Situation& situation);

}  // namespace robot::foreseeing
