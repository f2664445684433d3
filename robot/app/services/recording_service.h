// Services and parameters by which clients control the recorder.
#pragma once

#include "robot/logging/sessions/recorder.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/net/foxglove/parameters.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// Adds the services start_recording, stop_recording, keep_session and the parameters recording, recording_profile.
/// All references outlive the server that uses them.
void add_recording_service(logging::Recorder& recorder, logging::SessionStore& store, net::Parameters& parameters,
                           net::Services& services);

}  // namespace robot::app
