#include "robot/logging/streams/stream_format.h"

#include <utility>

#include "robot/core/little_endian.h"

namespace robot::logging {
namespace {

constexpr std::uint8_t kChannel = 1, kMessage = 2, kWelcome = 3, kWanted = 4, kMemory = 5, kShared = 6, kTaken = 7,
                       kRefused = 8;
constexpr std::size_t kHeadBytes = 5, kMessageHeadBytes = 24;

std::string frame_head(std::uint8_t kind, std::size_t body_bytes) {
  std::string head;
  put(head, kind);
  put(head, static_cast<std::uint32_t>(body_bytes));
  return head;
}

Result<std::optional<Frame>> parse_channel(ByteReader body) {
  memory::ChannelInfo info;
  info.topic = body.text();
  info.message_encoding = body.text();
  info.schema.name = body.text();
  info.schema.encoding = body.text();
  info.schema.bytes = body.text();
  const auto delivery = body.number<std::uint8_t>();
  if (!body.finished() || delivery > static_cast<std::uint8_t>(memory::Delivery::reliable))
    return Error{"stream: expected a channel of five strings and a delivery of 0 .. 2, got something else"};
  info.delivery = static_cast<memory::Delivery>(delivery);
  return std::optional<Frame>(std::move(info));
}

Result<std::optional<Frame>> parse_message(ByteReader body) {
  Record record;
  record.sequence = body.number<std::uint64_t>();
  record.capture_ns = body.number<std::uint64_t>();
  record.publish_ns = body.number<std::uint64_t>();
  if (!body.ok()) return Error{"stream: expected a message of at least 24 bytes, got fewer"};
  record.bytes = body.rest();
  return std::optional<Frame>(std::move(record));
}

/// Returns the frame `content` if all of `body` was read, otherwise an Error with the expected form.
template <class Content>
Result<std::optional<Frame>> whole(Content content, const ByteReader& body, const char* expected) {
  if (!body.finished()) return Error{std::string("stream: expected ") + expected + ", got another length"};
  return std::optional<Frame>(std::move(content));
}

Result<std::optional<Frame>> parse_welcome(ByteReader body) {
  Welcome welcome;
  welcome.version = body.number<std::uint32_t>();
  welcome.epoch_offset_ns = body.number<std::uint64_t>();
  return whole(welcome, body, "a welcome of 12 bytes");
}

Result<std::optional<Frame>> parse_shared(ByteReader body) {
  SharedMessage message;
  for (std::uint64_t* value :
       {&message.sequence, &message.capture_ns, &message.publish_ns, &message.offset, &message.length})
    *value = body.number<std::uint64_t>();
  if (message.length > kMaxFrameBytes)
    return Error{"stream: expected a shared message of at most " + std::to_string(kMaxFrameBytes) + " bytes, got " +
                 std::to_string(message.length)};
  return whole(message, body, "a shared message of 40 bytes");
}

Result<std::optional<Frame>> parse_body(std::uint8_t kind, ByteReader body) {
  switch (kind) {
    case kChannel: return parse_channel(body);
    case kMessage: return parse_message(body);
    case kWelcome: return parse_welcome(body);
    case kWanted: return std::optional<Frame>(Wanted{std::string(body.rest())});
    case kMemory: return whole(SharedMemory{}, body, "an empty frame with a file");
    case kShared: return parse_shared(body);
    case kTaken: {
      const Taken taken{body.number<std::uint64_t>()};
      return whole(taken, body, "a sequence number of 8 bytes");
    }
    default: return std::optional<Frame>(Refused{std::string(body.rest())});
  }
}

}  // namespace

std::string channel_frame(const memory::ChannelInfo& info) {
  std::string body;
  for (const std::string* text :
       {&info.topic, &info.message_encoding, &info.schema.name, &info.schema.encoding, &info.schema.bytes})
    put_text(body, *text);
  put(body, static_cast<std::uint8_t>(info.delivery));
  return frame_head(kChannel, body.size()) + body;
}

std::string message_frame_head(const memory::Version& version, std::uint64_t time_offset_ns) {
  std::string head = frame_head(kMessage, kMessageHeadBytes + version.size_bytes());
  put(head, version.sequence());
  put(head, version.capture_ns() - time_offset_ns);
  put(head, version.publish_ns() - time_offset_ns);
  return head;
}

std::string welcome_frame(const Welcome& welcome) {
  std::string frame = frame_head(kWelcome, sizeof welcome.version + sizeof welcome.epoch_offset_ns);
  put(frame, welcome.version);
  put(frame, welcome.epoch_offset_ns);
  return frame;
}

std::string taken_frame(const Taken& taken) {
  std::string frame = frame_head(kTaken, sizeof taken.sequence);
  put(frame, taken.sequence);
  return frame;
}

std::string refused_frame(const Refused& refused) {
  return frame_head(kRefused, refused.sentence.size()) + refused.sentence;
}

Result<std::optional<Frame>> FrameParser::next() {
  const std::string_view waiting = std::string_view(buffer_).substr(begin_);
  ByteReader head(waiting);
  const auto kind = head.number<std::uint8_t>();
  const auto length = head.number<std::uint32_t>();
  if (head.ok()) {
    if (length > kMaxFrameBytes)
      return Error{"stream: expected a frame of at most " + std::to_string(kMaxFrameBytes) + " bytes, got " +
                   std::to_string(length)};
    if (kind < kChannel || kind > kRefused)
      return Error{"stream: expected a frame of kind 1 .. 8, got " + std::to_string(kind)};
  }
  if (!head.ok() || head.rest().size() < length) {
    // erase read bytes only here, so that the buffer is not moved for each of many small frames
    buffer_.erase(0, std::exchange(begin_, 0));
    return std::optional<Frame>();
  }
  begin_ += kHeadBytes + length;
  return parse_body(kind, ByteReader(head.rest().substr(0, length)));
}

}  // namespace robot::logging
