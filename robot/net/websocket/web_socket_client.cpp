#include "robot/net/websocket/web_socket_client.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <random>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/encoding.h"
#include "robot/net/websocket/handshake.h"

namespace robot::net {
namespace {

constexpr std::uint64_t kForever = UINT64_MAX;
constexpr std::size_t kMaxHeadBytes = 16 << 10;
constexpr const char* kCancelled = "cancelled";

std::string random_bytes(std::size_t size) {
  std::random_device random;
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(random());
  return bytes;
}

struct AddressList {
  ~AddressList() {
    if (first) freeaddrinfo(first);
  }
  addrinfo* first = nullptr;
};

}  // namespace

std::string WebSocketUrl::authority() const {
  return (host.find(':') == std::string::npos ? host : "[" + host + "]") + ":" + port;
}

Result<WebSocketUrl> parse_web_socket_url(std::string_view url) {
  constexpr std::string_view kScheme = "ws://";
  const Error wrong{"'" + std::string(url.substr(0, 200)) + "': expected an address such as ws://10.0.14.2:8765"};
  if (!url.starts_with(kScheme) || url.find_first_of(" \r\n\t#") != std::string_view::npos) return wrong;
  url.remove_prefix(kScheme.size());

  const std::size_t end = std::min(url.find_first_of("/?"), url.size());
  std::string_view authority = url.substr(0, end);
  WebSocketUrl result{.target = std::string(url.substr(end))};
  if (!result.target.starts_with('/')) result.target.insert(0, "/");

  const std::size_t host_end = authority.starts_with('[') ? authority.find(']') : 0;
  if (host_end == std::string_view::npos) return wrong;
  const std::size_t colon = authority.find(':', host_end);
  if (colon != std::string_view::npos) {
    result.port = authority.substr(colon + 1);
    authority = authority.substr(0, colon);
  }
  if (authority.starts_with('[')) authority = authority.substr(1, host_end - 1);
  result.host = authority;
  const bool port_ok = !result.port.empty() && result.port.size() <= 5 &&
                       std::ranges::all_of(result.port, [](char c) { return c >= '0' && c <= '9'; });
  if (result.host.empty() || !port_ok) return wrong;
  return result;
}

WebSocketClient::WebSocketClient() : wake_up_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

void WebSocketClient::cancel() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_up_.get(), &one, sizeof one);  // stays readable forever
}

// returns false when cancelled, an Error at the deadline
Result<bool> WebSocketClient::wait(short events, std::uint64_t deadline_ns) {
  while (true) {
    pollfd fds[] = {{socket_.get(), events, 0}, {wake_up_.get(), POLLIN, 0}};
    int timeout_ms = -1;
    if (deadline_ns != kForever) {
      const std::uint64_t now = monotonic_ns();
      if (now >= deadline_ns) return Error{name_ + ": no answer in time"};
      timeout_ms = static_cast<int>(std::min<std::uint64_t>((deadline_ns - now) / kMillisecond + 1, 3600'000));
    }
    if (::poll(fds, 2, timeout_ms) < 0 && errno != EINTR) return Error{name_ + ": " + std::strerror(errno)};
    if (fds[1].revents != 0) return false;
    if (fds[0].revents != 0) return true;
  }
}

Result<void> WebSocketClient::open_socket(const WebSocketUrl& url, std::uint64_t deadline_ns) {
  AddressList addresses;
  const addrinfo hints{.ai_flags = AI_NUMERICSERV, .ai_socktype = SOCK_STREAM};
  if (const int error = getaddrinfo(url.host.c_str(), url.port.c_str(), &hints, &addresses.first); error != 0)
    return Error{name_ + ": " + gai_strerror(error)};

  int last_error = 0;
  for (const addrinfo* address = addresses.first; address; address = address->ai_next) {
    socket_ = FileDescriptor(::socket(address->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!socket_) return Error{name_ + ": " + std::strerror(errno)};
    const int on = 1;
    ::setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    last_error = ::connect(socket_.get(), address->ai_addr, address->ai_addrlen) == 0 ? 0 : errno;
    if (last_error == EINPROGRESS) {
      const auto ready = wait(POLLOUT, deadline_ns);
      if (!ready) return Error{ready.error()};
      if (!*ready) return Error{name_ + ": " + kCancelled};
      socklen_t size = sizeof last_error;
      ::getsockopt(socket_.get(), SOL_SOCKET, SO_ERROR, &last_error, &size);
    }
    if (last_error == 0) return {};
  }
  return Error{name_ + ": " + std::strerror(last_error)};
}

Result<void> WebSocketClient::connect(std::string_view text, std::uint64_t timeout_ns) {
  // the token must not appear in error sentences
  name_ = std::string(text.substr(0, std::min(text.find('?'), text.size())));
  const std::uint64_t deadline_ns = monotonic_ns() + timeout_ns;
  const auto url = parse_web_socket_url(text);
  if (!url) return Error{url.error()};
  if (auto opened = open_socket(*url, deadline_ns); !opened) return opened;

  const std::string key = to_base64(random_bytes(16));
  if (auto sent = write_all(web_socket_request(url->authority(), url->target, key)); !sent) return sent;
  std::string head;
  std::size_t end = std::string::npos;
  while (end == std::string::npos) {
    char block[4096];
    const auto size = read_some(block, sizeof block, deadline_ns);
    if (!size) return Error{size.error()};
    if (*size == 0 || head.size() > kMaxHeadBytes) return Error{name_ + ": expected an HTTP response, got none"};
    head.append(block, *size);
    end = head.find("\r\n\r\n");
  }
  const auto agreed = check_web_socket_response(std::string_view(head).substr(0, end + 2), key);
  if (!agreed) {
    // our servers give the reason in the body
    const std::string_view body = std::string_view(head).substr(end + 4);
    return Error{name_ + ": " + agreed.error() + (body.empty() ? "" : ": ") +
                 std::string(body.substr(0, body.find('\n')))};
  }
  const auto violation =
      parser_.feed(std::string_view(head).substr(end + 4),
                   [this](Opcode opcode, std::string payload) { return on_frame(opcode, std::move(payload)); });
  if (violation) return Error{name_ + ": " + violation->sentence};
  return {};
}

// returns 0 at the end of the connection
Result<std::size_t> WebSocketClient::read_some(char* to, std::size_t size, std::uint64_t deadline_ns) {
  while (true) {
    const auto ready = wait(POLLIN, deadline_ns);
    if (!ready) return Error{ready.error()};
    if (!*ready) return Error{name_ + ": " + kCancelled};
    const ssize_t n = ::recv(socket_.get(), to, size, 0);
    if (n >= 0) return static_cast<std::size_t>(n);
    if (errno != EINTR && errno != EAGAIN) return Error{name_ + ": " + std::strerror(errno)};
  }
}

Result<void> WebSocketClient::write_all(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
    } else if (errno == EAGAIN) {
      const auto ready = wait(POLLOUT, kForever);
      if (!ready) return Error{ready.error()};
      if (!*ready) return Error{name_ + ": " + kCancelled};
    } else if (errno != EINTR) {
      return Error{name_ + ": " + std::strerror(errno)};
    }
  }
  return {};
}

Result<void> WebSocketClient::send(Opcode opcode, std::string_view payload) {
  // a mask keeps proxies from misreading our bytes; it need not be secret
  static std::atomic<std::uint32_t> mask = 0x9d2c5681;
  std::string frame;
  append_masked_frame(frame, opcode, payload, mask.fetch_add(0x9e3779b9, std::memory_order_relaxed));
  return write_all(frame);
}

bool WebSocketClient::on_frame(Opcode opcode, std::string payload) {
  if (opcode == Opcode::text || opcode == Opcode::binary) {
    received_.push_back({opcode, std::move(payload)});
    return true;
  }
  if (opcode == Opcode::ping) append_masked_frame(pongs_, Opcode::pong, payload, 0x5bd1e995);
  if (opcode != Opcode::close) return true;
  closed_ = parse_close(payload);
  append_masked_frame(pongs_, Opcode::close, payload.substr(0, 2), 0x5bd1e995);
  return false;
}

Result<std::optional<WebSocketClient::Message>> WebSocketClient::receive(std::uint64_t deadline_ns) {
  while (true) {
    if (!pongs_.empty())
      // the next read notices a server that has gone
      static_cast<void>(write_all(std::exchange(pongs_, {})).operator bool());
    if (!received_.empty()) {
      Message message = std::move(received_.front());
      received_.pop_front();
      return std::optional(std::move(message));
    }
    if (closed_) return std::optional<Message>();

    const auto ready = wait(POLLIN, deadline_ns);
    if (!ready) return Error{ready.error()};
    if (!*ready) return std::optional<Message>();
    char block[65536];
    const auto size = read_some(block, sizeof block, deadline_ns);
    if (!size) return Error{size.error()};
    if (*size == 0) return Error{name_ + ": the connection ended without a goodbye"};
    const auto violation = parser_.feed(
        {block, *size}, [this](Opcode opcode, std::string payload) { return on_frame(opcode, std::move(payload)); });
    if (violation) return Error{name_ + ": " + violation->sentence};
  }
}

}  // namespace robot::net
