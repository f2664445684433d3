// A viewer that counts messages and decodes none: ten of them may run beside the server.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/result.h"
#include "robot/net/websocket/frames.h"

namespace bench {

/// Cuts a server's bytes into messages without keeping their payloads.
class FrameCounter {
 public:
  /// Head of a binary message: opcode, subscription, log time.
  static constexpr std::size_t kHeadBytes = 13;

  struct Message {
    robot::net::Opcode opcode = robot::net::Opcode::binary;
    std::uint64_t size = 0;  // [bytes] of the payload
    std::string_view text;   // the payload; of binary messages only the first kHeadBytes
    bool is(robot::net::Opcode other) const { return opcode == other; }
  };

  /// Calls `sink(message)` for each message that ends within `bytes`.
  template <class Sink>
  void feed(std::string_view bytes, Sink&& sink) {
    while (!bytes.empty()) {
      if (left_ == 0 && !take_header(bytes)) return;
      take_payload(bytes);
      if (left_ == 0) sink(Message{opcode_, size_, kept_});
    }
  }

 private:
  bool take_header(std::string_view& bytes);
  void take_payload(std::string_view& bytes);

  std::string header_;  // of the next frame
  robot::net::Opcode opcode_ = robot::net::Opcode::binary;
  std::uint64_t size_ = 0, left_ = 0;
  std::string kept_;
};

/// Messages of one topic that a client received.
struct TopicCount {
  std::uint64_t messages = 0, bytes = 0;
  std::uint64_t missed =
      0;  // messages missing between the received ones, see counting_time(); 0 for topics without numbers
  std::uint64_t first_ns = 0, last_ns = 0;  // capture times
  std::vector<std::uint32_t> ages_us;       // on arrival
};

/// Channels of a server that a client watches.
struct Watch {
  bool objects = true;              // all memory objects except images
  bool images = false;              // camera_top, camera_bottom unchanged
  bool jpeg = false;                // camera_top/jpeg, camera_bottom/jpeg
  std::vector<std::string> topics;  // further ones by name

  bool wants(std::string_view topic) const;
};

/// Reads "objects,images,jpeg" or a part of it, and topics such as "/truth/world"; "nothing" watches no channel.
robot::Result<Watch> parse_watch(std::string_view text);

class CountingClient {
 public:
  struct Options {
    std::string url;
    Watch watch;
    int receive_buffer_bytes = 0;                   // of the kernel; 0: the kernel's default
    std::map<std::string, std::string> parameters;  // to set first: name, JSON value
  };

  CountingClient(Options options, const robot::Clock& clock) : options_(std::move(options)), clock_(clock) {}

  /// Connects, and subscribes to the watched channels as soon as they are advertised.
  robot::Result<void> connect();

  /// Reads once, at most `most_bytes` of the received data. Returns false if the connection has ended; then reason()
  /// holds the reason.
  bool read(std::size_t most_bytes = SIZE_MAX);

  void close() { socket_.reset(); }
  int socket() const { return socket_.get(); }

  std::uint64_t messages() const { return messages_; }
  std::uint64_t bytes() const { return bytes_; }
  const std::string& reason() const { return reason_; }
  const std::map<std::string, TopicCount>& topics() const { return topics_; }
  const std::vector<std::string>& statuses() const { return statuses_; }

 private:
  void on_message(const FrameCounter::Message& message);
  void on_data(std::string_view head, std::uint64_t payload_bytes);
  void on_text(std::string_view text);
  void send(robot::net::Opcode opcode, std::string_view payload);

  const Options options_;
  const robot::Clock& clock_;
  robot::FileDescriptor socket_;
  FrameCounter frames_;
  std::uint64_t messages_ = 0, bytes_ = 0;
  std::string reason_;
  std::map<std::string, TopicCount> topics_;
  std::vector<TopicCount*> by_subscription_;
  std::vector<std::string> statuses_;  // warnings and errors of the server
};

}  // namespace bench
