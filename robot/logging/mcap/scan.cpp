#include "robot/logging/mcap/scan.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace robot::logging {
namespace {

using mcap::Op;

constexpr std::uint64_t kChunkHeadBytes = 64;  // holds a ChunkHead with any compression we know

class Scan {
 public:
  explicit Scan(const ByteSource& source) : source_(source) {}

  McapIndex run() {
    Result<bool> more = true;
    while (more && *more) more = next_record();
    if (!more) note(more.error());

    std::vector<ChunkInfo> found;
    found.swap(index_.chunks);
    for (ChunkInfo& chunk : found) {
      const bool last_of_interrupted = !index_.complete && &chunk == &found.back();
      if (last_of_interrupted || !tells_enough(chunk)) {
        if (const Result<void> looked = look_into(chunk); !looked) {
          note(looked.error());
          continue;
        }
      }
      index_.chunks.push_back(std::move(chunk));
    }
    count();
    return std::move(index_);
  }

 private:
  /// Handles the record at `at_`. Returns false at the end of the data.
  Result<bool> next_record() {
    if (at_ == source_.size())
      return Error{"ends at byte " + std::to_string(at_) + " without a DataEnd: its writer was interrupted"};
    const std::uint64_t left = source_.size() - at_;
    const auto bytes = read_bytes(source_, at_, std::min<std::uint64_t>(left, mcap::kRecordHeadBytes));
    if (!bytes) return bytes.failure();
    const auto head = mcap::decode_record_head(*bytes, at_, left);
    if (!head) return head.failure();
    if (head->op == Op::footer) return Error{"expected a DataEnd before the Footer at byte " + std::to_string(at_)};
    index_.complete = head->op == Op::data_end;
    if (index_.complete) return false;

    const Result<void> taken = take(head->op, head->length);
    if (!taken) return taken.failure();
    at_ += mcap::kRecordHeadBytes + head->length;
    return true;
  }

  Result<void> take(Op op, std::uint64_t length) {
    switch (op) {
      case Op::schema: return take_whole<mcap::Schema>(length, [&](auto& schema) { keep(index_.schemas, schema); });
      case Op::channel:
        return take_whole<mcap::Channel>(length, [&](auto& channel) { keep(index_.channels, channel); });
      case Op::metadata:
        return take_whole<mcap::Metadata>(length,
                                          [&](auto& metadata) { index_.metadata.push_back(std::move(metadata)); });
      case Op::chunk: return take_chunk(length);
      case Op::message_index: return take_message_index(length);
      case Op::message: ++index_.unchunked_messages; return {};
      default: return {};
    }
  }

  template <class Record, class Keep>
  Result<void> take_whole(std::uint64_t length, Keep&& keep) {
    auto record = decode_start<Record>(length, mcap::kMaxRecordBytes);
    if (!record) return record.failure();
    keep(*record);
    return {};
  }

  /// Decodes a record from the first `most` bytes of its content.
  template <class Record>
  Result<Record> decode_start(std::uint64_t length, std::uint64_t most) {
    const auto content = read_bytes(source_, at_ + mcap::kRecordHeadBytes, std::min(length, most));
    if (!content) return content.failure();
    return mcap::decode<Record>(*content, at_);
  }

  template <class Records, class Record>
  static void keep(Records& records, Record& record) {
    const std::uint16_t id = record.id;
    records.emplace(id, std::move(record));
  }

  Result<void> take_chunk(std::uint64_t length) {
    const auto head = decode_start<mcap::ChunkHead>(length, kChunkHeadBytes);
    if (!head) return head.failure();
    if (head->packed_bytes > length - head->size_bytes())
      return Error{"Chunk at byte " + std::to_string(at_) + ": expected " + std::to_string(head->packed_bytes) +
                   " bytes of records, its record has " + std::to_string(length - head->size_bytes())};
    ChunkInfo chunk;
    chunk.index.start_ns = head->start_ns;
    chunk.index.end_ns = head->end_ns;
    chunk.index.offset = at_;
    chunk.index.record_bytes = mcap::kRecordHeadBytes + length;
    chunk.index.compression = head->compression;
    chunk.index.packed_bytes = head->packed_bytes;
    chunk.index.unpacked_bytes = head->unpacked_bytes;
    index_.chunks.push_back(std::move(chunk));
    return {};
  }

  Result<void> take_message_index(std::uint64_t length) {
    if (index_.chunks.empty()) return {};
    ChunkInfo& chunk = index_.chunks.back();
    mcap::ChunkIndex& place = chunk.index;
    // ignore a message index that does not follow its chunk
    if (at_ != place.offset + place.record_bytes + place.message_index_bytes) return {};
    const auto start = read_bytes(source_, at_ + mcap::kRecordHeadBytes, std::min<std::uint64_t>(length, 2));
    if (!start) return start.failure();
    if (length < 6) return Error{"MessageIndex at byte " + std::to_string(at_) + ": expected at least 6 bytes"};
    const auto low = static_cast<std::uint8_t>((*start)[0]), high = static_cast<std::uint8_t>((*start)[1]);
    const auto channel = static_cast<std::uint16_t>(low | high << 8);
    place.message_indexes.emplace_back(channel, at_);
    place.message_index_bytes += mcap::kRecordHeadBytes + length;
    chunk.messages.emplace_back(channel, (length - 6) / 16);
    return {};
  }

  bool tells_enough(const ChunkInfo& chunk) const {
    const auto known = [&](const auto& entry) { return index_.channels.contains(entry.first); };
    return !chunk.messages.empty() && std::all_of(chunk.messages.begin(), chunk.messages.end(), known);
  }

  /// Completes the facts about a chunk from its messages. Discards message indexes that do not match them.
  Result<void> look_into(ChunkInfo& chunk) {
    auto contents = read_chunk(source_, chunk.index);
    if (!contents) return contents.failure();
    for (mcap::Schema& schema : contents->schemas) keep(index_.schemas, schema);
    for (mcap::Channel& channel : contents->channels) keep(index_.channels, channel);

    mcap::Numbers<std::uint16_t> messages;
    for (const auto& [channel, index] : contents->indexes) messages.emplace_back(channel, index.entries.size());
    std::sort(chunk.messages.begin(), chunk.messages.end());
    if (chunk.messages != messages) chunk.index.message_indexes.clear(), chunk.index.message_index_bytes = 0;
    chunk.messages = std::move(messages);
    return {};
  }

  void count() {
    index_.statistics = statistics_of(index_.chunks);
    index_.statistics.messages += index_.unchunked_messages;
    index_.statistics.schemas = static_cast<std::uint16_t>(index_.schemas.size());
    index_.statistics.channels = static_cast<std::uint32_t>(index_.channels.size());
    index_.statistics.metadata = static_cast<std::uint32_t>(index_.metadata.size());
  }

  void note(const std::string& sentence) {
    if (index_.damage.empty()) index_.damage = source_.name() + ": " + sentence;
  }

  const ByteSource& source_;
  std::uint64_t at_ = mcap::kMagic.size();
  McapIndex index_;
};

}  // namespace

McapIndex scan(const ByteSource& source) { return Scan(source).run(); }

Result<mcap::ChunkContents> read_chunk(const ByteSource& source, const mcap::ChunkIndex& chunk) {
  const std::string where = "Chunk at byte " + std::to_string(chunk.offset);
  if (chunk.record_bytes < mcap::kRecordHeadBytes || chunk.record_bytes > mcap::kMaxRecordBytes)
    return Error{where + ": expected at most " + std::to_string(mcap::kMaxRecordBytes) + " bytes, got " +
                 std::to_string(chunk.record_bytes)};
  const auto bytes = read_bytes(source, chunk.offset, chunk.record_bytes);
  if (!bytes) return bytes.failure();
  std::size_t at = 0;
  const auto record = mcap::take_record(*bytes, at, chunk.offset);
  if (!record) return record.failure();
  if (record->op != Op::chunk) return Error{where + ": expected a Chunk, got " + mcap::name(record->op)};
  std::string room;
  const auto records = mcap::unpack_chunk(record->content, chunk.offset, room);
  if (!records) return records.failure();
  return mcap::survey_chunk(*records, chunk.offset);
}

}  // namespace robot::logging
