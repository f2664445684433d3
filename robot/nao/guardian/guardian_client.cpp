#include "robot/nao/guardian/guardian_client.h"

#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "robot/core/local_address.h"

namespace robot::nao {

Result<GuardianClient> GuardianClient::open(const std::filesystem::path& path) {
  const auto address = LocalAddress::of(path, "guardian");
  if (!address) return address.failure();
  FileDescriptor socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket || !address->connect(socket.get()))
    return Error{"guardian: expected foresight-guardian to listen at " + path.string() + ", got " +
                 std::strerror(errno) + "; start it first"};
  return GuardianClient(std::move(socket));
}

Result<std::optional<Report>> GuardianClient::next(int patience_ms) {
  pollfd ready{.fd = socket_.get(), .events = POLLIN, .revents = 0};
  if (::poll(&ready, 1, patience_ms) <= 0) return std::optional<Report>();
  char message[sizeof(Report) + 1];
  const ssize_t n = ::recv(socket_.get(), message, sizeof message, 0);
  if (n < 0 && (errno == EAGAIN || errno == EINTR)) return std::optional<Report>();
  if (n <= 0) return Error{"guardian: the connection ended"};
  std::uint32_t layout = 0;
  if (n == sizeof(Report)) std::memcpy(&layout, message, sizeof layout);
  if (layout != kReportLayout)
    return Error{"guardian: expected a guardian of the same build, got one of another build; restart it"};
  std::optional<Report> report(std::in_place);
  std::memcpy(&*report, message, sizeof(Report));
  return report;
}

Result<void> GuardianClient::send(const void* bytes, std::size_t size) {
  const ssize_t n = ::send(socket_.get(), bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
  if (n < 0 && errno != EAGAIN && errno != EINTR) return Error{"guardian: the connection ended"};
  return {};
}

Result<void> GuardianClient::give(const Order& order) { return send(&order, sizeof order); }

Result<void> GuardianClient::ask(Request::What what) {
  const Request request{.what = what};
  return send(&request, sizeof request);
}

}  // namespace robot::nao
