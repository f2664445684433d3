// What an MCAP file holds and where: from its summary or, if its writer died, from what it had finished.
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

/// Where a chunk is and what is in it.
struct ChunkInfo {
  mcap::ChunkIndex index;                 // without message indexes if the file lacks them
  mcap::Numbers<std::uint16_t> messages;  // channel, number of its messages
};

struct McapIndex {
  mcap::Header header;
  SchemasById schemas;
  ChannelsById channels;
  std::vector<mcap::Metadata> metadata;  // as they stand in the file
  std::vector<ChunkInfo> chunks;         // all that are complete, by offset
  mcap::Statistics statistics;           // of exactly these chunks, if the writer left none
  std::uint64_t unchunked_messages = 0;  // ours have none; other writers may
  std::uint64_t size_bytes = 0;          // of the file
  bool complete = false;                 // it ends as its writer wanted it to
  std::string damage;                    // what is wrong with the file; empty if nothing
};

/// The index of a file. From its summary, without touching the data; if that is missing or wrong, by going through
/// the file from record to record up to the first that is not whole.
/// An Error only if the file cannot be read or is no MCAP file at all.
Result<McapIndex> read_index(const ByteSource& source);

/// The message indexes of `chunk`, made anew from its messages. An Error if the chunk is damaged.
Result<std::vector<mcap::MessageIndex>> index_messages(const ByteSource& source, const mcap::ChunkIndex& chunk);

/// What a channel of a file says of itself. Without a schema, or with an unknown one, `schema` is empty.
memory::ChannelInfo channel_info(const mcap::Channel& channel, const SchemasById& schemas);

/// Numbers of messages and chunks and their time range.
mcap::Statistics statistics_of(const std::vector<ChunkInfo>& chunks);

}  // namespace robot::logging
