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
  mcap::Numbers<std::uint16_t> messages;  // channel, number of its messages; empty: not counted, see count_messages()
  bool is_run = false;                    // not a chunk: records of the file itself, with messages outside chunks
};

struct McapIndex {
  mcap::Header header;
  SchemasById schemas;
  ChannelsById channels;
  std::vector<mcap::Metadata> metadata;  // in the order of the file
  std::vector<ChunkInfo> chunks;         // all complete chunks, by offset
  std::vector<ChunkInfo> runs;           // the messages outside chunks: runs of records of the file itself, by offset
  mcap::Statistics statistics;           // the file's own, or if they are missing or wrong, of these chunks and runs
  std::uint64_t unchunked_messages = 0;  // in the runs; 0 in our files
  std::uint64_t size_bytes = 0;          // of the file
  bool complete = false;                 // its writer closed it
  std::string damage;                    // a sentence for each damage, at most eight; empty without damage
};

/// Reads the index of a file from its summary and from the records outside the chunks. If the summary is missing or
/// wrong, scans the file's records up to the first incomplete one. A damaged record whose length is right costs only
/// itself.
/// Returns an Error only if the file cannot be read or is not an MCAP file.
Result<McapIndex> read_index(const ByteSource& source);

/// Returns the number of messages of each channel in `chunk`, from its message indexes, or from its messages if it has
/// none.
Result<mcap::Numbers<std::uint16_t>> count_messages(const ByteSource& source, const ChunkInfo& chunk);

/// Rebuilds the message indexes of `chunk` from its messages. Returns an Error if the chunk is damaged.
Result<std::vector<mcap::MessageIndex>> index_messages(const ByteSource& source, const mcap::ChunkIndex& chunk);

/// Returns the description of a file's channel. `schema` is empty if the channel has none or an unknown one.
memory::ChannelInfo channel_info(const mcap::Channel& channel, const SchemasById& schemas);

/// Returns the numbers of messages and chunks and their time range. Each chunk must be counted.
mcap::Statistics statistics_of(const std::vector<ChunkInfo>& chunks);

}  // namespace robot::logging
