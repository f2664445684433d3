// Where a local socket lives: a path, for programs of this machine only.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>

#include <filesystem>
#include <string>

#include "robot/core/result.h"

namespace robot {

class LocalAddress {
 public:
  /// Fails for a path that is empty or longer than the system takes (107 bytes); the sentence begins with `who`.
  static Result<LocalAddress> of(const std::filesystem::path& path, const std::string& who);

  bool connect(int socket) const { return ::connect(socket, get(), sizeof address_) == 0; }

  /// Lets `socket` listen here, for programs of our user only and from the first moment on. When false, errno says why.
  bool listen(int socket, int backlog) const;

 private:
  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&address_); }

  sockaddr_un address_{};
};

}  // namespace robot
