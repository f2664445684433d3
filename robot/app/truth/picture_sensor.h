// An ordinary camera as a sensor: its images have colours and no depths.
#pragma once

#include <memory>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/truth/frame/depth_source.h"

namespace robot::app {

/// Opens "camera:/dev/video0" (1280x720) or "pictures:FOLDER". The focal length of its images is a guess, 0.9 times their
/// width, until the calibration finds it. `clock` outlives the source. Returns an Error as tags::open_pictures() does.
Result<std::unique_ptr<truth::DepthSource>> open_picture_sensor(const std::string& address, const SessionClock& clock);

}  // namespace robot::app
