// The field that the rules of a game give.
#pragma once

#include <string>

#include "proto/foresight/sim.pb.h"

namespace robot::app {

/// Returns the field of `rules`, or of the newest ones if those are unknown here.
foresight::Field field_of(const std::string& rules);

}  // namespace robot::app
