#include "robot/nao/guardian/lola_connection.h"

#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "robot/core/local_address.h"

namespace robot::nao {
namespace {

Error gone(const char* how) { return Error{std::string("LoLA is gone: ") + how}; }

}  // namespace

Result<LolaConnection> LolaConnection::open(const std::filesystem::path& path) {
  const auto address = LocalAddress::of(path, "LoLA");
  if (!address) return address.failure();
  FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket || !address->connect(socket.get())) return file_error("LoLA: cannot connect to", path, errno);
  return LolaConnection(std::move(socket));
}

Result<void> LolaConnection::take_in() {
  char block[SensorFrames::kMaxBytes];
  const ssize_t n = ::recv(socket_.get(), block, sizeof block, 0);
  if (n == 0) return gone("it closed the connection");
  if (n < 0 && errno != EAGAIN && errno != EINTR) return gone(std::strerror(errno));
  if (n > 0) received_.append(block, static_cast<std::size_t>(n));
  return {};
}

Result<std::string_view> LolaConnection::frame() const {
  if (received_.empty()) return std::string_view();
  const Result<std::size_t> size = frames_.size_of_first(received_);
  if (!size) return size.failure();
  return std::string_view(received_).substr(0, *size);
}

Result<void> LolaConnection::answer(std::string_view bytes) {
  const Result<std::string_view> answered = frame();
  if (answered) received_.erase(0, answered->size());
  const ssize_t n = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (n == static_cast<ssize_t>(bytes.size())) return {};
  if (n >= 0 || errno == EAGAIN) return gone("it does not read the answers");
  return gone(std::strerror(errno));
}

}  // namespace robot::nao
