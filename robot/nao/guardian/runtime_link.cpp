#include "robot/nao/guardian/runtime_link.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "robot/core/clock.h"
#include "robot/core/local_listener.h"

namespace robot::nao {
namespace {

constexpr int kBacklog = 8;
constexpr std::uint64_t kRestNs = 100 * kMillisecond;
// [bytes] of reports queued for a client that does not read; the kernel doubles it and counts its own overhead
constexpr int kSendBuffer = 16384;

}  // namespace

std::filesystem::path default_link() {
  if (const char* path = std::getenv("FORESIGHT_GUARDIAN"); path && *path) return path;
  return "/dev/shm/foresight-" + std::to_string(::geteuid()) + ".guardian";
}

Result<RuntimeLink> RuntimeLink::open(const std::filesystem::path& path) {
  auto listening = listen_locally(path, {.who = "guardian",
                                         .another = "another guardian does; end it, or choose another --link",
                                         .type = SOCK_SEQPACKET,
                                         .backlog = kBacklog});
  if (!listening) return listening.failure();
  return RuntimeLink(std::move(*listening));
}

void RuntimeLink::add_to(std::vector<pollfd>& files) const {
  // poll ignores a negative number
  const bool rests = monotonic_ns() < rests_until_ns_;
  files.push_back({.fd = rests ? -1 : listening_.get(), .events = POLLIN, .revents = 0});
  for (const Connection& connection : connections_)
    files.push_back({.fd = connection.socket.get(), .events = POLLIN, .revents = 0});
}

bool RuntimeLink::has_runtime() const {
  return std::any_of(connections_.begin(), connections_.end(), [](const Connection& c) { return c.is_runtime; });
}

void RuntimeLink::take_in() {
  while (true) {
    FileDescriptor socket(::accept4(listening_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket && errno != EAGAIN && errno != EINTR) rests_until_ns_ = monotonic_ns() + kRestNs;
    if (!socket) return;
    if (connections_.size() >= kMaxConnections && !make_room()) continue;
    ::setsockopt(socket.get(), SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof kSendBuffer);
    connections_.push_back({.socket = std::move(socket)});
  }
}

/// Ends the oldest connection that has sent nothing. Returns whether there is one.
bool RuntimeLink::make_room() {
  const auto silent = std::find_if(connections_.begin(), connections_.end(),
                                   [](const Connection& c) { return c.was_heard && !c.spoke; });
  if (silent == connections_.end()) return false;
  connections_.erase(silent);
  return true;
}

void RuntimeLink::hear(Connection& connection, Heard& heard) {
  connection.was_heard = true;
  while (!connection.ended) {
    // one byte more than any message, so that a longer one is noticed
    alignas(Order) char message[std::max(sizeof(Order), sizeof(Request)) + 1];
    const ssize_t n = ::recv(connection.socket.get(), message, sizeof message, 0);
    if (n < 0 && (errno == EAGAIN || errno == EINTR)) return;
    // the client closed with unread reports; the kernel returns this error once, before the client's last messages
    if (n < 0 && errno == ECONNRESET) continue;
    connection.spoke = connection.spoke || n > 0;
    std::uint32_t layout = 0;
    if (n >= static_cast<ssize_t>(sizeof layout)) std::memcpy(&layout, message, sizeof layout);
    if (n == sizeof(Request) && layout == kRequestLayout) {
      Request request;
      std::memcpy(&request, message, sizeof request);
      if (request.what == Request::What::sit_and_soft) heard.asked_soft = true;
      if (request.what == Request::What::goodbye) connection.says_goodbye = true;
    } else if (n == sizeof(Order) && layout == kOrderLayout) {
      if (!connection.is_runtime && has_runtime()) continue;
      connection.is_runtime = true;
      std::memcpy(&heard.order.emplace(), message, sizeof(Order));
    } else {
      // the connection ended, or the client is of another build
      connection.ended = true;
    }
  }
}

RuntimeLink::Heard RuntimeLink::hear() {
  Heard heard;
  // before new connections, which may take the place of silent ones: no request is lost
  for (Connection& connection : connections_) hear(connection, heard);
  take_in();
  for (Connection& connection : connections_) {
    hear(connection, heard);
    if (!connection.ended || !connection.is_runtime) continue;
    (connection.says_goodbye ? heard.runtime_left : heard.runtime_crashed) = true;
    heard.order.reset();
  }
  connections_.remove_if([](const Connection& connection) { return connection.ended; });
  return heard;
}

void RuntimeLink::tell(const Report& report) {
  for (const Connection& connection : connections_)
    ::send(connection.socket.get(), &report, sizeof report, MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace robot::nao
