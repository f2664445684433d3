// Sensors of PrimeSense, Asus and Orbbec, through OpenNI 2.
#pragma once

#include <memory>
#include <string>

#include "robot/truth/sensor/sensor_driver.h"

namespace robot::truth {

/// Returns the driver of the sensor with this number, from 0 on, or with this address (URI) of OpenNI.
///
/// The intrinsics come from the sensor's field of view, as it reports it. Its images carry a counter of microseconds;
/// DeviceClock converts it, so that the capture time contains the least transmission delay. The images have colours if the
/// sensor itself registers its depth to them.
std::unique_ptr<SensorDriver> openni_driver(std::string which);

}  // namespace robot::truth
