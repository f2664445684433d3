#include "robot/truth/feeds/multicast_socket.h"

#include <arpa/inet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "robot/core/clock.h"

namespace robot::truth {
namespace {

constexpr std::size_t kMaxPacketBytes = 65'536;  // no UDP packet is longer

Error multicast_error(const MulticastAddress& address, const char* what) {
  return Error{address.group + ":" + std::to_string(address.port) + ": " + what + ": " + std::strerror(errno)};
}

/// Returns the numbers of the interfaces on which to listen.
std::vector<unsigned> interfaces_of(const MulticastAddress& address) {
  if (!address.interface.empty()) {
    const unsigned number = ::if_nametoindex(address.interface.c_str());
    return number == 0 ? std::vector<unsigned>() : std::vector<unsigned>{number};
  }
  std::vector<unsigned> numbers;
  struct if_nameindex* const list = ::if_nameindex();
  for (const auto* entry = list; entry && entry->if_index != 0; ++entry) numbers.push_back(entry->if_index);
  if (list) ::if_freenameindex(list);
  return numbers;
}

bool set_option(const FileDescriptor& socket, int level, int option, int value) {
  return ::setsockopt(socket.get(), level, option, &value, sizeof value) == 0;
}

/// Returns the time since the kernel's time stamp of a message, or 0 without one or if the system clock was stepped.
std::uint64_t age_of(msghdr& message) {
  for (cmsghdr* head = CMSG_FIRSTHDR(&message); head; head = CMSG_NXTHDR(&message, head)) {
    if (head->cmsg_level != SOL_SOCKET || head->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec stamp{};
    std::memcpy(&stamp, CMSG_DATA(head), sizeof stamp);
    const auto stamp_ns =
        static_cast<std::uint64_t>(stamp.tv_sec) * kSecond + static_cast<std::uint64_t>(stamp.tv_nsec);
    const std::uint64_t now_ns = system_ns();
    return now_ns >= stamp_ns && now_ns - stamp_ns < kSecond ? now_ns - stamp_ns : 0;
  }
  return 0;
}

}  // namespace

Result<MulticastSocket> MulticastSocket::open(const MulticastAddress& address) {
  MulticastSocket opened(address);
  in_addr group{};
  if (::inet_pton(AF_INET, address.group.c_str(), &group) != 1 || !IN_MULTICAST(ntohl(group.s_addr)))
    return Error{"expected a multicast address 224.0.0.0 .. 239.255.255.255, got '" + address.group + "'"};
  opened.group_ = group.s_addr;
  opened.socket_ = FileDescriptor(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  // not bound to the group's address: simulators on this machine may send to 127.0.0.1
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_port = htons(address.port);
  socklen_t size = sizeof here;
  auto* const generic = reinterpret_cast<sockaddr*>(&here);
  if (!opened.socket_ || !set_option(opened.socket_, SOL_SOCKET, SO_REUSEADDR, 1) ||
      !set_option(opened.socket_, IPPROTO_IP, IP_MULTICAST_ALL, 0) ||
      !set_option(opened.socket_, SOL_SOCKET, SO_TIMESTAMPNS, 1) || ::bind(opened.socket_.get(), generic, size) != 0 ||
      ::getsockname(opened.socket_.get(), generic, &size) != 0)
    return multicast_error(address, "cannot listen");
  opened.port_ = ntohs(here.sin_port);
  if (Result<void> joined = opened.join(); !joined) return joined.failure();
  return opened;
}

Result<void> MulticastSocket::join() {
  const std::vector<unsigned> interfaces = interfaces_of(address_);
  if (interfaces.empty())
    return Error{address_.interface.empty()
                     ? std::string("expected a network interface, this machine has none")
                     : "expected a network interface, none is called '" + address_.interface + "'"};
  bool joined = false;
  for (const unsigned number : interfaces) {
    ip_mreqn request{};
    request.imr_multiaddr.s_addr = group_;
    request.imr_ifindex = static_cast<int>(number);
    joined |= ::setsockopt(socket_.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &request, sizeof request) == 0 ||
              errno == EADDRINUSE;  // it takes part already
  }
  if (!joined) return multicast_error(address_, "cannot join the group");
  return {};
}

std::optional<MulticastSocket::Packet> MulticastSocket::receive(std::uint64_t deadline_ns) {
  Packet packet;
  packet.bytes.resize(kMaxPacketBytes);
  while (true) {
    const std::uint64_t now_ns = monotonic_ns();
    // rounded up, because a wait that ends too early would spin
    const std::uint64_t left_ms = (deadline_ns - std::min(deadline_ns, now_ns) + kMillisecond - 1) / kMillisecond;
    pollfd waiting{.fd = socket_.get(), .events = POLLIN, .revents = 0};
    ::poll(&waiting, 1, static_cast<int>(std::min<std::uint64_t>(left_ms, 60'000)));

    iovec piece{.iov_base = packet.bytes.data(), .iov_len = packet.bytes.size()};
    alignas(cmsghdr) char extra[CMSG_SPACE(sizeof(timespec))] = {};
    msghdr message{};
    message.msg_iov = &piece;
    message.msg_iovlen = 1;
    message.msg_control = extra;
    message.msg_controllen = sizeof extra;
    if (const ssize_t size = ::recvmsg(socket_.get(), &message, 0); size >= 0) {
      packet.bytes.resize(static_cast<std::size_t>(size));
      packet.age_ns = age_of(message);
      return packet;
    }
    if (monotonic_ns() >= deadline_ns) return std::nullopt;
  }
}

}  // namespace robot::truth
