// The other end of the link: what the runtime, or a person at a shell, uses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "robot/nao/guardian/link.h"

namespace robot::nao {

class GuardianClient {
 public:
  /// An Error if there is no guardian.
  static Result<GuardianClient> open(const std::filesystem::path& path);

  /// The next report; waits at most `patience_ms` for one, nothing if none came. An Error: the guardian is gone, or of
  /// another build.
  Result<std::optional<Report>> next(int patience_ms);

  /// Without waiting; an Error if the guardian is gone. One that does not read loses it, which it notices by itself.
  Result<void> give(const Order& order);
  Result<void> ask(Request::What what);

 private:
  explicit GuardianClient(FileDescriptor socket) : socket_(std::move(socket)) {}
  Result<void> send(const void* bytes, std::size_t size);

  FileDescriptor socket_;
};

}  // namespace robot::nao
