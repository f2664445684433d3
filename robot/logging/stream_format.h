// How one stream travels over a local socket: what it is, then its messages, each with its size in front.
//
//   stream  = frame*                    the first frame is a channel, all others are messages
//   frame   = kind:u8 length:u32 body   all integers little endian; length counts the body
//   channel = kind 1: five strings (topic, message encoding, schema name, schema encoding, schema), each u32 length
//             and bytes, then delivery:u8 (0 latest, 1 fifo, 2 reliable)
//   message = kind 2: sequence:u64 capture_ns:u64 publish_ns:u64, then the message's bytes
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "robot/core/result.h"
#include "robot/logging/provider.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// The largest body a reader accepts [bytes]: two raw 1280x960 images.
inline constexpr std::size_t kMaxFrameBytes = 8 << 20;

/// The frame that says what a stream is.
std::string channel_frame(const memory::ChannelInfo& info);

/// What stands in front of the message's own bytes.
std::string message_frame_head(const memory::Version& version);

using Frame = std::variant<memory::ChannelInfo, Record>;

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
