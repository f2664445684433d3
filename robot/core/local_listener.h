// Listening at a local socket that no other process uses.
#pragma once

#include <filesystem>
#include <string>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace robot {

/// The settings of listen_locally().
struct ListenOptions {
  std::string who;      // first word of each error sentence, such as "door"
  std::string another;  // advice when another process listens there, such as "another runtime does; end it"
  int type = 0;         // SOCK_STREAM or SOCK_SEQPACKET
  int backlog = 128;
};

/// Opens a non-blocking socket that listens at `path`, for programs of our user only. Removes the socket file of a
/// killed process. Returns an Error if another process listens there or `path` is something
/// other than a socket of our user.
Result<FileDescriptor> listen_locally(const std::filesystem::path& path, const ListenOptions& options);

}  // namespace robot
