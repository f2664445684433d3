#include "robot/core/local_listener.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "robot/core/local_address.h"

namespace robot {
namespace {

FileDescriptor make_socket(int type) {
  return FileDescriptor(::socket(AF_UNIX, type | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

/// Removes the socket file that a killed process left at `path`, and nothing else.
Result<void> make_way(const std::filesystem::path& path, const LocalAddress& address, const ListenOptions& options) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return {};
  if (!S_ISSOCK(status.st_mode) || status.st_uid != ::geteuid())
    return Error{options.who + ": expected nothing or a socket of user " + std::to_string(::geteuid()) + " at " +
                 path.string() + ", got something else"};
  const FileDescriptor probe = make_socket(options.type);
  if (address.connect(probe.get()) || errno != ECONNREFUSED)
    return Error{options.who + ": expected nobody to listen at " + path.string() + ", " + options.another};
  if (::unlink(path.c_str()) != 0) return file_error(options.who + ": cannot replace", path, errno);
  return {};
}

}  // namespace

Result<FileDescriptor> listen_locally(const std::filesystem::path& path, const ListenOptions& options) {
  const auto address = LocalAddress::of(path, options.who);
  if (!address) return address.failure();
  if (Result<void> free = make_way(path, *address, options); !free) return free.failure();
  FileDescriptor socket = make_socket(options.type);
  if (!socket || !address->listen(socket.get(), options.backlog))
    return file_error(options.who + ": cannot listen at", path, errno);
  return socket;
}

}  // namespace robot
