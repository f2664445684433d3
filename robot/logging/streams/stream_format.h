// The byte format of one stream on a local socket: its description, then its messages, each with its size in front.
//
//   stream  = frame*                    the first frame is a channel, all others are messages
//   frame   = kind:u8 length:u32 body   all integers little endian; length counts the body
//   channel = kind 1: five strings (topic, message encoding, schema name, schema encoding, schema), each u32 length
//             and bytes, then delivery:u8 (0 latest, 1 fifo, 2 reliable)
//   message = kind 2: sequence:u64 capture_ns:u64 publish_ns:u64, then the message's bytes
//
// At the door (robot/body/attached) the runtime and a team's process exchange more kinds of frames. All times there are
// of the machine's monotonic clock. The two processes may disagree about the epoch, because the system clock may have
// been stepped between their starts. The first frame of the process is a channel or `wanted`. After a channel it writes
// the messages of this channel; after `wanted` it reads.
//
//   welcome = kind 3: version:u32 epoch_offset_ns:u64   the runtime's first frame; capture time = monotonic + offset
//   wanted  = kind 4: the topic that the process wants to read.
//   memory  = kind 5: an empty body. The socket passes along a file for large messages, which replaces the earlier one.
//   shared  = kind 6: sequence:u64 capture_ns:u64 publish_ns:u64 offset:u64 length:u64   a message in that file
//   taken   = kind 7: sequence:u64   the reader has copied that shared message; its place is free again
//   refused = kind 8: a sentence with the reason; the last frame of the connection
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "robot/core/result.h"
#include "robot/logging/streams/provider.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// The largest body that a reader accepts [bytes]: two raw 1280x960 images.
inline constexpr std::size_t kMaxFrameBytes = 8 << 20;

/// Returns the frame that describes a stream.
std::string channel_frame(const memory::ChannelInfo& info);

/// Returns the part of a message frame before the message's own bytes. Subtracts `time_offset_ns` from its times.
std::string message_frame_head(const memory::Version& version, std::uint64_t time_offset_ns = 0);

// frames of the door only
struct Welcome {
  std::uint32_t version = 0;
  std::uint64_t epoch_offset_ns = 0;
};
struct Wanted {
  std::string topic;
};
struct SharedMemory {};
struct SharedMessage {
  std::uint64_t sequence = 0, capture_ns = 0, publish_ns = 0;
  std::uint64_t offset = 0, length = 0;  // [bytes] in the file
};
struct Taken {
  std::uint64_t sequence = 0;
};
struct Refused {
  std::string sentence;
};

std::string welcome_frame(const Welcome& welcome);
std::string taken_frame(const Taken& taken);
std::string refused_frame(const Refused& refused);

using Frame = std::variant<memory::ChannelInfo, Record, Welcome, Wanted, SharedMemory, SharedMessage, Taken, Refused>;

/// A parser of frames from bytes that arrive in pieces of any size. After an Error it cannot continue.
class FrameParser {
 public:
  /// Appends received bytes.
  void feed(std::string_view bytes) { buffer_.append(bytes); }

  /// Returns the next whole frame, or nothing when it needs more bytes.
  Result<std::optional<Frame>> next();

 private:
  std::string buffer_;
  std::size_t begin_ = 0;  // of the first unread byte
};

}  // namespace robot::logging
