#include "robot/logging/mcap/index.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "robot/logging/mcap/chunk.h"
#include "robot/logging/mcap/piece.h"
#include "robot/logging/mcap/scan.h"
#include "robot/logging/mcap/summary.h"

namespace robot::logging {
namespace {

constexpr std::uint64_t kIndexHeadBytes = mcap::kRecordHeadBytes + 2 + 4;  // a MessageIndex without entries
constexpr std::uint64_t kIndexEntryBytes = 8 + 8;

Result<mcap::Header> read_header(const ByteSource& source) {
  const std::uint64_t known = std::min<std::uint64_t>(source.size(), mcap::kMagic.size() + mcap::kRecordHeadBytes);
  const Result<std::string> start = read_bytes(source, 0, known);
  if (!start) return start.failure();
  if (!start->starts_with(mcap::kMagic))
    return Error{source.name() + ": not an MCAP file: expected the magic bytes at its start"};
  const std::uint64_t offset = mcap::kMagic.size();
  const auto head = mcap::decode_record_head(std::string_view(*start).substr(offset), offset, source.size() - offset);
  if (!head) return head.failure(source.name());
  if (head->op != mcap::Op::header || head->length > mcap::kMaxRecordBytes)
    return Error{source.name() + ": not an MCAP file: expected a Header at byte 8, got " + mcap::name(head->op)};
  const Result<std::string> content = read_bytes(source, known, head->length);
  if (!content) return content.failure();
  Result<mcap::Header> header = mcap::decode<mcap::Header>(*content, offset);
  if (!header) return header.failure(source.name());
  return header;
}

/// Returns the number of messages in the MessageIndex at `offset`, without reading its entries.
Result<std::uint64_t> count_entries(const ByteSource& source, std::uint64_t offset) {
  const Result<std::string> bytes = read_bytes(source, offset, kIndexHeadBytes);
  if (!bytes) return bytes.failure();
  const auto head = mcap::decode_record_head(*bytes, offset, source.size() - offset);
  if (!head || head->op != mcap::Op::message_index || head->length < kIndexHeadBytes - mcap::kRecordHeadBytes)
    return Error{"expected a MessageIndex at byte " + std::to_string(offset)};
  return (mcap::kRecordHeadBytes + head->length - kIndexHeadBytes) / kIndexEntryBytes;
}

/// Returns the index without header and size.
McapIndex read_body(const ByteSource& source) {
  const auto summary = mcap::read_summary(source);
  McapIndex index = scan(source, summary && *summary ? &**summary : nullptr);
  // the scan's damage is more specific than the missing end
  if (index.damage.empty() && !summary) index.damage = summary.error();
  index.complete = summary && index.complete;
  return index;
}

}  // namespace

Result<McapIndex> read_index(const ByteSource& source) {
  Result<mcap::Header> header = read_header(source);
  if (!header) return header.failure();
  McapIndex index = read_body(source);
  index.header = std::move(*header);
  index.size_bytes = source.size();
  return index;
}

Result<mcap::Numbers<std::uint16_t>> count_messages(const ByteSource& source, const ChunkInfo& chunk) {
  if (!chunk.messages.empty()) return chunk.messages;
  mcap::Numbers<std::uint16_t> counts;
  if (chunk.index.message_indexes.empty()) {
    const auto contents = read_chunk(source, chunk.index);
    if (!contents) return contents.failure();
    for (const auto& [channel, index] : contents->indexes) counts.emplace_back(channel, index.entries.size());
    return counts;
  }
  for (const auto& [channel, offset] : chunk.index.message_indexes) {
    const Result<std::uint64_t> count = count_entries(source, offset);
    if (!count) return count.failure();
    counts.emplace_back(channel, *count);
  }
  return counts;
}

Result<std::vector<mcap::MessageIndex>> index_messages(const ByteSource& source, const mcap::ChunkIndex& chunk) {
  const auto contents = read_chunk(source, chunk);
  if (!contents) return contents.failure();
  if (!contents->damage.empty()) return Error{contents->damage};
  std::vector<mcap::MessageIndex> indexes;
  for (const auto& [channel, index] : contents->indexes) indexes.push_back(index);
  return indexes;
}

memory::ChannelInfo channel_info(const mcap::Channel& channel, const SchemasById& schemas) {
  memory::ChannelInfo info;
  info.topic = channel.topic;
  info.message_encoding = channel.message_encoding;
  const auto schema = schemas.find(channel.schema_id);
  if (channel.schema_id != 0 && schema != schemas.end())
    info.schema = {schema->second.name, schema->second.encoding, schema->second.data};
  const auto delivery = channel.metadata.find("delivery");
  for (const memory::Delivery known : {memory::Delivery::fifo, memory::Delivery::reliable})
    if (delivery != channel.metadata.end() && delivery->second == memory::name(known)) info.delivery = known;
  return info;
}

mcap::Statistics statistics_of(const std::vector<ChunkInfo>& chunks) {
  mcap::Statistics statistics;
  std::map<std::uint16_t, std::uint64_t> by_channel;
  for (const ChunkInfo& chunk : chunks) {
    const bool first = statistics.messages == 0;
    std::uint64_t messages = 0;
    for (const auto& [channel, count] : chunk.messages) messages += count, by_channel[channel] += count;
    if (messages == 0) continue;
    statistics.messages += messages;
    statistics.start_ns = first ? chunk.index.start_ns : std::min(statistics.start_ns, chunk.index.start_ns);
    statistics.end_ns = std::max(statistics.end_ns, chunk.index.end_ns);
  }
  statistics.chunks = static_cast<std::uint32_t>(chunks.size());
  statistics.channel_messages.assign(by_channel.begin(), by_channel.end());
  return statistics;
}

}  // namespace robot::logging
