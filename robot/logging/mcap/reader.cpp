#include "robot/logging/mcap/reader.h"

#include <algorithm>
#include <utility>

#include "robot/logging/mcap/chunk.h"

namespace robot::logging {
namespace {

using mcap::Op;

constexpr std::uint64_t kSkipBytes = 256 * 1024;  // size of one read of bytes that only the checksum needs

}  // namespace

McapReader::Next McapReader::next() {
  while (true) {
    const bool in_chunk = chunk_at_ < chunk_.size();
    if (!in_chunk && ended_) return std::optional<McapMessage>();
    Next found = in_chunk ? next_in_chunk() : next_in_file();
    if (!found || *found) return found;
  }
}

McapReader::Next McapReader::next_in_chunk() {
  const std::string where = "Chunk at byte " + std::to_string(chunk_offset_) + ": ";
  const auto record = mcap::take_record(chunk_, chunk_at_);
  if (!record) {
    chunk_ = {};
    return damaged(where + record.error());
  }
  if (record->op == Op::chunk) return damaged(where + "expected no chunk within a chunk");
  return take_from(*record);
}

McapReader::Next McapReader::next_in_file() {
  if (position_ == 0) {
    const auto magic = read_bytes(*source_, 0, std::min<std::uint64_t>(source_->size(), mcap::kMagic.size()));
    ended_ = !magic || *magic != mcap::kMagic;
    if (!magic) return magic.failure();
    if (ended_) return damaged("not an MCAP file: expected the magic bytes at its start");
    crc_ = mcap::crc32(*magic);
    position_ = magic->size();
  }
  if (position_ == source_->size())
    return lost_track("ends at byte " + std::to_string(position_) + " without a DataEnd: its writer was interrupted");

  const std::uint64_t left = source_->size() - position_;
  const auto bytes = read_bytes(*source_, position_, std::min<std::uint64_t>(left, mcap::kRecordHeadBytes));
  if (!bytes) return lost_track(bytes.error());
  const auto head = mcap::decode_record_head(*bytes, position_, left);
  if (!head) return lost_track(head.error());
  if (head->op == Op::footer)
    return lost_track("expected a DataEnd before the Footer at byte " + std::to_string(position_));
  if (whole_ && head->op != Op::data_end) crc_ = mcap::crc32(*bytes, crc_);
  last_offset_ = position_;
  return take(head->op, head->length);
}

/// Reads and handles the record at position_, whose head was read.
McapReader::Next McapReader::take(Op op, std::uint64_t content_bytes) {
  const std::uint64_t offset = position_;
  position_ += mcap::kRecordHeadBytes;
  const auto skips = can_skip(op, content_bytes);
  if (skips && *skips) {
    if (const auto skipped = skip(content_bytes); !skipped) return lost_track(skipped.error());
    return std::optional<McapMessage>();
  }

  position_ += content_bytes;
  if (!skips) return damaged(skips.error());
  content_.resize(static_cast<std::size_t>(content_bytes));
  if (const auto read = source_->read(offset + mcap::kRecordHeadBytes, content_); !read)
    return lost_track(read.error());
  if (whole_ && op != Op::data_end) crc_ = mcap::crc32(content_, crc_);
  return take_from({op, offset, content_});
}

/// Returns whether the reader does not need the record at position_ - kRecordHeadBytes, or an Error if it is too large
/// to read.
Result<bool> McapReader::can_skip(Op op, std::uint64_t content_bytes) const {
  const bool wanted =
      op == Op::schema || op == Op::channel || op == Op::message || op == Op::chunk || op == Op::data_end;
  if (!wanted) return true;
  if (content_bytes > mcap::kMaxRecordBytes)
    return Error{mcap::name(op) + " at byte " + std::to_string(position_ - mcap::kRecordHeadBytes) +
                 ": expected at most " + std::to_string(mcap::kMaxRecordBytes) + " bytes, got " +
                 std::to_string(content_bytes)};
  if (op != Op::chunk || from_ns_ == 0) return false;

  // a chunk that ends before the wanted time is not read at all
  const auto start = read_bytes(*source_, position_, std::min<std::uint64_t>(content_bytes, 64));
  const auto head = start ? mcap::decode<mcap::ChunkHead>(*start, position_) : start.failure();
  return head && head->end_ns < from_ns_;
}

/// Skips `bytes` of the file. Reads them only if the checksum needs them.
Result<void> McapReader::skip(std::uint64_t bytes) {
  for (; whole_ && bytes > 0;) {
    content_.resize(static_cast<std::size_t>(std::min(bytes, kSkipBytes)));
    if (const auto read = source_->read(position_, content_); !read) return read.failure();
    crc_ = mcap::crc32(content_, crc_);
    position_ += content_.size();
    bytes -= content_.size();
  }
  position_ += bytes;
  return {};
}

/// Handles one record, inside or outside a chunk.
McapReader::Next McapReader::take_from(const mcap::RecordView& record) {
  switch (record.op) {
    case Op::schema: {
      auto schema = mcap::decode<mcap::Schema>(record.content, record.offset);
      if (!schema) return damaged(schema.error());
      schemas_.emplace(schema->id, *schema);
      return std::optional<McapMessage>();
    }
    case Op::channel: {
      auto channel = mcap::decode<mcap::Channel>(record.content, record.offset);
      if (!channel) return damaged(channel.error());
      channels_.emplace(channel->id, *channel);
      return std::optional<McapMessage>();
    }
    case Op::message: {
      const auto message = mcap::decode<mcap::Message>(record.content, record.offset);
      if (!message) return damaged(message.error());
      if (!channels_.contains(message->channel_id)) summary();
      if (!channels_.contains(message->channel_id)) return unknown_channel(message->channel_id);
      if (message->log_time < from_ns_) return std::optional<McapMessage>();
      return std::optional<McapMessage>(
          {message->channel_id,
           {message->sequence, message->log_time, message->publish_time, std::string(message->data)}});
    }
    case Op::chunk: return open_chunk(record);
    case Op::data_end: return end_of_data(record);
    default: return std::optional<McapMessage>();
  }
}

McapReader::Next McapReader::open_chunk(const mcap::RecordView& record) {
  chunk_ = {};
  const auto records = mcap::unpack_chunk(record.content, record.offset, unpacked_);
  if (!records) return damaged(records.error());
  chunk_ = *records;
  chunk_at_ = 0;
  chunk_offset_ = record.offset;
  return std::optional<McapMessage>();
}

/// Handles the end of the data: compares the checksum over all bytes, if all were read.
McapReader::Next McapReader::end_of_data(const mcap::RecordView& record) {
  ended_ = true;
  const auto end = mcap::decode<mcap::DataEnd>(record.content, record.offset);
  if (!end) return damaged(end.error());
  if (whole_ && end->data_crc != 0 && end->data_crc != crc_)
    return damaged("the data before byte " + std::to_string(record.offset) + " are damaged: their checksum is wrong");
  const auto summary = mcap::read_summary(*source_);
  if (!summary) return summary.failure();
  return std::optional<McapMessage>();
}

/// Handles invalid records at position_: continues at the next chunk of the summary, or ends. The cause may be a too
/// large length of the record before, so the search also finds the chunks that this record seemed to include.
McapReader::Next McapReader::lost_track(const std::string& sentence) {
  ended_ = true;
  if (summary()) {
    const auto& chunks = summary_->chunk_indexes;
    const auto after = [](std::uint64_t offset, const mcap::ChunkIndex& chunk) { return offset < chunk.offset; };
    auto chunk = std::upper_bound(chunks.begin(), chunks.end(), last_offset_, after);
    if (chunk != chunks.end() && chunk->offset == position_) ++chunk;
    ended_ = chunk == chunks.end();
    if (!ended_) last_offset_ = position_ = chunk->offset;
  }
  return damaged(sentence);
}

/// Reads the summary at the first call and enters its schemas and channels. For facts that the data do not give.
const std::optional<mcap::Summary>& McapReader::summary() {
  if (summary_read_) return summary_;
  summary_read_ = true;
  auto summary = mcap::read_summary(*source_);
  if (!summary || !*summary) return summary_;
  summary_ = std::move(*summary);
  for (const mcap::Schema& schema : summary_->schemas) schemas_.emplace(schema.id, schema);
  for (const mcap::Channel& channel : summary_->channels) channels_.emplace(channel.id, channel);
  return summary_;
}

McapReader::Next McapReader::unknown_channel(std::uint16_t id) {
  whole_ = false;
  if (!unknown_channels_.insert(id).second) return std::optional<McapMessage>();
  return damaged("channel " + std::to_string(id) + " is not described: its messages are left out");
}

/// Notes that bytes were skipped, and returns the Error of this damage.
Error McapReader::damaged(const std::string& sentence) {
  whole_ = false;
  return Error{source_->name() + ": " + sentence};
}

Result<void> McapReader::need_index() {
  if (index_) return {};
  auto index = read_index(*source_);
  if (!index) return index.failure();
  index_ = std::move(*index);
  for (const auto& [id, schema] : index_->schemas) schemas_.emplace(id, schema);
  for (const auto& [id, channel] : index_->channels) channels_.emplace(id, channel);
  return {};
}

Result<std::vector<std::uint64_t>> McapReader::chunk_starts_until(std::uint64_t capture_ns) {
  if (Result<void> indexed = need_index(); !indexed) return indexed.failure();
  std::vector<std::uint64_t> starts;
  if (index_->unchunked_messages > 0) starts.push_back(0);
  for (const ChunkInfo& chunk : index_->chunks)
    if (chunk.index.start_ns <= capture_ns) starts.push_back(chunk.index.start_ns);
  std::ranges::sort(starts);
  return starts;
}

Result<void> McapReader::seek(std::uint64_t capture_ns) {
  if (Result<void> indexed = need_index(); !indexed) return indexed;

  whole_ = false;
  from_ns_ = capture_ns;
  chunk_ = {};
  chunk_at_ = 0;
  ended_ = false;
  position_ = mcap::kMagic.size();
  // messages outside chunks have no index: search for them from the start of the file
  if (index_->unchunked_messages > 0) return {};
  const auto& chunks = index_->chunks;
  const auto first = std::find_if(chunks.begin(), chunks.end(),
                                  [&](const ChunkInfo& chunk) { return chunk.index.end_ns >= capture_ns; });
  ended_ = first == chunks.end();
  if (!ended_) position_ = first->index.offset;
  return {};
}

}  // namespace robot::logging
