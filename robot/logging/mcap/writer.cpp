#include "robot/logging/mcap/writer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace robot::logging {
namespace {

constexpr std::uint16_t kSchemaId = 1;
// leaves room for earlier messages of the chunk and for growth by compression
constexpr std::uint64_t kMaxMessageBytes = mcap::kMaxRecordBytes / 2;

std::uint64_t total(std::span<const std::string_view> pieces) {
  std::uint64_t size = 0;
  for (const std::string_view piece : pieces) size += piece.size();
  return size;
}

std::uint32_t crc_behind(std::uint32_t before, std::span<const std::string_view> pieces) {
  for (const std::string_view piece : pieces) before = mcap::crc32(piece, before);
  return before;
}

}  // namespace

McapWriter::McapWriter(std::unique_ptr<ByteSink> sink, const McapOptions& options)
    : sink_(std::move(sink)),
      channel_id_(options.channel_id),
      chunk_bytes_(std::min<std::size_t>(options.chunk_bytes, mcap::kMaxRecordBytes / 4)),
      chunk_time_ns_(options.chunk_time_ns),
      compressor_(options.compression) {
  index_.channel_id = channel_id_;
}

Result<McapWriter> McapWriter::open(std::unique_ptr<ByteSink> sink, const memory::ChannelInfo& channel,
                                    const McapOptions& options) {
  McapWriter writer(std::move(sink), options);
  if (const Result<void> written = writer.write_head(channel, options); !written) return written.failure();
  return writer;
}

/// Writes Magic, Header, Metadata, Schema and Channel, and enters them into the summary.
Result<void> McapWriter::write_head(const memory::ChannelInfo& channel, const McapOptions& options) {
  std::string head(mcap::kMagic);
  mcap::append(head, mcap::Header{"", options.library});
  for (const auto& [name, entries] : options.metadata) {
    const std::uint64_t offset = head.size();
    mcap::append(head, mcap::Metadata{name, entries});
    mcap::append(summary_.metadata_indexes, mcap::MetadataIndex{offset, head.size() - offset, name});
  }
  const memory::Schema& schema = channel.schema;
  mcap::append(summary_.schemas, mcap::Schema{kSchemaId, schema.name, schema.encoding, schema.bytes});
  mcap::append(summary_.channels, mcap::Channel{channel_id_,
                                                kSchemaId,
                                                channel.topic,
                                                channel.message_encoding,
                                                {{"delivery", std::string(memory::name(channel.delivery))}}});
  head += summary_.schemas + summary_.channels;

  statistics_.schemas = 1;
  statistics_.channels = 1;
  statistics_.metadata = static_cast<std::uint32_t>(options.metadata.size());
  const std::string_view pieces[] = {head};
  return append(pieces, crc_behind(0, pieces));
}

Result<void> McapWriter::write(const OutMessage& message, std::uint64_t now_ns) {
  assert(!closed_ && "nothing is written behind the end");
  if (message.bytes.size() > kMaxMessageBytes) {
    ++lost_;
    return Error{"cannot write a message: expected at most " + std::to_string(kMaxMessageBytes) + " bytes, got " +
                 std::to_string(message.bytes.size())};
  }
  if (index_.entries.empty()) {
    chunk_start_ns_ = chunk_end_ns_ = message.capture_ns;
    flush_due_ns_ = now_ns + std::min(chunk_time_ns_, kNever - now_ns);
  }
  chunk_start_ns_ = std::min(chunk_start_ns_, message.capture_ns);
  chunk_end_ns_ = std::max(chunk_end_ns_, message.capture_ns);
  index_.entries.emplace_back(message.capture_ns, records_.size());
  const mcap::Message head{
      channel_id_, static_cast<std::uint32_t>(message.sequence), message.capture_ns, message.publish_ns, {}};
  mcap::append(records_, head, message.bytes.size());

  // the message that fills a chunk is not copied into it: an image is written directly to the file
  const bool due = now_ns >= flush_due_ns_ || records_.size() + message.bytes.size() >= chunk_bytes_;
  if (due) return write_chunk(message.bytes);
  records_.append(message.bytes);
  return {};
}

Result<void> McapWriter::flush() {
  if (index_.entries.empty()) return {};
  return write_chunk({});
}

/// Writes the collected records and their index. `last_bytes` are the data of the last record.
Result<void> McapWriter::write_chunk(std::string_view last_bytes) {
  const std::array<std::string_view, 2> records = {records_, last_bytes};
  const Result<mcap::ChunkHead> head = pack(records);
  Result<void> written = head ? Result<void>() : Result<void>(head.failure());
  if (head) {
    std::string chunk_head, index;
    mcap::append(chunk_head, *head, head->packed_bytes);
    mcap::append(index, index_);
    const bool packed = !head->compression.empty();
    const std::array<std::string_view, 4> pieces = {chunk_head, packed ? std::string_view(packed_) : records[0],
                                                    packed ? std::string_view() : records[1], index};

    // the bytes of an uncompressed chunk have a checksum already: combine it instead of computing it again
    const std::uint32_t records_crc = packed ? mcap::crc32(packed_) : head->unpacked_crc;
    std::uint32_t crc = mcap::crc32_of_both(mcap::crc32(chunk_head, crc_), records_crc, head->packed_bytes);
    crc = mcap::crc32(index, crc);

    const std::uint64_t record_bytes = chunk_head.size() + head->packed_bytes;
    written = append(pieces, crc);
    if (written) count_chunk(*head, record_bytes, index.size());
  }
  const std::size_t messages = index_.entries.size();
  forget_chunk();
  if (written) return {};
  lost_ += messages;
  return Error{written.error() + "; messages lost: " + std::to_string(messages)};
}

/// Compresses `records` into packed_ and returns the head of their chunk. The chunk stays uncompressed if that is
/// smaller.
Result<mcap::ChunkHead> McapWriter::pack(std::span<const std::string_view> records) {
  mcap::ChunkHead head;
  head.start_ns = chunk_start_ns_;
  head.end_ns = chunk_end_ns_;
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
void McapWriter::count_chunk(const mcap::ChunkHead& head, std::uint64_t record_bytes, std::uint64_t index_bytes) {
  const std::uint64_t index_offset = good_end_ - index_bytes;
  mcap::append(summary_.chunk_indexes, mcap::ChunkIndex{head.start_ns,
                                                        head.end_ns,
                                                        index_offset - record_bytes,
                                                        record_bytes,
                                                        {{channel_id_, index_offset}},
                                                        index_bytes,
                                                        head.compression,
                                                        head.packed_bytes,
                                                        head.unpacked_bytes});
  const bool first = statistics_.messages == 0;
  statistics_.start_ns = first ? head.start_ns : std::min(statistics_.start_ns, head.start_ns);
  statistics_.end_ns = std::max(statistics_.end_ns, head.end_ns);
  statistics_.messages += index_.entries.size();
  statistics_.channel_messages = {{channel_id_, statistics_.messages}};
  ++statistics_.chunks;
}

void McapWriter::forget_chunk() {
  records_.clear();
  index_.entries.clear();
  flush_due_ns_ = kNever;
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
  summary_.statistics.clear();
  mcap::append(summary_.statistics, statistics_);
  const std::string end = mcap::encode_end(summary_, good_end_, crc_);
  const std::string_view pieces[] = {end};
  const Result<void> written = append(pieces, 0);
  closed_ = bool(written);
  return written ? flushed : written;
}

}  // namespace robot::logging
