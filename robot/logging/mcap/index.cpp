#include "robot/logging/mcap/index.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "robot/logging/mcap/chunk.h"
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

/// Returns the number of messages of each channel in a chunk.
Result<mcap::Numbers<std::uint16_t>> count_messages(const ByteSource& source, const mcap::ChunkIndex& chunk) {
  mcap::Numbers<std::uint16_t> counts;
  if (chunk.message_indexes.empty()) {
    const auto indexes = index_messages(source, chunk);
    if (!indexes) return indexes.failure();
    for (const mcap::MessageIndex& index : *indexes) counts.emplace_back(index.channel_id, index.entries.size());
    return counts;
  }
  // one channel, as in all our files: the length gives the number
  const std::uint64_t bytes = chunk.message_index_bytes;
  if (chunk.message_indexes.size() == 1 && bytes >= kIndexHeadBytes) {
    counts.emplace_back(chunk.message_indexes[0].first, (bytes - kIndexHeadBytes) / kIndexEntryBytes);
    return counts;
  }
  for (const auto& [channel, offset] : chunk.message_indexes) {
    const Result<std::uint64_t> count = count_entries(source, offset);
    if (!count) return count.failure();
    counts.emplace_back(channel, *count);
  }
  return counts;
}

Result<std::vector<mcap::Metadata>> read_metadata(const ByteSource& source, std::vector<mcap::MetadataIndex> indexes) {
  std::sort(indexes.begin(), indexes.end(),
            [](const auto& left, const auto& right) { return left.offset < right.offset; });
  std::vector<mcap::Metadata> all;
  std::uint64_t free = 0;
  for (const mcap::MetadataIndex& index : indexes) {
    const std::string where = source.name() + ": expected Metadata at byte " + std::to_string(index.offset);
    if (index.offset < free || index.record_bytes > mcap::kMaxRecordBytes) return Error{where};
    const Result<std::string> bytes = read_bytes(source, index.offset, index.record_bytes);
    if (!bytes) return bytes.failure();
    std::size_t at = 0;
    const auto record = mcap::take_record(*bytes, at, index.offset);
    if (!record || record->op != mcap::Op::metadata) return Error{where};
    Result<mcap::Metadata> metadata = mcap::decode<mcap::Metadata>(record->content, index.offset);
    if (!metadata) return metadata.failure(source.name());
    all.push_back(std::move(*metadata));
    free = index.offset + index.record_bytes;
  }
  return all;
}

/// Returns whether the summary holds everything that a scan would find.
bool tells_all(const mcap::Summary& summary) {
  return summary.statistics && summary.statistics->chunks == summary.chunk_indexes.size() &&
         summary.statistics->channels == summary.channels.size() &&
         summary.statistics->schemas == summary.schemas.size() &&
         summary.statistics->metadata == summary.metadata_indexes.size();
}

Result<McapIndex> from_summary(const ByteSource& source, mcap::Summary summary) {
  McapIndex index;
  for (mcap::Schema& schema : summary.schemas) index.schemas.emplace(schema.id, std::move(schema));
  for (mcap::Channel& channel : summary.channels) index.channels.emplace(channel.id, std::move(channel));
  index.statistics = *summary.statistics;

  std::uint64_t in_chunks = 0;
  index.chunks.reserve(summary.chunk_indexes.size());
  for (mcap::ChunkIndex& chunk : summary.chunk_indexes) {
    auto counts = count_messages(source, chunk);
    if (!counts) return counts.failure(source.name());
    for (const auto& [channel, count] : *counts) in_chunks += count;
    index.chunks.push_back({std::move(chunk), std::move(*counts)});
  }
  if (in_chunks > index.statistics.messages)
    return Error{source.name() + ": Statistics: expected at least " + std::to_string(in_chunks) + " messages, got " +
                 std::to_string(index.statistics.messages)};
  index.unchunked_messages = index.statistics.messages - in_chunks;
  index.complete = true;

  auto metadata = read_metadata(source, std::move(summary.metadata_indexes));
  if (metadata) index.metadata = std::move(*metadata);
  if (!metadata) index.damage = metadata.error();
  return index;
}

/// Returns the index without header and size.
McapIndex read_body(const ByteSource& source) {
  auto summary = mcap::read_summary(source);
  std::string damage = summary ? "" : summary.error();
  if (summary && *summary && tells_all(**summary)) {
    Result<McapIndex> index = from_summary(source, std::move(**summary));
    if (index) return std::move(*index);
    damage = index.error();
  }

  McapIndex index = scan(source);
  // the scan's damage is more specific than the missing end
  if (index.damage.empty()) index.damage = damage;
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

Result<std::vector<mcap::MessageIndex>> index_messages(const ByteSource& source, const mcap::ChunkIndex& chunk) {
  const auto contents = read_chunk(source, chunk);
  if (!contents) return contents.failure();
  std::vector<mcap::MessageIndex> indexes;
  for (const auto& [channel, index] : contents->indexes) indexes.push_back(index);
  return indexes;
}

memory::ChannelInfo channel_info(const mcap::Channel& channel, const SchemasById& schemas) {
  memory::ChannelInfo info;
  info.topic = channel.topic;
  info.message_encoding = channel.message_encoding;
  if (const auto schema = schemas.find(channel.schema_id); schema != schemas.end())
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
