#include "robot/logging/mcap/writer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "robot/core/attempt.h"

namespace robot::logging {
namespace {

// leaves room for earlier messages of the chunk and for growth by compression
constexpr std::uint64_t kMaxMessageBytes = mcap::kMaxRecordBytes / 2;

constexpr std::size_t kMaxChunkIndexBytes = 256;  // of a chunk with one channel

std::uint64_t total(std::span<const std::string_view> pieces) {
  std::uint64_t size = 0;
  for (const std::string_view piece : pieces) size += piece.size();
  return size;
}

std::uint32_t crc_behind(std::uint32_t before, std::span<const std::string_view> pieces) {
  for (const std::string_view piece : pieces) before = mcap::crc32(piece, before);
  return before;
}

/// Adds the number of lost messages to an Error.
Result<void> with_loss(const Result<void>& written, std::uint64_t lost) {
  if (written) return {};
  return Error{written.error() + "; messages lost: " + std::to_string(lost)};
}

}  // namespace

McapWriter::McapWriter(std::unique_ptr<ByteSink> sink, const McapOptions& options)
    : sink_(std::move(sink)),
      chunk_bytes_(std::min<std::size_t>(options.chunk_bytes, mcap::kMaxRecordBytes / 4)),
      chunk_time_ns_(options.chunk_time_ns),
      compressor_(options.compression) {}

Result<McapWriter> McapWriter::open(std::unique_ptr<ByteSink> sink, std::span<const memory::ChannelInfo> channels,
                                    const McapOptions& options) {
  McapWriter writer(std::move(sink), options);
  if (const Result<void> written = writer.write_head(channels, options); !written) return written.failure();
  return writer;
}

/// Writes Magic, Header, Metadata, Schemas and Channels, and enters them into the summary.
Result<void> McapWriter::write_head(std::span<const memory::ChannelInfo> channels, const McapOptions& options) {
  std::string head(mcap::kMagic);
  mcap::append(head, mcap::Header{"", options.library});
  for (const auto& [name, entries] : options.metadata) {
    const std::uint64_t offset = head.size();
    mcap::append(head, mcap::Metadata{name, entries});
    mcap::append(summary_.metadata_indexes, mcap::MetadataIndex{offset, head.size() - offset, name});
  }
  statistics_.metadata = static_cast<std::uint32_t>(options.metadata.size());
  describe(channels, options.first_channel_id);
  head += summary_.schemas + summary_.channels;
  const std::string_view pieces[] = {head};
  return append(pieces, crc_behind(0, pieces));
}

/// Enters the channels and their schemas into the summary, and makes an empty chunk for each channel.
void McapWriter::describe(std::span<const memory::ChannelInfo> channels, std::uint16_t first_id) {
  assert(first_id + channels.size() <= 0x1'0000 && "ids have 16 bits");
  std::vector<memory::Schema> schemas;  // the first one has the id 1: 0 means no schema
  for (const memory::ChannelInfo& info : channels) {
    auto schema = std::ranges::find(schemas, info.schema);
    const bool is_new = schema == schemas.end();
    if (is_new) schema = schemas.insert(schema, info.schema);
    const auto schema_id = static_cast<std::uint16_t>(schema - schemas.begin() + 1);
    if (is_new) mcap::append(summary_.schemas, mcap::Schema{schema_id, schema->name, schema->encoding, schema->bytes});

    const auto id = static_cast<std::uint16_t>(first_id + chunks_.size());
    mcap::append(summary_.channels, mcap::Channel{id,
                                                  schema_id,
                                                  info.topic,
                                                  info.message_encoding,
                                                  {{"delivery", std::string(memory::name(info.delivery))}}});
    chunks_.emplace_back().index.channel_id = id;
    statistics_.channel_messages.emplace_back(id, 0);
  }
  statistics_.schemas = static_cast<std::uint16_t>(schemas.size());
  statistics_.channels = static_cast<std::uint32_t>(channels.size());
}

Result<void> McapWriter::write(std::size_t channel, const OutMessage& message, std::uint64_t now_ns) {
  assert(!closed_ && "nothing is written behind the end");
  assert(channel < chunks_.size() && "the file has this channel");
  if (message.bytes.size() > kMaxMessageBytes) {
    ++lost_;
    return Error{"cannot write a message: expected at most " + std::to_string(kMaxMessageBytes) + " bytes, got " +
                 std::to_string(message.bytes.size())};
  }
  mcap::CollectedChunk& chunk = chunks_[channel];
  const bool fills = chunk.records.size() + message.bytes.size() >= chunk_bytes_;
  const Result<void> room = attempt("collecting a message", [&] { chunk.make_room(fills ? 0 : message.bytes.size()); });
  if (!room) {
    ++lost_;
    return with_loss(room, 1);
  }
  if (chunk.empty()) chunk.due_ns = now_ns + std::min(chunk_time_ns_, kNever - now_ns);
  const mcap::Message head{
      chunk.index.channel_id, static_cast<std::uint32_t>(message.sequence), message.capture_ns, message.publish_ns, {}};
  chunk.add_head(head, message.bytes.size());

  // the message that fills a chunk is not copied into it: an image is written directly to the file
  const bool due = now_ns >= chunk.due_ns || chunk.records.size() + message.bytes.size() >= chunk_bytes_;
  if (!due) {
    chunk.records.append(message.bytes);
    return {};
  }
  const std::uint64_t lost_before = lost_;
  const Result<void> written = write_chunk(channel, message.bytes);
  return with_loss(written, lost_ - lost_before);
}

std::uint64_t McapWriter::flush_due_ns() const {
  std::uint64_t due_ns = kNever;
  for (const mcap::CollectedChunk& chunk : chunks_) due_ns = std::min(due_ns, chunk.due_ns);
  return due_ns;
}

std::uint64_t McapWriter::collected() const {
  std::uint64_t messages = 0;
  for (const mcap::CollectedChunk& chunk : chunks_) messages += chunk.index.entries.size();
  return messages;
}

Result<void> McapWriter::flush(std::uint64_t now_ns) {
  const std::uint64_t lost_before = lost_;
  Result<void> flushed;
  for (std::size_t channel = 0; channel < chunks_.size(); ++channel) {
    if (chunks_[channel].empty() || chunks_[channel].due_ns > now_ns) continue;
    const Result<void> written = write_chunk(channel, {});
    if (flushed) flushed = written;
  }
  return with_loss(flushed, lost_ - lost_before);
}

/// Writes the collected messages of a channel. `last_bytes` are the data of the last one. After an Error they are lost.
Result<void> McapWriter::write_chunk(std::size_t channel, std::string_view last_bytes) {
  Result<void> written = attempt("writing a chunk", [&] { return append_chunk(channel, last_bytes); });
  if (!written) lost_ += chunks_[channel].index.entries.size();
  chunks_[channel].clear();
  return written;
}

/// Appends the collected records of a channel and their index to the file.
Result<void> McapWriter::append_chunk(std::size_t channel, std::string_view last_bytes) {
  const mcap::CollectedChunk& chunk = chunks_[channel];
  const std::array<std::string_view, 2> records = {chunk.records, last_bytes};
  const Result<mcap::ChunkHead> head = pack(chunk, records);
  if (!head) return head.failure();
  std::string chunk_head, index;
  mcap::append(chunk_head, *head, head->packed_bytes);
  mcap::append(index, chunk.index);
  const bool packed = !head->compression.empty();
  const std::array<std::string_view, 4> pieces = {chunk_head, packed ? std::string_view(packed_) : records[0],
                                                  packed ? std::string_view() : records[1], index};

  // the bytes of an uncompressed chunk have a checksum already: combine it instead of computing it again
  const std::uint32_t records_crc = packed ? mcap::crc32(packed_) : head->unpacked_crc;
  std::uint32_t crc = mcap::crc32_of_both(mcap::crc32(chunk_head, crc_), records_crc, head->packed_bytes);
  crc = mcap::crc32(index, crc);

  summary_.chunk_indexes.reserve(summary_.chunk_indexes.size() + kMaxChunkIndexBytes);  // nothing fails after the write
  if (Result<void> written = append(pieces, crc); !written) return written;
  count_chunk(channel, *head, chunk_head.size() + head->packed_bytes, index.size());
  return {};
}

/// Compresses `records` into packed_ and returns the head of their chunk. The chunk stays uncompressed if that is
/// smaller.
Result<mcap::ChunkHead> McapWriter::pack(const mcap::CollectedChunk& chunk, std::span<const std::string_view> records) {
  mcap::ChunkHead head;
  head.start_ns = chunk.start_ns;
  head.end_ns = chunk.end_ns;
  head.unpacked_bytes = head.packed_bytes = total(records);
  head.unpacked_crc = crc_behind(0, records);
  if (compressor_.compression() == Compression::none) return head;

  if (const Result<void> done = compressor_.compress(records, packed_); !done) return done.failure();
  if (packed_.size() >= head.unpacked_bytes) return head;
  head.packed_bytes = packed_.size();
  head.compression = name(compressor_.compression());
  return head;
}

/// Enters the last chunk of the file into the summary.
void McapWriter::count_chunk(std::size_t channel, const mcap::ChunkHead& head, std::uint64_t record_bytes,
                             std::uint64_t index_bytes) {
  const std::uint64_t index_offset = good_end_ - index_bytes;
  const mcap::MessageIndex& index = chunks_[channel].index;
  mcap::append(summary_.chunk_indexes, mcap::ChunkIndex{head.start_ns,
                                                        head.end_ns,
                                                        index_offset - record_bytes,
                                                        record_bytes,
                                                        {{index.channel_id, index_offset}},
                                                        index_bytes,
                                                        head.compression,
                                                        head.packed_bytes,
                                                        head.unpacked_bytes});
  const bool first = statistics_.messages == 0;
  statistics_.start_ns = first ? head.start_ns : std::min(statistics_.start_ns, head.start_ns);
  statistics_.end_ns = std::max(statistics_.end_ns, head.end_ns);
  statistics_.messages += index.entries.size();
  statistics_.channel_messages[channel].second += index.entries.size();
  ++statistics_.chunks;
}

/// Appends all of `pieces`, or none after an Error. `crc_after` is the checksum of the file including them.
Result<void> McapWriter::append(std::span<const std::string_view> pieces, std::uint32_t crc_after) {
  if (torn_) {
    if (Result<void> cut = sink_->truncate(good_end_); !cut) return cut;
    torn_ = false;
  }
  if (Result<void> written = sink_->append(pieces); !written) {
    // if the truncation fails too, it is tried again before the next write
    torn_ = !sink_->truncate(good_end_);
    return written;
  }
  good_end_ += total(pieces);
  crc_ = crc_after;
  return {};
}

Result<void> McapWriter::close() {
  if (closed_) return {};
  const Result<void> flushed = flush();
  mcap::Statistics statistics = statistics_;
  std::erase_if(statistics.channel_messages, [](const auto& channel) { return channel.second == 0; });
  summary_.statistics.clear();
  mcap::append(summary_.statistics, statistics);
  const std::string end = mcap::encode_end(summary_, good_end_, crc_);
  const std::string_view pieces[] = {end};
  const Result<void> written = append(pieces, 0);
  closed_ = bool(written);
  return written ? flushed : written;
}

}  // namespace robot::logging
