#include "robot/logging/streams/local_socket.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

#include "robot/core/local_address.h"

namespace robot::logging {
namespace {

constexpr int kBacklog = 4;
constexpr int kCancelCheckMs = 50;  // how soon a cancel() is noticed by a thread that waits for the other side

Result<LocalAddress> address_of(const std::filesystem::path& path) {
  return LocalAddress::of(path, "local socket " + path.string());
}

}  // namespace

Result<void> LocalSocketOutProvider::open(const memory::ChannelInfo& info) {
  info_ = info;
  return connect();
}

Result<void> LocalSocketOutProvider::connect() {
  const auto address = address_of(path_);
  if (!address) return Error{address.error()};
  FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (!socket || !address->connect(socket.get())) return file_error("cannot connect to", path_, errno);
  socket_ = std::move(socket);
  return send(channel_frame(info_));
}

Result<void> LocalSocketOutProvider::send(std::string_view bytes) {
  while (!bytes.empty()) {
    pollfd writable{.fd = socket_.get(), .events = POLLOUT, .revents = 0};
    if (::poll(&writable, 1, kCancelCheckMs) == 0) {
      if (!cancelled_) continue;
      socket_.reset();
      return Error{"local socket " + path_.string() + ": ended while the other side was not reading"};
    }
    const ssize_t n = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (n < 0) {
      const int reason = errno;
      socket_.reset();  // the other side is gone; half a message must not be continued
      return file_error("cannot write to", path_, reason);
    }
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return {};
}

Result<void> LocalSocketOutProvider::write(const memory::VersionPtr& version) {
  if (!socket_)
    if (Result<void> connected = connect(); !connected) return connected;
  if (Result<void> sent = send(message_frame_head(*version)); !sent) return sent;
  return send(version->bytes());
}

Result<void> LocalSocketOutProvider::close() {
  socket_.reset();
  return {};
}

void LocalSocketOutProvider::cancel() {
  // what is queued still goes out as long as the other side takes it
  cancelled_ = true;
}

LocalSocketInProvider::~LocalSocketInProvider() {
  if (listening_) ::unlink(path_.c_str());
}

void LocalSocketInProvider::cancel() { cancelled_ = true; }

Result<void> LocalSocketInProvider::listen() {
  const auto address = address_of(path_);
  if (!address) return Error{address.error()};
  ::unlink(path_.c_str());  // left behind by a process that was killed
  FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (!socket || !address->listen(socket.get(), kBacklog)) return file_error("cannot listen at", path_, errno);
  listening_ = std::move(socket);
  return {};
}

/// Waits until `file` can be read; false when the stream was cancelled instead.
bool LocalSocketInProvider::wait_for(int file) {
  pollfd readable{.fd = file, .events = POLLIN, .revents = 0};
  while (!cancelled_)
    if (::poll(&readable, 1, kCancelCheckMs) > 0) return true;
  return false;
}

bool LocalSocketInProvider::accept() {
  while (!connection_) {
    if (!wait_for(listening_.get())) return false;
    connection_ = FileDescriptor(::accept4(listening_.get(), nullptr, nullptr, SOCK_CLOEXEC));
  }
  parser_ = {};
  return true;
}

/// The next frame of the connection at hand; nothing when that has ended or was cancelled.
Result<std::optional<Frame>> LocalSocketInProvider::next_frame() {
  while (true) {
    Result<std::optional<Frame>> frame = parser_.next();
    if (!frame || *frame) return frame;
    char block[65536];
    if (!wait_for(connection_.get())) return std::optional<Frame>();
    const ssize_t n = ::read(connection_.get(), block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return std::optional<Frame>();
    parser_.feed({block, static_cast<std::size_t>(n)});
  }
}

Result<memory::ChannelInfo> LocalSocketInProvider::open() {
  if (Result<void> listening = listen(); !listening) return Error{listening.error()};
  while (accept()) {
    Result<std::optional<Frame>> frame = next_frame();
    if (!frame) return Error{frame.error()};
    if (*frame) {
      auto* info = std::get_if<memory::ChannelInfo>(&**frame);
      if (!info) return Error{"local socket " + path_.string() + ": expected a channel first, got something else"};
      return info_ = std::move(*info);
    }
    connection_.reset();
  }
  return Error{"local socket " + path_.string() + ": cancelled before a stream came"};
}

Result<std::optional<Record>> LocalSocketInProvider::read() {
  while (!broken_ && (connection_ || accept())) {
    Result<std::optional<Frame>> frame = next_frame();
    broken_ = !frame;
    if (!frame) return Error{frame.error()};
    if (!*frame) {
      connection_.reset();
      if (cancelled_) break;
      continue;
    }
    if (auto* record = std::get_if<Record>(&**frame)) return std::optional<Record>(std::move(*record));
    const auto* again = std::get_if<memory::ChannelInfo>(&**frame);
    broken_ = !again || *again != info_;
    if (broken_)
      return Error{"local socket " + path_.string() + ": expected messages or the channel " + info_.topic +
                   " again, got " + (again ? again->topic : "what is said at the door only")};
  }
  return std::optional<Record>();
}

}  // namespace robot::logging
