#include "robot/logging/stream_format.h"

#include <type_traits>
#include <utility>

namespace robot::logging {
namespace {

constexpr std::uint8_t kChannel = 1, kMessage = 2, kWelcome = 3, kWanted = 4, kMemory = 5, kShared = 6, kTaken = 7,
                       kRefused = 8;
constexpr std::size_t kHeadBytes = 5, kMessageHeadBytes = 24;

template <class Integer>
void append(std::string& to, Integer value) {
  for (std::size_t i = 0; i < sizeof value; ++i) to.push_back(static_cast<char>(value >> (8 * i)));
}

void append_string(std::string& to, std::string_view text) {
  append(to, static_cast<std::uint32_t>(text.size()));
  to.append(text);
}

/// Takes values off the front of a frame's body; once one did not fit, `good` stays false.
struct Body {
  std::string_view rest;
  bool good = true;

  template <class Integer>
  Integer integer() {
    std::make_unsigned_t<Integer> value = 0;
    const std::string_view bytes = take(sizeof value);
    for (std::size_t i = 0; i < bytes.size(); ++i)
      value = static_cast<Integer>(value | static_cast<Integer>(static_cast<std::uint8_t>(bytes[i])) << (8 * i));
    return value;
  }

  std::string string() { return std::string(take(integer<std::uint32_t>())); }

  std::string_view take(std::size_t size) {
    good = good && size <= rest.size();
    if (!good) return {};
    const std::string_view taken = rest.substr(0, size);
    rest.remove_prefix(size);
    return taken;
  }
};

std::string frame_head(std::uint8_t kind, std::size_t body_bytes) {
  std::string head;
  append(head, kind);
  append(head, static_cast<std::uint32_t>(body_bytes));
  return head;
}

Result<std::optional<Frame>> parse_channel(Body body) {
  memory::ChannelInfo info;
  info.topic = body.string();
  info.message_encoding = body.string();
  info.schema.name = body.string();
  info.schema.encoding = body.string();
  info.schema.bytes = body.string();
  const auto delivery = body.integer<std::uint8_t>();
  if (!body.good || !body.rest.empty() || delivery > static_cast<std::uint8_t>(memory::Delivery::reliable))
    return Error{"stream: expected a channel of five strings and a delivery of 0 .. 2, got something else"};
  info.delivery = static_cast<memory::Delivery>(delivery);
  return std::optional<Frame>(std::move(info));
}

Result<std::optional<Frame>> parse_message(Body body) {
  Record record;
  record.sequence = body.integer<std::uint64_t>();
  record.capture_ns = body.integer<std::uint64_t>();
  record.publish_ns = body.integer<std::uint64_t>();
  if (!body.good) return Error{"stream: expected a message of at least 24 bytes, got fewer"};
  record.bytes = body.rest;
  return std::optional<Frame>(std::move(record));
}

/// A frame of a fixed form, or of one text.
template <class Content>
Result<std::optional<Frame>> whole(Content content, const Body& body, const char* expected) {
  if (!body.good || !body.rest.empty())
    return Error{std::string("stream: expected ") + expected + ", got another length"};
  return std::optional<Frame>(std::move(content));
}

Result<std::optional<Frame>> parse_welcome(Body body) {
  Welcome welcome;
  welcome.version = body.integer<std::uint32_t>();
  welcome.epoch_offset_ns = body.integer<std::uint64_t>();
  return whole(welcome, body, "a welcome of 12 bytes");
}

Result<std::optional<Frame>> parse_shared(Body body) {
  SharedMessage message;
  for (std::uint64_t* value :
       {&message.sequence, &message.capture_ns, &message.publish_ns, &message.offset, &message.length})
    *value = body.integer<std::uint64_t>();
  if (message.length > kMaxFrameBytes)
    return Error{"stream: expected a shared message of at most " + std::to_string(kMaxFrameBytes) + " bytes, got " +
                 std::to_string(message.length)};
  return whole(message, body, "a shared message of 40 bytes");
}

Result<std::optional<Frame>> parse_body(std::uint8_t kind, Body body) {
  switch (kind) {
    case kChannel: return parse_channel(body);
    case kMessage: return parse_message(body);
    case kWelcome: return parse_welcome(body);
    case kWanted: return std::optional<Frame>(Wanted{std::string(body.rest)});
    case kMemory: return whole(SharedMemory{}, body, "an empty frame with a file");
    case kShared: return parse_shared(body);
    case kTaken: {
      const Taken taken{body.integer<std::uint64_t>()};
      return whole(taken, body, "a sequence number of 8 bytes");
    }
    default: return std::optional<Frame>(Refused{std::string(body.rest)});
  }
}

}  // namespace

std::string channel_frame(const memory::ChannelInfo& info) {
  std::string body;
  for (const std::string* text :
       {&info.topic, &info.message_encoding, &info.schema.name, &info.schema.encoding, &info.schema.bytes})
    append_string(body, *text);
  append(body, static_cast<std::uint8_t>(info.delivery));
  return frame_head(kChannel, body.size()) + body;
}

std::string message_frame_head(const memory::Version& version, std::uint64_t time_offset_ns) {
  std::string head = frame_head(kMessage, kMessageHeadBytes + version.size_bytes());
  append(head, version.sequence());
  append(head, version.capture_ns() - time_offset_ns);
  append(head, version.publish_ns() - time_offset_ns);
  return head;
}

std::string welcome_frame(const Welcome& welcome) {
  std::string frame = frame_head(kWelcome, sizeof welcome.version + sizeof welcome.epoch_offset_ns);
  append(frame, welcome.version);
  append(frame, welcome.epoch_offset_ns);
  return frame;
}

std::string taken_frame(const Taken& taken) {
  std::string frame = frame_head(kTaken, sizeof taken.sequence);
  append(frame, taken.sequence);
  return frame;
}

std::string refused_frame(const Refused& refused) {
  return frame_head(kRefused, refused.sentence.size()) + refused.sentence;
}

Result<std::optional<Frame>> FrameParser::next() {
  const std::string_view waiting = std::string_view(buffer_).substr(begin_);
  Body head{waiting};
  const auto kind = head.integer<std::uint8_t>();
  const auto length = head.integer<std::uint32_t>();
  if (head.good) {
    if (length > kMaxFrameBytes)
      return Error{"stream: expected a frame of at most " + std::to_string(kMaxFrameBytes) + " bytes, got " +
                   std::to_string(length)};
    if (kind < kChannel || kind > kRefused)
      return Error{"stream: expected a frame of kind 1 .. 8, got " + std::to_string(kind)};
  }
  if (!head.good || head.rest.size() < length) {
    // what was taken makes room only now, so that many small frames do not move the buffer each
    buffer_.erase(0, std::exchange(begin_, 0));
    return std::optional<Frame>();
  }
  begin_ += kHeadBytes + length;
  return parse_body(kind, Body{head.rest.substr(0, length)});
}

}  // namespace robot::logging
