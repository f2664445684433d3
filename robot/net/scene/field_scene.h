// The field as a scene.
#pragma once

#include "proto/foresight/sim.pb.h"
#include "robot/net/scene/scene.h"

namespace robot::net {

/// Returns the carpet, the lines and the goals of a field.
Scene field_scene(const foresight::Field& field);

}  // namespace robot::net
