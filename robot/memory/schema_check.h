// Whether others mean what we mean by a message of the same name.
#pragma once

#include <google/protobuf/descriptor.h>

#include "robot/core/result.h"
#include "robot/memory/channel.h"

namespace robot::memory {

/// An Error if `schema` is of encoding "protobuf" and cannot be read, or does not describe the message it names.
Result<void> check_readable(const Schema& schema);

/// An Error if bytes written by `theirs`, which is readable, would be misread as `ours`: a field or a value of an enum
/// that has another number, a field of another type, a number that means another field. Fields that only one side knows
/// are welcome. Messages within the message are looked at too.
Result<void> check_same_meaning(const google::protobuf::Descriptor& ours, const Schema& theirs);

}  // namespace robot::memory
