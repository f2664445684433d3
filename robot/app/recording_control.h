// What people may ask of the recorder: services and parameters.
#pragma once

#include "robot/logging/recorder.h"
#include "robot/logging/session_store.h"
#include "robot/net/parameters.h"
#include "robot/net/services.h"

namespace robot::app {

/// Adds the services start_recording, stop_recording, keep_session and the parameters recording, recording_profile.
/// All outlive the server that uses them.
void add_recording_control(logging::Recorder& recorder, logging::SessionStore& store, net::Parameters& parameters,
                           net::Services& services);

}  // namespace robot::app
