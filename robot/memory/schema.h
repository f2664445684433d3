// The schema of a protobuf message, enough for other programs to read its bytes.
#pragma once

#include <google/protobuf/descriptor.h>

#include "robot/memory/channel.h"

namespace robot::memory {

/// Returns the name, the encoding "protobuf" and the serialised FileDescriptorSet of `message`.
/// The set holds each imported file once, and each file after the files that it imports.
Schema schema_of(const google::protobuf::Descriptor& message);

}  // namespace robot::memory
