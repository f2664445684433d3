#include "robot/game/udp_socket.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "robot/core/clock.h"

namespace robot::game {
namespace {

constexpr std::size_t kMaxPacketBytes = 2048;

sockaddr_in address_of(const Endpoint& endpoint) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(endpoint.address);
  address.sin_port = htons(endpoint.port);
  return address;
}

Endpoint endpoint_of(const sockaddr_in& address) { return {ntohl(address.sin_addr.s_addr), ntohs(address.sin_port)}; }

sockaddr* generic(sockaddr_in& address) { return reinterpret_cast<sockaddr*>(&address); }

Error socket_error(const std::string& what) { return Error{what + ": " + std::strerror(errno)}; }

bool set_option(const FileDescriptor& socket, int option) {
  const int on = 1;
  return ::setsockopt(socket.get(), SOL_SOCKET, option, &on, sizeof on) == 0;
}

}  // namespace

std::string text_of(const Endpoint& endpoint) {
  const std::uint32_t a = endpoint.address;
  return std::to_string(a >> 24) + "." + std::to_string(a >> 16 & 255) + "." + std::to_string(a >> 8 & 255) + "." +
         std::to_string(a & 255) + ":" + std::to_string(endpoint.port);
}

Result<std::uint32_t> parse_address(std::string_view text) {
  in_addr address{};
  if (::inet_pton(AF_INET, std::string(text).c_str(), &address) != 1)
    return Error{"address: expected one such as 192.168.14.2, got '" + std::string(text) + "'"};
  return ntohl(address.s_addr);
}

bool is_own_address(std::uint32_t address) {
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) return false;
  bool own = false;
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next)
    if (entry->ifa_addr != nullptr && entry->ifa_addr->sa_family == AF_INET)
      own |= endpoint_of(*reinterpret_cast<const sockaddr_in*>(entry->ifa_addr)).address == address;
  ::freeifaddrs(list);
  return own;
}

Result<UdpSocket> UdpSocket::open(std::uint32_t address, std::uint16_t port) {
  UdpSocket opened;
  opened.socket_ = FileDescriptor(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  opened.wake_ = FileDescriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  sockaddr_in here = address_of({address, port});
  socklen_t size = sizeof here;
  if (!opened.socket_ || !opened.wake_ || !set_option(opened.socket_, SO_REUSEADDR) ||
      !set_option(opened.socket_, SO_BROADCAST) || ::bind(opened.socket_.get(), generic(here), size) != 0 ||
      ::getsockname(opened.socket_.get(), generic(here), &size) != 0)
    return socket_error("cannot listen on UDP " + text_of({address, port}));
  opened.port_ = endpoint_of(here).port;
  return opened;
}

std::optional<Datagram> UdpSocket::receive(std::optional<std::uint64_t> deadline_ns) {
  Datagram datagram;
  while (true) {
    int wait_ms = -1;
    if (deadline_ns) {
      const std::uint64_t now_ns = monotonic_ns();
      // rounded up, because a wait that ends too early would spin
      const std::uint64_t left_ns = *deadline_ns - std::min(*deadline_ns, now_ns) + kMillisecond - 1;
      wait_ms = static_cast<int>(std::min<std::uint64_t>(left_ns / kMillisecond, 60'000));
    }
    pollfd waited[] = {{.fd = wake_.get(), .events = POLLIN, .revents = 0},
                       {.fd = socket_.get(), .events = POLLIN, .revents = 0}};
    const int ready = ::poll(waited, 2, wait_ms);
    if (ready > 0 && waited[0].revents != 0) return std::nullopt;
    if (ready == 0 && monotonic_ns() >= deadline_ns) return std::nullopt;
    if (ready <= 0) continue;

    datagram.bytes.resize(kMaxPacketBytes);
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t n = ::recvfrom(socket_.get(), datagram.bytes.data(), datagram.bytes.size(), 0, generic(from), &size);
    if (n < 0) continue;  // the error of an earlier send(), or a packet with a wrong checksum
    datagram.bytes.resize(static_cast<std::size_t>(n));
    datagram.from = endpoint_of(from);
    return datagram;
  }
}

void UdpSocket::wake() {
  *woken_ = true;
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
}

Result<void> UdpSocket::send(const Endpoint& to, std::string_view bytes) {
  sockaddr_in address = address_of(to);
  if (::sendto(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL, generic(address), sizeof address) < 0)
    return socket_error("cannot send to " + text_of(to));
  return {};
}

}  // namespace robot::game
