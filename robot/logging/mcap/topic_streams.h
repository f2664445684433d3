// The topics of an MCAP file as streams: the channels that belong together.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "robot/logging/mcap/index.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// The messages of one topic that are read as one stream.
struct TopicStream {
  memory::ChannelInfo info;
  std::set<std::uint16_t> channels;  // ids
  std::uint64_t messages = 0;
  std::uint64_t left_out = 0;  // messages of the topic in other channels
  std::string note;            // one sentence about them, or empty
};

/// Returns a stream for each topic, in the order of the channel ids. Other writers may have several channels of one
/// topic. Channels with the same encoding and schema are one stream. Of different ones the stream has those with the
/// most messages, or of equally many the one with the smallest id. `note` names the others and the reason.
std::vector<TopicStream> topic_streams(const McapIndex& index);

}  // namespace robot::logging
