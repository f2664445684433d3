#include "robot/logging/mcap/topic_streams.h"

#include <algorithm>
#include <map>
#include <utility>

namespace robot::logging {
namespace {

/// Returns for example `json without a schema` or `protobuf of schema "a.B" (protobuf, 120 bytes)`.
std::string description(const memory::ChannelInfo& info) {
  const std::string encoding = info.message_encoding.empty() ? "no encoding" : info.message_encoding;
  if (info.schema == memory::Schema{}) return encoding + " without a schema";
  return encoding + " of schema \"" + info.schema.name + "\" (" + info.schema.encoding + ", " +
         std::to_string(info.schema.bytes.size()) + " bytes)";
}

bool read_alike(const memory::ChannelInfo& left, const memory::ChannelInfo& right) {
  return left.message_encoding == right.message_encoding && left.schema == right.schema;
}

/// Joins the channels of one topic that are not part of `shown`, and says so.
TopicStream without_others(TopicStream shown, const std::vector<TopicStream>& all) {
  for (const TopicStream& other : all) {
    if (other.channels == shown.channels || other.messages == 0) continue;
    shown.left_out += other.messages;
    if (!shown.note.empty()) shown.note += "; ";
    shown.note += shown.info.topic + ": " + std::to_string(other.messages) +
                  (other.messages == 1 ? " message of channel " : " messages of channel ") +
                  std::to_string(*other.channels.begin()) + " left out: expected " + description(shown.info) +
                  " as in channel " + std::to_string(*shown.channels.begin()) + ", got " + description(other.info);
  }
  return shown;
}

}  // namespace

std::vector<TopicStream> topic_streams(const McapIndex& index) {
  const std::map<std::uint16_t, std::uint64_t> messages(index.statistics.channel_messages.begin(),
                                                        index.statistics.channel_messages.end());
  std::vector<std::string> topics;  // in the order of the ids
  std::map<std::string, std::vector<TopicStream>> kinds;
  for (const auto& [id, channel] : index.channels) {
    std::vector<TopicStream>& known = kinds[channel.topic];
    if (known.empty()) topics.push_back(channel.topic);
    memory::ChannelInfo info = channel_info(channel, index.schemas);
    auto same = std::ranges::find_if(known, [&](const TopicStream& one) { return read_alike(one.info, info); });
    if (same == known.end()) same = known.insert(known.end(), TopicStream{.info = std::move(info)});
    same->channels.insert(id);
    if (const auto count = messages.find(id); count != messages.end()) same->messages += count->second;
  }
  std::vector<TopicStream> streams;
  for (const std::string& topic : topics) {
    const std::vector<TopicStream>& all = kinds[topic];
    streams.push_back(without_others(*std::ranges::max_element(all, {}, &TopicStream::messages), all));
  }
  return streams;
}

}  // namespace robot::logging
