// The table of contents of an MCAP file: from its summary or, if its writer died, from its complete records.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/format.h"
#include "robot/memory/channel.h"

namespace robot::logging {

using SchemasById = std::map<std::uint16_t, mcap::Schema>;
using ChannelsById = std::map<std::uint16_t, mcap::Channel>;

/// The place of a chunk and the number of its messages.
struct ChunkInfo {
  mcap::ChunkIndex index;                 // without message indexes if the file lacks them
  mcap::Numbers<std::uint16_t> messages;  // channel, number of its messages
};

struct McapIndex {
  mcap::Header header;
  SchemasById schemas;
  ChannelsById channels;
  std::vector<mcap::Metadata> metadata;  // in the order of the file
  std::vector<ChunkInfo> chunks;         // all complete chunks, by offset
  mcap::Statistics statistics;           // the file's own, or if it has none, of exactly these chunks
  std::uint64_t unchunked_messages = 0;  // 0 in our files; other writers may have some
  std::uint64_t size_bytes = 0;          // of the file
  bool complete = false;                 // its writer closed it
  std::string damage;                    // one sentence, or empty without damage
};

/// Reads the index of a file from its summary, without reading the data. If the summary is missing or wrong, scans the
/// file's records up to the first incomplete one.
/// Returns an Error only if the file cannot be read or is not an MCAP file.
Result<McapIndex> read_index(const ByteSource& source);

/// Rebuilds the message indexes of `chunk` from its messages. Returns an Error if the chunk is damaged.
Result<std::vector<mcap::MessageIndex>> index_messages(const ByteSource& source, const mcap::ChunkIndex& chunk);

/// Returns the description of a file's channel. `schema` is empty if the channel has none or an unknown one.
memory::ChannelInfo channel_info(const mcap::Channel& channel, const SchemasById& schemas);

/// Returns the numbers of messages and chunks and their time range.
mcap::Statistics statistics_of(const std::vector<ChunkInfo>& chunks);

}  // namespace robot::logging
