// The sensors of a lab, as the tracks know them.
#pragma once

#include <cstddef>

#include "robot/truth/frame/detections.h"
#include "robot/truth/frame/sensor_pose.h"

namespace robot::truth {

/// Most sensors of one field. Each track carries an offset for each of them, so the cost grows with its square.
constexpr std::size_t kMostSensors = 4;

/// The way in which a sensor finds a place: by a measured depth, or where a pixel's ray meets a plane above the carpet.
/// The errors of its pose act differently.
enum class Ranging { depth, plane };

/// One sensor. A depth camera finds robots by depth and the ball by the plane; a camera that reads tags uses planes only.
struct Sensor {
  SensorPose pose;
  Ranging robots = Ranging::depth;
  Ranging ball = Ranging::plane;
};

/// The detections in one image of one sensor.
struct SensorImage {
  std::size_t sensor = 0;  // its index; sentences count from 1
  Detections detections;
};

}  // namespace robot::truth
