// The schema of a protobuf message as others need it to read the bytes without us.
#pragma once

#include <google/protobuf/descriptor.h>

#include "robot/memory/channel.h"

namespace robot::memory {

/// Name, encoding "protobuf" and the serialised FileDescriptorSet of `message` with everything it imports,
/// each file once, a file after those it depends on.
Schema schema_of(const google::protobuf::Descriptor& message);

}  // namespace robot::memory
