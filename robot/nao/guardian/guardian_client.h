// The client's end of the link, for the runtime or a person at a shell.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "robot/nao/guardian/link.h"

namespace robot::nao {

/// A connection to the guardian.
class GuardianClient {
 public:
  /// Connects to the guardian. Returns an Error if there is none.
  static Result<GuardianClient> open(const std::filesystem::path& path);

  /// Returns the next report, or nothing if none came within `patience_ms`. Returns an Error if the guardian is gone or
  /// is of another build.
  Result<std::optional<Report>> next(int patience_ms);

  /// Sends without waiting. Returns an Error if the guardian is gone. A guardian that does not read loses the message,
  /// and notices by itself that orders are missing.
  Result<void> give(const Order& order);
  Result<void> ask(Request::What what);

 private:
  explicit GuardianClient(FileDescriptor socket) : socket_(std::move(socket)) {}
  Result<void> send(const void* bytes, std::size_t size);

  FileDescriptor socket_;
};

}  // namespace robot::nao
