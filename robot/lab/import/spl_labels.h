// Label files of the Standard Platform League: boxes of ball and robots in a video of a whole half (RoboCup-SPL/Datasets).
//
// A CSV file: "<time in ms>.jpg,label,x_min,y_min,x_max,y_max,color,number", for images of 1920x1080 pixels at 30 Hz of
// an action camera that stands beside the field. Label 0 is a robot, 1 the ball. The camera is not described, so it is
// fitted to the robots' boxes: a standing robot's head is above its feet (label_camera.h). The goalkeepers' places give
// scale and direction (label_field.h). Lengths are good to 10 to 15 %.
#pragma once

#include <cstdint>
#include <string_view>

#include "robot/core/result.h"
#include "robot/lab/import/import_sink.h"

namespace robot::lab {

/// Passes /truth/world to `sink`, one message for each image, 30 a second. The team whose colour has the lower number is
/// team 1 and defends the goal at -x, the other one is team 2. `epoch_ns` [ns since the epoch] is the time of the first
/// image.
///
/// The report describes the error of the camera on its own boxes, and on one half of the file after a fit to the other
/// half. From a file with a wrong row it imports everything before, and the report names the damage. Returns an Error if
/// the header is another one, if the camera or the field cannot be found, or if the sink returns one.
Result<ImportReport> import_spl_labels(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink);

}  // namespace robot::lab
