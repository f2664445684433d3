// Recordings of B-Human's robots of 2009 (Nao V3): "logfile.log" of their code release.
//
// File, all little endian: u32 bytes of all messages, u32 number of messages, then per message u8 id, u24 bytes,
// payload. Ids: 1 process begin and 2 process finished bracket a frame, of cognition ('c': 4, 17, 18) or of motion
// ('m': 5-8).
//
//   4 image           u32 width, height, time [ms], bytes; JPEG of the four components Y U Y V. The camera's 640x480
//                     are recorded without every second row, each pair of pixels as one "pixel" of 320x240. The
//                     importer takes the means of the pairs, so that pixels are square again
//   5 joint data      22 float64 [rad], u32 time [ms]
//   6 sensor data     float32: gyroscope x y (z), accelerometer x y z, battery, 8 x FSR, sonar, torso angle x y;
//                     22 u16 motor current [mA], 22 u8 motor temperature [°C], u32 sonar pair, u32 time [ms]
//   7 key states      5 u32: right foot right, left; left foot right, left; chest
//   8 odometry        float64 rotation [rad], x, y [mm]
//  17 camera matrix   12 float64: the axes forward, left, up of the camera in the robot frame; position [mm]; u32 valid
//  18 image coordinates   14 float64 not used here; u32 width, height; float64 opening angles x, y [rad],
//                     focal length, centre x, y [px]
//
// These facts were found in the data, which confirm them (tests/robot/lab/import/bhuman2009_test.cpp). Names are those
// of B-Human's 2009 release.
//
// - The camera is the lower one: head pitch plus elevation of the optical axis is 40°, the lower camera's tilt.
//   Images become camera_bottom.
// - Joints: arms 4 + 4 after the head, then the left leg's 6 and the right leg's 6. These have the other sign than
//   today: head pitch, left hip and ankle roll, right shoulder roll, elbow yaw and elbow roll. Shoulder pitch is 90°
//   minus the recorded angle, left shoulder roll 90° plus, right shoulder roll minus 90° minus the recorded angle.
//   While the robot stands on the left foot, torso, hip and ankle roll sum up to level ground. The recorded angles
//   include each robot's own calibration, up to 3° per joint. Wrists and hands, which this body lacks, are 0.
// - Accelerometer: in g, with the opposite sign. With the torso leaning left and back it reads the expected gravity.
// - Gyroscope: rad/s (the torso angles change at its rate, correlation 0.84 and 0.89), with an unknown offset that
//   every robot had to learn. The importer subtracts the recording's median. The third axis is a placeholder.
// - In one frame of the known recording the inertial board is wrong (a torso angle of -65 rad): left out.
// - FSR: about kg, 0.28 without load, which is subtracted. While the robot stands, the sum is then 4.5 to 5.6.
// - Sonar: mm, 1000 without an echo. Pairs 0 (left to left) and 3 (right to right) are imported. The two crossed pairs
//   are left out, because we have no field for them.
// - Stiffness, commanded angles and battery current were not recorded.
#pragma once

#include <cstdint>
#include <string_view>

#include "robot/core/result.h"
#include "robot/lab/import/import_sink.h"

namespace robot::lab {

/// Passes the messages of the recording `file_bytes` to `sink`, in the order of the file: camera_bottom,
/// camera_bottom_matrix, joints, inertial, fsr, sonar, battery, touch, odometry. The robot's clock counts from its
/// start; `epoch_ns` [ns since the epoch] is added to it. From a damaged file it imports everything before the damage,
/// and the report names the damage. Returns an Error if the file is too short for such a recording, or if the sink
/// returns one.
Result<ImportReport> import_bhuman2009(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink);

}  // namespace robot::lab
