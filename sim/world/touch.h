// When two bodies touch. Internal to sim/world.
#pragma once

#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim {

inline constexpr float kTouch = 0.01f;  // [m] gap below which two robots touch

inline float radius_of(const ContactModel& contact, const Body& body) {
  return lies(body) ? contact.lying_radius : contact.robot_radius;
}

}  // namespace sim
