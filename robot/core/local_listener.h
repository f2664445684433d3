// Listening at a local socket, where nobody else does.
#pragma once

#include <filesystem>
#include <string>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace robot {

struct ListenOptions {
  std::string who;      // sentences begin with it: "door"
  std::string another;  // what to do about somebody who listens there: "another runtime does; end it"
  int type = 0;         // SOCK_STREAM or SOCK_SEQPACKET
  int backlog = 128;
};

/// A socket at `path` that never blocks, for programs of our user only. One that was left behind by a process that was
/// killed is taken away; an Error if somebody listens there, or something else is there.
Result<FileDescriptor> listen_locally(const std::filesystem::path& path, const ListenOptions& options);

}  // namespace robot
