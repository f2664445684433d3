// Where the head looks while the body does something else.
#pragma once

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// Follows the ball, and looks away for marks now and then, to one side after the other; scans where the ball is
/// unknown. Each player has its own rhythm.
void look_at_ball(const View& view, motion::Command& command);
/// Follows the ball without looking away.
void keep_eye_on_ball(const View& view, motion::Command& command);
/// Swings the head to both sides by `angle` [rad], beginning with the side Mind.search_side tells.
void scan(const View& view, motion::Command& command, float angle);

/// Stand, the head at the ball.
motion::Command stand(const View& view);
motion::Command look_round(const View& view, float angle);

}  // namespace sim::agent
