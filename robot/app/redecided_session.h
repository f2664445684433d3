// A recording with the decisions of another tree beside the recorded ones.
#pragma once

#include <filesystem>

#include "robot/app/redecide.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/session.h"

namespace robot::app {

/// The object with the new decisions of a robot, a DecisionTrace like the recorded object "decision".
inline constexpr const char* kRedecision = "redecision";

/// Writes a copy of `session` into the new folder `folder`, with the object "redecision" of the robot. It has a message for
/// each recorded decision in play, at the same time. Messages that cannot be read are left out, and the description of the
/// copy counts them. After an Error there is no copy.
Result<void> write_redecided(const logging::Session& session, const Redecisions& decisions,
                             const std::filesystem::path& folder);

}  // namespace robot::app
