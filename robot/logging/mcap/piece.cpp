#include "robot/logging/mcap/piece.h"

#include <utility>

namespace robot::logging {

Result<void> fits_memory(const ChunkInfo& piece) {
  const mcap::ChunkIndex& place = piece.index;
  const bool expands = !place.compression.empty() && place.unpacked_bytes > mcap::kMaxRecordBytes;
  if (!expands && place.record_bytes <= mcap::kMaxRecordBytes) return {};
  return Error{place_of(piece) + ": expected at most " + std::to_string(mcap::kMaxRecordBytes) + " bytes" +
               (expands ? " unpacked" : "") + ", got " +
               std::to_string(expands ? place.unpacked_bytes : place.record_bytes)};
}

std::string place_of(const ChunkInfo& piece) {
  return (piece.is_run ? "records at byte " : "Chunk at byte ") + std::to_string(piece.index.offset);
}

Result<std::string> read_records(const ByteSource& source, const ChunkInfo& piece) {
  const mcap::ChunkIndex& place = piece.index;
  if (const Result<void> allowed = fits_memory(piece); !allowed) return allowed.failure();
  Result<std::string> bytes = read_bytes(source, place.offset, place.record_bytes);
  if (!bytes || piece.is_run) return bytes;
  std::size_t at = 0;
  const auto record = mcap::take_record(*bytes, at, place.offset);
  if (!record) return record.failure();
  if (record->op != mcap::Op::chunk)
    return Error{place_of(piece) + ": expected a Chunk, got " + mcap::name(record->op)};
  std::string room;
  const auto records = mcap::unpack_chunk(record->content, place.offset, room);
  if (!records) return records.failure();
  if (!room.empty() || records->empty()) return room;
  // the records are within the bytes that were read: no second copy of a large chunk
  const std::size_t size = records->size();
  bytes->erase(0, static_cast<std::size_t>(records->data() - bytes->data()));
  bytes->resize(size);
  return bytes;
}

Result<mcap::ChunkContents> read_chunk(const ByteSource& source, const mcap::ChunkIndex& chunk) {
  const Result<std::string> records = read_records(source, {.index = chunk});
  if (!records) return records.failure();
  return mcap::survey_records(*records, place_of({.index = chunk}));
}

}  // namespace robot::logging
