// The address of a local (Unix) socket: a path, for programs of this machine only.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>

#include <filesystem>
#include <string>

#include "robot/core/result.h"

namespace robot {

/// The address of a local socket, checked for its length.
class LocalAddress {
 public:
  /// Returns an Error if the path is empty or longer than the system allows (107
  /// bytes). Its sentence begins with `who`.
  static Result<LocalAddress> of(const std::filesystem::path& path, const std::string& who);

  bool connect(int socket) const { return ::connect(socket, get(), sizeof address_) == 0; }

  /// Lets `socket` listen at this address, from the first moment on for programs of our user only. Returns false and
  /// sets errno on failure.
  bool listen(int socket, int backlog) const;

 private:
  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&address_); }

  sockaddr_un address_{};
};

}  // namespace robot
