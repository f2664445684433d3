// Comparison of other programs' message types with ours of the same name.
#pragma once

#include <google/protobuf/descriptor.h>

#include "robot/core/result.h"
#include "robot/memory/channel.h"

namespace robot::memory {

/// Returns an Error if `schema` has the encoding "protobuf" and is not readable or does
/// not describe the message it names.
Result<void> check_readable(const Schema& schema);

/// Returns an Error if bytes of `theirs` would be misread as `ours`. That is so if a field or an enum value has another
/// number, a field has another type, or a number belongs to another field. Fields that only one side knows are allowed.
/// Inner messages are compared too. `theirs` must be readable.
Result<void> check_same_meaning(const google::protobuf::Descriptor& ours, const Schema& theirs);

}  // namespace robot::memory
