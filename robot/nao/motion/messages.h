// Conversion of the guardian's reports into messages of memory.
#pragma once

#include "proto/foresight/motion.pb.h"
#include "proto/foresight/sensors.pb.h"
#include "robot/nao/guardian/link.h"

namespace robot::nao {

namespace pb = foresight;

/// Each of these fills an empty message with LoLA's values, in the units and with the signs of the message.
void fill(const Report& report, pb::Joints& joints);
void fill(const Report& report, pb::Inertial& inertial);
void fill(const Report& report, pb::Fsr& fsr);
void fill(const Report& report, pb::Sonar& sonar);
void fill(const Report& report, pb::Touch& touch);
void fill(const Report& report, pb::Battery& battery);

/// Fills all fields but `refused`, which the guardian does not know. Modes and identity are absent while there is no
/// LoLA.
void fill(const Report& report, pb::Body& body);

/// Fills all fields but head_active, which only the motion knows.
void fill(const Report& report, pb::MotionStatus& status);

}  // namespace robot::nao
