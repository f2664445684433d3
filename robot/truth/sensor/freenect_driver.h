// The first Kinect, through libfreenect.
#pragma once

#include <memory>

#include "robot/truth/sensor/sensor_driver.h"

namespace robot::truth {

/// Returns the driver of the Kinect with this number, from 0 on.
///
/// The sensor delivers disparities of 11 bits, which kinect_frame() converts as for recordings. Its images carry a counter of
/// 60 MHz; DeviceClock converts it, so that the capture time contains the least transmission delay.
std::unique_ptr<SensorDriver> freenect_driver(int number);

}  // namespace robot::truth
