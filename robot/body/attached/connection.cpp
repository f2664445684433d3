#include "robot/body/attached/connection.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace robot::body {
namespace {

constexpr std::size_t kBlockBytes = 65536;
constexpr std::size_t kMaxWaitingFiles = 4;  // a process sends one together with the frame that names it

void wait_for(int file, short events) {
  pollfd ready{.fd = file, .events = events, .revents = 0};
  while (::poll(&ready, 1, -1) < 0 && errno == EINTR) {
  }
}

/// Keeps the files that came with a piece of a stream.
void keep_files(msghdr& piece, std::deque<FileDescriptor>& files) {
  for (cmsghdr* extra = CMSG_FIRSTHDR(&piece); extra; extra = CMSG_NXTHDR(&piece, extra)) {
    if (extra->cmsg_level != SOL_SOCKET || extra->cmsg_type != SCM_RIGHTS) continue;
    for (std::size_t at = 0; CMSG_LEN(at + sizeof(int)) <= extra->cmsg_len; at += sizeof(int)) {
      int number = -1;
      std::memcpy(&number, CMSG_DATA(extra) + at, sizeof number);
      files.emplace_back(number);
    }
  }
}

}  // namespace

Connection::Connection(FileDescriptor socket) : socket_(std::move(socket)) {
  ucred credentials{};
  socklen_t size = sizeof credentials;
  if (::getsockopt(socket_.get(), SOL_SOCKET, SO_PEERCRED, &credentials, &size) == 0)
    peer_ = {.process = credentials.pid, .user = credentials.uid};
  else
    peer_ = {.process = 0, .user = static_cast<uid_t>(-1)};
}

bool Connection::gone() const {
  pollfd hung_up{.fd = socket_.get(), .events = POLLRDHUP, .revents = 0};
  return ::poll(&hung_up, 1, 0) > 0;
}

bool Connection::receive() {
  while (true) {
    char block[kBlockBytes];
    alignas(cmsghdr) char extra[CMSG_SPACE(kMaxWaitingFiles * sizeof(int))];
    iovec bytes{.iov_base = block, .iov_len = sizeof block};
    msghdr piece{};
    piece.msg_iov = &bytes;
    piece.msg_iovlen = 1;
    piece.msg_control = extra;
    piece.msg_controllen = sizeof extra;
    const ssize_t n = ::recvmsg(socket_.get(), &piece, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
    if (n == 0) return false;
    keep_files(piece, received_);
    if (received_.size() > kMaxWaitingFiles) return false;
    parser_.feed({block, static_cast<std::size_t>(n)});
    return true;
  }
}

Result<std::optional<logging::Frame>> Connection::next() {
  Result<std::optional<logging::Frame>> frame = parser_.next();
  if (!frame || !*frame || !std::holds_alternative<logging::SharedMemory>(**frame)) return frame;
  if (received_.empty()) return Error{"expected a file together with its frame, got none"};
  shared_ = std::move(received_.front());
  received_.pop_front();
  struct stat status {};
  // a read from any other kind of file could block
  if (::fstat(shared_.get(), &status) != 0 || !S_ISREG(status.st_mode))
    return Error{"expected an ordinary file to share messages in, got something else"};
  return frame;
}

Result<std::string> Connection::copy(const logging::SharedMessage& message) const {
  if (!shared_) return Error{"expected a file before the first message that lies in it, got none"};
  std::string bytes(static_cast<std::size_t>(message.length), '\0');
  std::size_t copied = 0;
  while (copied < bytes.size()) {
    const ssize_t n = ::pread(shared_.get(), bytes.data() + copied, bytes.size() - copied,
                              static_cast<off_t>(message.offset + copied));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0)
      return Error{"expected a shared message of " + std::to_string(message.length) + " bytes at " +
                   std::to_string(message.offset) + ", got " + std::to_string(copied)};
    copied += static_cast<std::size_t>(n);
  }
  return bytes;
}

bool Connection::send(std::string_view bytes) {
  ssize_t n = 0;
  do n = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  while (n < 0 && errno == EINTR);
  return n == static_cast<ssize_t>(bytes.size());
}

bool Connection::send_waiting(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      wait_for(socket_.get(), POLLOUT);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

void Connection::wait() { wait_for(socket_.get(), POLLIN); }

void Connection::end() { ::shutdown(socket_.get(), SHUT_RDWR); }

}  // namespace robot::body
