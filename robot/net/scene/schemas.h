// The schemas of the foxglove.* messages that are written by hand, as protoc made them from proto/foxglove.
#pragma once

#include <string_view>

namespace robot::net {

/// Returns the serialised FileDescriptorSet of the message foxglove.<name>, with all imports, or nothing if there is none.
std::string_view embedded_schema(std::string_view name);

}  // namespace robot::net
