#include "tests/bench/counting_client.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "robot/core/json_library.h"
#include "robot/core/little_endian.h"
#include "robot/net/foxglove/from_client.h"
#include "robot/net/foxglove/to_client.h"
#include "robot/net/websocket/web_socket_client.h"
#include "tests/bench/load.h"
#include "tests/support/masked_frame.h"

namespace bench {
namespace {

using nlohmann::json;
using robot::Error;
using robot::Result;
using robot::net::Opcode;

constexpr std::uint32_t kNoAge = UINT32_MAX;

Result<robot::FileDescriptor> open_socket(const robot::net::WebSocketUrl& url, int receive_buffer_bytes) {
  addrinfo* found = nullptr;
  const addrinfo hints{.ai_flags = AI_NUMERICSERV, .ai_socktype = SOCK_STREAM};
  if (const int error = getaddrinfo(url.host.c_str(), url.port.c_str(), &hints, &found); error != 0)
    return Error{url.authority() + ": " + gai_strerror(error)};
  robot::FileDescriptor socket(::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const int on = 1;
  ::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  if (receive_buffer_bytes > 0)
    ::setsockopt(socket.get(), SOL_SOCKET, SO_RCVBUF, &receive_buffer_bytes, sizeof receive_buffer_bytes);
  const bool connected = ::connect(socket.get(), found->ai_addr, found->ai_addrlen) == 0;
  const int error = errno;
  freeaddrinfo(found);
  if (!connected) return Error{url.authority() + ": " + std::strerror(error)};
  return socket;
}

bool write_all(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

// length of a frame header [bytes], from its first two bytes
std::size_t header_size(std::string_view header) {
  if (header.size() < 2) return 2;
  const auto length = static_cast<unsigned char>(header[1]);
  return length == 126 ? 4 : length == 127 ? 10 : 2;
}

}  // namespace

bool FrameCounter::take_header(std::string_view& bytes) {
  while (header_.size() < header_size(header_)) {
    const std::size_t n = std::min(header_size(header_) - header_.size(), bytes.size());
    if (n == 0) return false;
    header_.append(bytes.substr(0, n));
    bytes.remove_prefix(n);
  }
  opcode_ = static_cast<Opcode>(header_[0] & 15);
  size_ = static_cast<unsigned char>(header_[1]);
  if (header_.size() > 2) size_ = 0;
  for (std::size_t i = 2; i < header_.size(); ++i) size_ = size_ << 8 | static_cast<unsigned char>(header_[i]);
  left_ = size_;
  header_.clear();
  kept_.clear();
  return true;
}

void FrameCounter::take_payload(std::string_view& bytes) {
  const std::size_t n = std::min<std::uint64_t>(left_, bytes.size());
  const std::size_t wanted = opcode_ == Opcode::binary ? kHeadBytes - std::min(kHeadBytes, kept_.size()) : n;
  kept_.append(bytes.substr(0, std::min(n, wanted)));
  left_ -= n;
  bytes.remove_prefix(n);
}

bool Watch::wants(std::string_view topic) const {
  if (std::find(topics.begin(), topics.end(), topic) != topics.end()) return true;
  const bool camera =
      topic.find("/camera_top") != std::string_view::npos || topic.find("/camera_bottom") != std::string_view::npos;
  if (topic.ends_with("/jpeg")) return jpeg;
  for (const std::string_view derived : {"/raw", "/foxglove", "/scene", "/transforms", "/calibration"})
    if (topic.ends_with(derived)) return false;
  if (camera && !topic.ends_with("_matrix")) return images;
  return objects;
}

Result<Watch> parse_watch(std::string_view text) {
  Watch watch{.objects = false};
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    if (word == "objects")
      watch.objects = true;
    else if (word == "images")
      watch.images = true;
    else if (word == "jpeg")
      watch.jpeg = true;
    else if (word.starts_with('/'))
      watch.topics.emplace_back(word);
    else if (word != "nothing")
      return Error{"--watch: expected objects, images, jpeg, topics or nothing, got '" + std::string(word) + "'"};
    begin = end + 1;
  }
  return watch;
}

Result<void> CountingClient::connect() {
  const auto url = robot::net::parse_web_socket_url(options_.url);
  if (!url) return Error{url.error()};
  auto socket = open_socket(*url, options_.receive_buffer_bytes);
  if (!socket) return Error{socket.error()};
  socket_ = std::move(*socket);
  write_all(socket_.get(), "GET " + url->target + " HTTP/1.1\r\nHost: " + url->authority() + "\r\n" +
                               "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n" +
                               "Sec-WebSocket-Key: Zm9yZXNpZ2h0IGJlbmNoLg==\r\n" +
                               "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n");

  // byte by byte: read() reads the bytes after the response
  std::string head;
  for (char byte; !head.ends_with("\r\n\r\n"); head += byte)
    if (::recv(socket_.get(), &byte, 1, 0) != 1) return Error{options_.url + ": closed before it answered"};
  if (!head.starts_with("HTTP/1.1 101")) return Error{options_.url + ": " + head.substr(0, head.find("\r\n"))};
  for (const auto& [name, value] : options_.parameters)
    send(Opcode::text, json{{"op", "setParameters"},
                            {"parameters", {{{"name", name}, {"value", json::parse(value, nullptr, false)}}}}}
                           .dump());
  return {};
}

bool CountingClient::read(std::size_t most_bytes) {
  static thread_local std::array<char, 256 << 10> buffer;
  const ssize_t n = ::recv(socket_.get(), buffer.data(), std::min(most_bytes, buffer.size()), MSG_DONTWAIT);
  if (n < 0 && (errno == EAGAIN || errno == EINTR)) return true;
  if (n <= 0) {
    if (reason_.empty()) reason_ = n == 0 ? "closed without a word" : std::strerror(errno);
    return false;
  }
  bytes_ += static_cast<std::uint64_t>(n);
  frames_.feed({buffer.data(), static_cast<std::size_t>(n)}, [this](const auto& message) { on_message(message); });
  return true;
}

void CountingClient::on_message(const FrameCounter::Message& message) {
  switch (message.opcode) {
    case Opcode::binary: return on_data(message.text, message.size);
    case Opcode::text: return on_text(message.text);
    case Opcode::ping: return send(Opcode::pong, message.text);
    case Opcode::close:
      reason_ = std::to_string(robot::net::parse_close(message.text).code) + " " +
                robot::net::parse_close(message.text).reason;
      return;
    default: return;
  }
}

void CountingClient::on_data(std::string_view head, std::uint64_t payload_bytes) {
  if (head.empty() || head[0] != 1) return;
  ++messages_;
  robot::ByteReader reader(head.substr(1));
  const auto subscription = reader.number<std::uint32_t>();
  const auto capture_ns = reader.number<std::uint64_t>();
  if (subscription >= by_subscription_.size() || !by_subscription_[subscription]) return;
  TopicCount& topic = *by_subscription_[subscription];
  if (topic.messages > 0 && topic.last_ns != 0)
    topic.missed += (capture_ns % kCountedNs + kCountedNs - topic.last_ns % kCountedNs - 1) % kCountedNs;
  if (topic.messages++ == 0) topic.first_ns = capture_ns;
  topic.last_ns = capture_ns;
  topic.bytes += payload_bytes;
  const std::uint64_t now_ns = clock_.now_ns();
  const std::uint64_t age_us = now_ns > capture_ns ? (now_ns - capture_ns) / 1000 : 0;
  topic.ages_us.push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(age_us, kNoAge)));
}

void CountingClient::on_text(std::string_view text) {
  if (text.find("\"op\":\"status\"") != std::string_view::npos) statuses_.emplace_back(text.substr(0, 300));
  if (text.find("\"op\":\"advertise\"") == std::string_view::npos) return;
  const auto channels = robot::net::foxglove::parse_advertise(text);
  if (!channels) return;
  robot::net::foxglove::Subscribe subscribe;
  for (const auto& channel : *channels) {
    if (!options_.watch.wants(channel.info.topic)) continue;
    // the subscription has the channel's number
    subscribe.subscriptions.push_back({channel.id, channel.id});
    if (by_subscription_.size() <= channel.id) by_subscription_.resize(channel.id + 1);
    by_subscription_[channel.id] = &topics_[channel.info.topic];
  }
  if (!subscribe.subscriptions.empty()) send(Opcode::text, robot::net::foxglove::to_text(subscribe));
}

void CountingClient::send(Opcode opcode, std::string_view payload) {
  std::string frame;
  tests::append_masked_frame(frame, opcode, payload, 0x12345678);
  write_all(socket_.get(), frame);
}

}  // namespace bench
