#include "robot/core/local_address.h"

#include <sys/stat.h>

#include <cstring>

namespace robot {

Result<LocalAddress> LocalAddress::of(const std::filesystem::path& path, const std::string& who) {
  LocalAddress local;
  sockaddr_un& address = local.address_;
  address.sun_family = AF_UNIX;
  const std::size_t bytes = path.native().size();
  if (bytes == 0 || bytes >= sizeof address.sun_path)
    return Error{who + ": expected a path of 1 .. " + std::to_string(sizeof address.sun_path - 1) + " bytes, got " +
                 std::to_string(bytes)};
  std::memcpy(address.sun_path, path.c_str(), bytes + 1);
  return local;
}

bool LocalAddress::listen(int socket, int backlog) const {
  // on Linux the socket's file gets the mode that the socket has before bind(): other users can never connect
  return ::fchmod(socket, 0600) == 0 && ::bind(socket, get(), sizeof address_) == 0 && ::listen(socket, backlog) == 0;
}

}  // namespace robot
