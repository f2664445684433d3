// Services and parameters by which clients control the recorder.
#pragma once

#include <string>
#include <vector>

#include "robot/logging/sessions/recorder.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/net/foxglove/parameters.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// Returns the objects of the parameter recording_objects, which recordings contain; none: all objects.
std::vector<std::string> recorded_objects(const net::Parameters& parameters);

/// Adds the services start_recording, stop_recording, keep_session and the parameters recording, recording_profile,
/// recording_objects. The last is a text such as "ball, pose", or empty for all objects. A request of start_recording may
/// name other ones: {"name": "passes", "profile": "game", "only": ["ball", "pose"]}. An unknown object is refused with a
/// similar one.
/// All references outlive the server that uses them.
void add_recording_service(logging::Recorder& recorder, logging::SessionStore& store, net::Parameters& parameters,
                           net::Services& services);

}  // namespace robot::app
