#include "robot/logging/mcap/chunk.h"

#include <utility>

#include "robot/logging/mcap/compression.h"

namespace robot::logging::mcap {
namespace {

std::string at_chunk(std::uint64_t offset, const std::string& sentence) {
  return "Chunk at byte " + std::to_string(offset) + ": " + sentence;
}

/// Appends the record to `records`, or returns an Error if it is damaged.
template <class Record>
Result<void> add_to(std::vector<Record>& records, const RecordView& view) {
  Result<Record> record = decode<Record>(view.content, view.offset);
  if (!record) return record.failure();
  records.push_back(std::move(*record));
  return {};
}

Result<void> add(ChunkContents& contents, const RecordView& view) {
  if (view.op == Op::schema) return add_to(contents.schemas, view);
  if (view.op == Op::channel) return add_to(contents.channels, view);
  if (view.op != Op::message) return {};
  const Result<Message> message = decode<Message>(view.content, view.offset);
  if (!message) return message.failure();
  MessageIndex& index = contents.indexes[message->channel_id];
  index.channel_id = message->channel_id;
  index.entries.emplace_back(message->log_time, view.offset);
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
  // other writers may give no size for records that are not compressed
  if (!head->compression.empty() && head->unpacked_bytes > kMaxRecordBytes)
    return Error{at_chunk(offset, "expected at most " + std::to_string(kMaxRecordBytes) + " bytes unpacked, got " +
                                      std::to_string(head->unpacked_bytes))};

  const Result<Compression> compression = compression_named(head->compression);
  if (!compression) return Error{at_chunk(offset, compression.error())};
  std::string_view records = packed.substr(0, static_cast<std::size_t>(head->packed_bytes));
  if (*compression != Compression::none) {
    Result<std::string> unpacked = decompress(*compression, records, static_cast<std::size_t>(head->unpacked_bytes));
    if (!unpacked) return Error{at_chunk(offset, unpacked.error())};
    room = std::move(*unpacked);
    records = room;
  }

  if (head->unpacked_crc != 0 && crc32(records) != head->unpacked_crc)
    return Error{at_chunk(offset, "its checksum is wrong, it is damaged")};
  return records;
}

ChunkContents survey_records(std::string_view records, const std::string& where) {
  ChunkContents contents;
  const auto note = [&](const std::string& sentence) {
    if (contents.damage.empty()) contents.damage = where + ": " + sentence;
  };
  for (std::size_t at = 0; at < records.size();) {
    const Result<RecordView> view = take_record(records, at);
    if (!view) {
      note(view.error());
      break;
    }
    if (const Result<void> added = add(contents, *view); !added) note(added.error());
  }
  return contents;
}

}  // namespace robot::logging::mcap
