// What the guardian reports, as messages of memory.
#pragma once

#include "proto/foresight/motion.pb.h"
#include "proto/foresight/sensors.pb.h"
#include "robot/nao/guardian/link.h"

namespace robot::nao {

namespace pb = foresight;

/// Each fills an empty message with what LoLA told, in the units and with the signs that the message asks for.
void fill(const Report& report, pb::Joints& joints);
void fill(const Report& report, pb::Inertial& inertial);
void fill(const Report& report, pb::Fsr& fsr);
void fill(const Report& report, pb::Sonar& sonar);
void fill(const Report& report, pb::Touch& touch);
void fill(const Report& report, pb::Battery& battery);

/// Without `refused`, which the guardian knows nothing of. Modes and identity are absent while there is no LoLA.
void fill(const Report& report, pb::Body& body);

/// Without what only the motion knows: head_active.
void fill(const Report& report, pb::MotionStatus& status);

}  // namespace robot::nao
