// Any bytes of a process at the door: no crash, bounded memory, the same meaning in pieces of any size. Any schema that
// it announces is accepted or refused.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>

#include "proto/foresight/ball.pb.h"
#include "robot/logging/streams/stream_format.h"
#include "robot/memory/schema_check.h"

namespace {

namespace logging = robot::logging;

/// Returns the meaning of a frame in a form that can be compared.
struct Meaning {
  std::string operator()(const robot::memory::ChannelInfo& info) const { return "c" + logging::channel_frame(info); }
  std::string operator()(const logging::Record& record) const {
    return "r" + std::to_string(record.sequence) + " " + std::string(record.bytes);
  }
  std::string operator()(const logging::Welcome& welcome) const { return logging::welcome_frame(welcome); }
  std::string operator()(const logging::Wanted& wanted) const { return "w" + wanted.topic; }
  std::string operator()(const logging::SharedMemory&) const { return "m"; }
  std::string operator()(const logging::SharedMessage& message) const {
    return "s" + std::to_string(message.offset) + " " + std::to_string(message.length);
  }
  std::string operator()(const logging::Taken& taken) const { return logging::taken_frame(taken); }
  std::string operator()(const logging::Refused& refused) const { return logging::refused_frame(refused); }
};

std::string meaning(std::string_view bytes, std::size_t portion) {
  logging::FrameParser parser;
  std::string all;
  while (!bytes.empty()) {
    const std::string_view now = bytes.substr(0, portion);
    bytes.remove_prefix(now.size());
    parser.feed(now);
    while (true) {
      const auto frame = parser.next();
      if (!frame) return all + "!" + frame.error();
      if (!*frame) break;
      all += std::visit(Meaning(), **frame);
    }
  }
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (meaning(bytes, data[0] % 16 + 1) != meaning(bytes, SIZE_MAX)) std::abort();
  logging::FrameParser parser;
  parser.feed(bytes);
  if (const auto frame = parser.next(); frame && *frame)
    if (const auto* info = std::get_if<robot::memory::ChannelInfo>(&**frame))
      if (robot::memory::check_readable(info->schema))
        static_cast<void>(robot::memory::check_same_meaning(*foresight::Ball::descriptor(), info->schema));
  return 0;
}
