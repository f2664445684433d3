// How one stream travels over a local socket: what it is, then its messages, each with its size in front.
//
//   stream  = frame*                    the first frame is a channel, all others are messages
//   frame   = kind:u8 length:u32 body   all integers little endian; length counts the body
//   channel = kind 1: five strings (topic, message encoding, schema name, schema encoding, schema), each u32 length
//             and bytes, then delivery:u8 (0 latest, 1 fifo, 2 reliable)
//   message = kind 2: sequence:u64 capture_ns:u64 publish_ns:u64, then the message's bytes
//
// At the door (robot/body/attached) the runtime and a team's process say a little more. All times there are those of the
// machine's monotonic clock: the two may not agree about the epoch, as the system clock may have been stepped between
// their starts. The first frame of the process is a channel, whose messages it then writes, or what it wants to read.
//
//   welcome = kind 3: version:u32 epoch_offset_ns:u64   the runtime's first frame; capture time = monotonic + offset
//   wanted  = kind 4: the topic whose stream the process wants to read
//   memory  = kind 5: nothing, but with it comes a file, for the bytes of large messages; it replaces the one before
//   shared  = kind 6: sequence:u64 capture_ns:u64 publish_ns:u64 offset:u64 length:u64   a message in that file
//   taken   = kind 7: sequence:u64   that shared message is copied, its place may be used again
//   refused = kind 8: the sentence that says why; the connection ends with it
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

/// The largest body a reader accepts [bytes]: two raw 1280x960 images.
inline constexpr std::size_t kMaxFrameBytes = 8 << 20;

/// The frame that says what a stream is.
std::string channel_frame(const memory::ChannelInfo& info);

/// What stands in front of the message's own bytes; `time_offset_ns` is taken off its times.
std::string message_frame_head(const memory::Version& version, std::uint64_t time_offset_ns = 0);

/// What is said at the door only.
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

/// Takes a stream apart that arrives in pieces of any size. After an Error the stream cannot be read on.
class FrameParser {
 public:
  /// Appends bytes as they came.
  void feed(std::string_view bytes) { buffer_.append(bytes); }

  /// The next whole frame; nothing when more bytes are needed.
  Result<std::optional<Frame>> next();

 private:
  std::string buffer_;
  std::size_t begin_ = 0;  // of the first byte not taken yet
};

}  // namespace robot::logging
