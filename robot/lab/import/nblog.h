// Logs of the Northern Bites' robots, "nblog" version 7 (2014-15). A file contains the blocks of one moment.
//
// File: u32 big endian bytes of the header; the header, an S-expression and a NUL; u32 big endian bytes of the payload;
// the payload, the blocks one after the other. The header describes each block in (contents ((type T) (from F)
// (when microseconds) (nbytes N) ...) ...). It also contains sensor values, with six digits.
//
//   YUVImage       from camera_TOP or camera_BOT; width x height pixels as YUYV ("[Y8(U8/V8)]")
//   InertialState  protobuf, float fields: 1-3 accelerometer x y z, 4-6 gyroscope x y z, 7-9 torso angle x y z
//   JointAngles    protobuf, float fields 1-26 [rad], in the order of the names in the header
//
// Found in the only available recording, of a Nao V4:
// - `when` counts microseconds of the robot's clock.
// - Joint angles have today's zeros and signs. r_hip_yaw_pitch repeats the left one and is dropped.
// - The accelerometer is in the board's raw counts, with the opposite sign: about -65 while standing. B-Human's default
//   for the same accelerometer is 0.017 g per count (release of 2009), which makes this robot's gravity 10.8 m/s². The
//   file contains no calibration, so expect errors of 10 %.
// - The gyroscope is in raw counts with an unknown offset (-2434, -2448 while standing still) and is left out. In the
//   team's logs of 2012 these two fields contain the accelerometer's values, which is another reason.
#pragma once

#include <cstdint>
#include <string_view>

#include "robot/core/result.h"
#include "robot/lab/import/import_sink.h"

namespace robot::lab {

/// Passes the blocks of the log `file_bytes` to `sink`, in the order of the file: camera_top or camera_bottom,
/// inertial, joints. `epoch_ns` [ns since the epoch] is added to the robot's clock. Blocks of other types are left out
/// and named in the report. If header and payload disagree about a value, the payload counts and the report says so.
/// From a log that ends early or has a bad block it imports everything before, and the report names the damage. Returns
/// an Error if the header is not that of such a log, or if the sink returns one.
Result<ImportReport> import_nblog(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink);

}  // namespace robot::lab
