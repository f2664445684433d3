// The things that never move in the picture of a synthetic sensor.
#pragma once

#include "robot/truth/frame/sensor_pose.h"
#include "robot/truth/synthetic/cast.h"
#include "sim/field/field.h"

namespace robot::truth {

/// A field in a hall.
struct Surroundings {
  sim::field::Field field;
  bool goals = true;   // posts and crossbars stand on the field
  double walls = 1.5;  // [m] from the edge of the carpet to the four walls; 0: there are none
};

/// Returns the exact image of the empty field: floor, lines, goals, walls.
Cast cast_of(const Surroundings& surroundings, const SensorPose& pose);

}  // namespace robot::truth
