#include "sim/app/mcap_file.h"

#include <algorithm>
#include <utility>

namespace sim::app {

namespace mcap = robot::logging::mcap;
using robot::Error;
using robot::Result;

namespace {

constexpr std::size_t kChunkBytes = 256 * 1024;
constexpr std::uint64_t kChunkNs = 10'000'000'000;

}  // namespace

McapFile::McapFile(std::unique_ptr<robot::ByteSink> sink) : sink_(std::move(sink)) {}

Result<McapFile> McapFile::create(const std::filesystem::path& path,
                                  const std::vector<robot::memory::ChannelInfo>& channels,
                                  const robot::logging::MetadataByName& metadata) {
  auto sink = robot::FileSink::create(path);
  if (!sink) return Error{sink.error()};
  McapFile file(std::move(*sink));
  if (const Result<void> written = file.write_head(channels, metadata); !written) return Error{written.error()};
  return file;
}

/// Magic, Header, Metadata, then each schema once, and the channels; schemas and channels again for the summary.
Result<void> McapFile::write_head(const std::vector<robot::memory::ChannelInfo>& channels,
                                  const robot::logging::MetadataByName& metadata) {
  std::string head(mcap::kMagic);
  mcap::append(head, mcap::Header{"", "foresight-sim " FORESIGHT_VERSION});
  for (const auto& [name, entries] : metadata) {
    const std::uint64_t offset = head.size();
    mcap::append(head, mcap::Metadata{name, entries});
    mcap::append(summary_.metadata_indexes, mcap::MetadataIndex{offset, head.size() - offset, name});
  }

  std::map<std::string, std::uint16_t> schema_ids;
  for (const robot::memory::ChannelInfo& info : channels) {
    const auto next = static_cast<std::uint16_t>(schema_ids.size() + 1);
    const auto [schema, is_new] = schema_ids.emplace(info.schema.name, next);
    if (is_new)
      mcap::append(summary_.schemas, mcap::Schema{next, info.schema.name, info.schema.encoding, info.schema.bytes});
    Chunk& chunk = chunks_.emplace_back();
    chunk.index.channel_id = static_cast<std::uint16_t>(chunks_.size());
    mcap::append(summary_.channels, mcap::Channel{chunk.index.channel_id,
                                                  schema->second,
                                                  info.topic,
                                                  info.message_encoding,
                                                  {{"delivery", std::string(robot::memory::name(info.delivery))}}});
    statistics_.channel_messages.emplace_back(chunk.index.channel_id, 0);
  }
  statistics_.schemas = static_cast<std::uint16_t>(schema_ids.size());
  statistics_.channels = static_cast<std::uint32_t>(channels.size());
  statistics_.metadata = static_cast<std::uint32_t>(metadata.size());
  return append(head + summary_.schemas + summary_.channels);
}

Result<void> McapFile::write(std::size_t channel, std::uint64_t capture_ns, std::string_view bytes) {
  Chunk& chunk = chunks_[channel];
  const bool full = chunk.records.size() + bytes.size() > kChunkBytes;
  if (!chunk.index.entries.empty() && (full || capture_ns - chunk.index.entries.front().first >= kChunkNs))
    if (Result<void> flushed = flush(chunk); !flushed) return flushed;
  chunk.index.entries.emplace_back(capture_ns, chunk.records.size());
  const mcap::Message head{chunk.index.channel_id, ++chunk.messages, capture_ns, capture_ns, {}};
  mcap::append(chunk.records, head, bytes.size());
  chunk.records.append(bytes);
  return {};
}

Result<void> McapFile::flush(Chunk& chunk) {
  auto& entries = chunk.index.entries;
  if (entries.empty()) return {};
  const std::string_view records[] = {chunk.records};
  std::string packed;
  if (Result<void> done = compressor_.compress(records, packed); !done) return done;

  mcap::ChunkHead head;
  head.start_ns = entries.front().first;
  head.end_ns = entries.back().first;
  head.unpacked_bytes = chunk.records.size();
  head.unpacked_crc = mcap::crc32(chunk.records);
  head.compression = robot::logging::name(robot::logging::Compression::zstd);
  head.packed_bytes = packed.size();
  std::string bytes, index;
  mcap::append(bytes, head, packed.size());
  bytes += packed;
  mcap::append(index, chunk.index);

  const std::uint64_t index_offset = size_ + bytes.size();
  mcap::append(summary_.chunk_indexes, mcap::ChunkIndex{head.start_ns,
                                                        head.end_ns,
                                                        size_,
                                                        bytes.size(),
                                                        {{chunk.index.channel_id, index_offset}},
                                                        index.size(),
                                                        head.compression,
                                                        head.packed_bytes,
                                                        head.unpacked_bytes});
  statistics_.start_ns = statistics_.chunks == 0 ? head.start_ns : std::min(statistics_.start_ns, head.start_ns);
  statistics_.end_ns = std::max(statistics_.end_ns, head.end_ns);
  statistics_.messages += entries.size();
  statistics_.channel_messages[chunk.index.channel_id - 1u].second = chunk.messages;
  ++statistics_.chunks;
  chunk.records.clear();
  entries.clear();
  return append(bytes + index);
}

Result<void> McapFile::append(std::string_view bytes) {
  const std::string_view pieces[] = {bytes};
  size_ += bytes.size();
  crc_ = mcap::crc32(bytes, crc_);
  return sink_->append(pieces);
}

Result<void> McapFile::close() {
  for (Chunk& chunk : chunks_)
    if (Result<void> flushed = flush(chunk); !flushed) return flushed;
  std::erase_if(statistics_.channel_messages, [](const auto& channel) { return channel.second == 0; });
  mcap::append(summary_.statistics, statistics_);
  return append(mcap::encode_end(summary_, size_, crc_));
}

}  // namespace sim::app
