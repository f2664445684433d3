#include "robot/logging/mcap/chunk.h"

#include <utility>

#include "robot/logging/mcap/compression.h"

namespace robot::logging::mcap {
namespace {

std::string at_chunk(std::uint64_t offset, const std::string& sentence) {
  return "Chunk at byte " + std::to_string(offset) + ": " + sentence;
}

template <class Record>
Result<Record> decode_inside(const RecordView& view, std::uint64_t chunk_offset) {
  Result<Record> record = decode<Record>(view.content, view.offset);
  if (!record) return Error{at_chunk(chunk_offset, record.error())};
  return record;
}

Result<void> add(ChunkContents& contents, const RecordView& view, std::uint64_t chunk_offset) {
  if (view.op == Op::message) {
    const Result<Message> message = decode_inside<Message>(view, chunk_offset);
    if (!message) return message.failure();
    MessageIndex& index = contents.indexes[message->channel_id];
    index.channel_id = message->channel_id;
    index.entries.emplace_back(message->log_time, view.offset);
  } else if (view.op == Op::schema) {
    Result<Schema> schema = decode_inside<Schema>(view, chunk_offset);
    if (!schema) return schema.failure();
    contents.schemas.push_back(std::move(*schema));
  } else if (view.op == Op::channel) {
    Result<Channel> channel = decode_inside<Channel>(view, chunk_offset);
    if (!channel) return channel.failure();
    contents.channels.push_back(std::move(*channel));
  }
  return {};
}

}  // namespace

Result<std::string_view> unpack_chunk(std::string_view content, std::uint64_t offset, std::string& room) {
  const Result<ChunkHead> head = decode<ChunkHead>(content, offset);
  if (!head) return head.failure();
  const std::string_view packed = content.substr(head->size_bytes());
  if (head->packed_bytes > packed.size())
    return Error{at_chunk(offset, "expected " + std::to_string(head->packed_bytes) + " bytes of records, " +
                                      std::to_string(packed.size()) + " are left")};
  if (head->unpacked_bytes > kMaxRecordBytes)
    return Error{at_chunk(offset, "expected at most " + std::to_string(kMaxRecordBytes) + " bytes unpacked, got " +
                                      std::to_string(head->unpacked_bytes))};

  const Result<Compression> compression = compression_named(head->compression);
  if (!compression) return Error{at_chunk(offset, compression.error())};
  std::string_view records = packed.substr(0, static_cast<std::size_t>(head->packed_bytes));
  if (*compression != Compression::none || head->packed_bytes != head->unpacked_bytes) {
    Result<std::string> unpacked = decompress(*compression, records, static_cast<std::size_t>(head->unpacked_bytes));
    if (!unpacked) return Error{at_chunk(offset, unpacked.error())};
    room = std::move(*unpacked);
    records = room;
  }

  if (head->unpacked_crc != 0 && crc32(records) != head->unpacked_crc)
    return Error{at_chunk(offset, "its checksum is wrong, it is damaged")};
  return records;
}

Result<ChunkContents> survey_chunk(std::string_view records, std::uint64_t offset) {
  ChunkContents contents;
  for (std::size_t at = 0; at < records.size();) {
    const Result<RecordView> view = take_record(records, at);
    if (!view) return Error{at_chunk(offset, view.error())};
    if (const Result<void> added = add(contents, *view, offset); !added) return added.failure();
  }
  return contents;
}

}  // namespace robot::logging::mcap
