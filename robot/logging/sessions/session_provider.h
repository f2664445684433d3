// The streams of a recorded session as providers.
#pragma once

#include <memory>

#include "robot/logging/sessions/session.h"
#include "robot/logging/streams/provider.h"

namespace robot::logging {

/// Returns a provider of the messages of one stream of a session.
std::unique_ptr<InProvider> provider_of(const Session& session, const StreamFile& stream);

}  // namespace robot::logging
