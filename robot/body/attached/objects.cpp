#include "robot/body/attached/objects.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "robot/core/text.h"
#include "robot/memory/schema.h"
#include "robot/memory/schema_check.h"

namespace robot::body {
namespace {

constexpr std::size_t kMaxTopicBytes = 200;

const google::protobuf::Descriptor* our_message(const std::string& name) {
  return google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(name);
}

/// Returns whether `topic` is valid. It is also a file name: no part may be empty or begin with a dot.
bool is_topic(std::string_view topic) {
  if (!topic.starts_with('/') || topic.ends_with('/') || topic.size() > kMaxTopicBytes) return false;
  if (topic.find("//") != topic.npos || topic.find("/.") != topic.npos) return false;
  return std::ranges::all_of(topic, [](unsigned char byte) {
    return byte < 0x80 &&
           (std::isalnum(byte) || std::string_view("/_-.").find(static_cast<char>(byte)) != std::string_view::npos);
  });
}

std::string in_quotes(std::string_view text) { return "'" + printable(text, 80) + "'"; }

}  // namespace

Objects::Objects(std::string robot, std::set<std::string> own, std::string written_below, memory::Channels& channels,
                 const Clock& clock)
    : robot_(std::move(robot)),
      own_(std::move(own)),
      written_below_(std::move(written_below)),
      channels_(channels),
      clock_(clock) {}

Result<std::string> Objects::topic_of(std::string_view name) const {
  std::string topic = name.starts_with('/') ? std::string(name) : "/" + robot_ + "/" + std::string(name);
  if (is_topic(topic)) return topic;
  return Error{"expected a topic of words of letters, digits, '_', '-' and '.' with '/' between them, at most " +
               std::to_string(kMaxTopicBytes) + " bytes, got " + in_quotes(name)};
}

/// Adds the schema of a message of ours if it is missing. Otherwise checks that the given schema means the same.
Result<void> Objects::complete(memory::ChannelInfo& announced) const {
  const google::protobuf::Descriptor* ours =
      announced.message_encoding == "protobuf" ? our_message(announced.schema.name) : nullptr;
  if (ours && announced.schema.bytes.empty()) {
    announced.schema = memory::schema_of(*ours);
    return {};
  }
  if (Result<void> readable = memory::check_readable(announced.schema); !readable) return readable;
  if (!ours) return {};
  if (announced.schema.encoding != "protobuf")
    return Error{"expected a schema of " + announced.schema.name + " in encoding protobuf, got " +
                 in_quotes(announced.schema.encoding)};
  return memory::check_same_meaning(*ours, announced.schema);
}

Result<std::shared_ptr<memory::Channel>> Objects::make(memory::ChannelInfo info) {
  if (made_ == kMaxMade)
    return Error{info.topic + ": expected at most " + std::to_string(kMaxMade) +
                 " objects unknown to the runtime, got one more"};
  ++made_;
  const auto made = std::make_shared<memory::RawChannel>(std::move(info), clock_);
  if (Result<void> added = channels_.add(made); !added) return added.failure();
  return std::shared_ptr<memory::Channel>(made);
}

Result<std::shared_ptr<memory::Channel>> Objects::channel_of(memory::ChannelInfo announced) {
  Result<std::string> topic = topic_of(announced.topic);
  if (!topic) return topic.failure();
  announced.topic = std::move(*topic);
  if (const std::string own = "/" + robot_ + "/";
      announced.topic.starts_with(own) && own_.contains(announced.topic.substr(own.size())))
    return Error{announced.topic + ": expected an object of the team's, got one that only the runtime writes"};

  if (!announced.topic.starts_with(written_below_))
    return Error{announced.topic + ": expected a topic below " + written_below_ + ", got another one"};

  const std::shared_ptr<memory::Channel> known = channels_.find(announced.topic);
  if (known && announced.schema.name.empty() && announced.message_encoding == known->info().message_encoding)
    return known;
  if (Result<void> completed = complete(announced); !completed) return completed.failure(announced.topic);
  if (!known) return make(std::move(announced));

  const memory::ChannelInfo& info = known->info();
  if (info.message_encoding != announced.message_encoding || info.schema.name != announced.schema.name)
    return Error{info.topic + ": expected " + info.message_encoding + " messages of type " +
                 in_quotes(info.schema.name) + ", got " + in_quotes(announced.message_encoding) + " of type " +
                 in_quotes(announced.schema.name)};
  if (!our_message(info.schema.name) && info.schema != announced.schema)
    return Error{info.topic + ": expected the schema of " + in_quotes(info.schema.name) +
                 " that was announced first, got another one; a changed type needs a new start of the runtime"};
  return known;
}

}  // namespace robot::body
