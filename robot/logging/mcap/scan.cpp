#include "robot/logging/mcap/scan.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "robot/logging/mcap/block_reader.h"
#include "robot/logging/mcap/piece.h"

namespace robot::logging {
namespace {

using mcap::Op;

constexpr std::uint64_t kChunkHeadBytes = 64;  // holds a ChunkHead with any compression we know
constexpr std::uint64_t kMessageHeadBytes = 2 + 4 + 8 + 8;
constexpr std::uint64_t kRunBytes = 1 << 20;  // of a run of messages outside chunks, unless one message is larger
constexpr std::uint64_t kMessageIndexHeadBytes = 2 + 4, kMessageIndexEntryBytes = 8 + 8;
constexpr std::size_t kMostSentences = 8;  // about damages

/// Returns the number of messages of a chunk with one channel, which the length of its message index gives.
mcap::Numbers<std::uint16_t> counted_by_length(const mcap::ChunkIndex& chunk) {
  constexpr std::uint64_t kHeadBytes = mcap::kRecordHeadBytes + kMessageIndexHeadBytes;
  if (chunk.message_indexes.size() != 1 || chunk.message_index_bytes < kHeadBytes) return {};
  return {{chunk.message_indexes[0].first, (chunk.message_index_bytes - kHeadBytes) / kMessageIndexEntryBytes}};
}

class Scan {
 public:
  Scan(const ByteSource& source, const mcap::Summary* summary) : source_(source), block_(source), summary_(summary) {}

  McapIndex run() {
    if (summary_) walk_between_chunks();
    if (!summary_) walk_to(source_.size());
    ends_run();
    std::erase_if(index_.chunks, [&](const ChunkInfo& chunk) { return is_refused(chunk); });
    summary_counts_ = summary_counts();
    std::vector<ChunkInfo> found;
    found.swap(index_.chunks);
    for (ChunkInfo& chunk : found)
      if (complete_chunk(chunk, /*last=*/&chunk == &found.back())) index_.chunks.push_back(std::move(chunk));
    count();
    if (damages_ > kMostSentences) index_.damage += "; more damages: " + std::to_string(damages_ - kMostSentences);
    return std::move(index_);
  }

 private:
  void walk_between_chunks() {
    for (const mcap::Schema& schema : summary_->schemas) index_.schemas.emplace(schema.id, schema);
    for (const mcap::Channel& channel : summary_->channels) index_.channels.emplace(channel.id, channel);
    for (const mcap::ChunkIndex& chunk : summary_->chunk_indexes) {
      walk_to(chunk.offset);
      ends_run();
      index_.chunks.push_back({chunk, counted_by_length(chunk)});
      at_ = chunk.offset + chunk.record_bytes + chunk.message_index_bytes;
    }
    walk_to(summary_->data_end);
    index_.complete = true;
  }

  /// Handles the records from `at_` up to `end`, or up to a record without a valid length.
  void walk_to(std::uint64_t end) {
    Result<bool> more = true;
    while (more && *more && (at_ < end || !summary_)) more = next_record(end);
    if (!more) note(more.error());
  }

  /// Handles the record at `at_`. Returns false at the end of the data.
  Result<bool> next_record(std::uint64_t end) {
    if (at_ == end)
      return Error{"ends at byte " + std::to_string(at_) + " without a DataEnd: its writer was interrupted"};
    const std::uint64_t left = end - at_;
    const auto bytes = block_.read(at_, std::min<std::uint64_t>(left, mcap::kRecordHeadBytes));
    if (!bytes) return bytes.failure();
    const auto head = mcap::decode_record_head(*bytes, at_, left);
    if (!head) return head.failure();
    if (head->op == Op::footer) return Error{"expected a DataEnd before the Footer at byte " + std::to_string(at_)};
    index_.complete = head->op == Op::data_end;
    if (index_.complete) return false;

    if (const Result<void> taken = take(head->op, head->length); !taken) note(taken.error());
    at_ += mcap::kRecordHeadBytes + head->length;
    return true;
  }

  Result<void> take(Op op, std::uint64_t length) {
    if (op != Op::message) ends_run();
    switch (op) {
      case Op::schema: return take_whole<mcap::Schema>(length, [&](auto& schema) { keep(index_.schemas, schema); });
      case Op::channel:
        return take_whole<mcap::Channel>(length, [&](auto& channel) { keep(index_.channels, channel); });
      case Op::metadata:
        return take_whole<mcap::Metadata>(length,
                                          [&](auto& metadata) { index_.metadata.push_back(std::move(metadata)); });
      case Op::chunk: return take_chunk(length);
      case Op::message_index: return take_message_index(length);
      case Op::message: return take_message(length);
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
    const auto content = block_.read(at_ + mcap::kRecordHeadBytes, std::min(length, most));
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
    summary_differs_ = true;
    return {};
  }

  Result<void> take_message_index(std::uint64_t length) {
    if (index_.chunks.empty()) return {};
    ChunkInfo& chunk = index_.chunks.back();
    mcap::ChunkIndex& place = chunk.index;
    // ignore a message index that does not follow its chunk
    if (at_ != place.offset + place.record_bytes + place.message_index_bytes) return {};
    if (length < kMessageIndexHeadBytes)
      return Error{"MessageIndex at byte " + std::to_string(at_) + ": expected at least 6 bytes"};
    const auto start = block_.read(at_ + mcap::kRecordHeadBytes, 2);
    if (!start) return start.failure();
    const auto low = static_cast<std::uint8_t>((*start)[0]), high = static_cast<std::uint8_t>((*start)[1]);
    const auto channel = static_cast<std::uint16_t>(low | high << 8);
    place.message_indexes.emplace_back(channel, at_);
    place.message_index_bytes += mcap::kRecordHeadBytes + length;
    chunk.messages.emplace_back(channel, (length - kMessageIndexHeadBytes) / kMessageIndexEntryBytes);
    return {};
  }

  /// Adds a message outside chunks to the present run.
  Result<void> take_message(std::uint64_t length) {
    const auto message = decode_start<mcap::Message>(length, kMessageHeadBytes);
    const bool too_large = length > mcap::kMaxRecordBytes - mcap::kRecordHeadBytes;
    if (!message || too_large) ends_run();
    if (!message) return message.failure();
    if (too_large)
      return Error{"Message at byte " + std::to_string(at_) + ": expected at most " +
                   std::to_string(mcap::kMaxRecordBytes) + " bytes, got " + std::to_string(length)};
    const std::uint64_t end = at_ + mcap::kRecordHeadBytes + length;
    if (in_run_ && end - index_.runs.back().index.offset > kRunBytes) ends_run();
    if (!in_run_) begin_run(message->log_time);
    ChunkInfo& run = index_.runs.back();
    run.index.start_ns = std::min(run.index.start_ns, message->log_time);
    run.index.end_ns = std::max(run.index.end_ns, message->log_time);
    run.index.record_bytes = run.index.unpacked_bytes = end - run.index.offset;
    ++run_messages_[message->channel_id];
    return {};
  }

  void begin_run(std::uint64_t time_ns) {
    ChunkInfo run{.index = {}, .messages = {}, .is_run = true};
    run.index.start_ns = run.index.end_ns = time_ns;
    run.index.offset = at_;
    index_.runs.push_back(std::move(run));
    in_run_ = true;
  }

  void ends_run() {
    if (!std::exchange(in_run_, false)) return;
    index_.runs.back().messages.assign(run_messages_.begin(), run_messages_.end());
    run_messages_.clear();
  }

  bool is_refused(const ChunkInfo& chunk) {
    const Result<void> allowed = fits_memory(chunk);
    if (allowed) return false;
    note(allowed.error());
    summary_differs_ = true;
    return true;
  }

  /// Completes the facts about a chunk. Returns false if it is damaged.
  bool complete_chunk(ChunkInfo& chunk, bool last) {
    const bool last_of_interrupted = last && !index_.complete;
    if (!last_of_interrupted && (summary_counts_ || tells_enough(chunk))) return true;
    const Result<void> looked = look_into(chunk);
    if (!looked) note(looked.error());
    return bool(looked);
  }

  /// Returns whether the summary has all facts that the chunks could give.
  bool summary_counts() const {
    if (!summary_ || !summary_->statistics || summary_differs_) return false;
    const mcap::Statistics& statistics = *summary_->statistics;
    std::uint64_t in_channels = 0, known = 0;
    for (const auto& [channel, count] : statistics.channel_messages) in_channels += count;
    for (const ChunkInfo& chunk : index_.chunks)
      for (const auto& [channel, count] : chunk.messages) known += count;
    return in_channels == statistics.messages && known <= statistics.messages &&
           statistics.chunks == summary_->chunk_indexes.size() && statistics.channels == summary_->channels.size() &&
           statistics.schemas == summary_->schemas.size();
  }

  /// Counts a chunk by its message indexes. Returns false if they are missing or leave a channel undescribed.
  bool tells_enough(ChunkInfo& chunk) {
    if (chunk.messages.empty() && !chunk.index.message_indexes.empty()) {
      auto counts = count_messages(source_, chunk);
      if (counts) chunk.messages = std::move(*counts);
    }
    return !chunk.messages.empty() && std::ranges::all_of(chunk.messages, [&](const auto& entry) {
      const auto channel = index_.channels.find(entry.first);
      if (channel == index_.channels.end()) return false;
      // a schema that an earlier chunk with this channel lacked will not come
      return channel->second.schema_id == 0 || index_.schemas.contains(channel->second.schema_id) ||
             looked_for_.contains(entry.first);
    });
  }

  /// Completes the facts about a chunk from its messages. Discards message indexes that do not match them.
  Result<void> look_into(ChunkInfo& chunk) {
    auto contents = read_chunk(source_, chunk.index);
    if (!contents) return contents.failure();
    if (!contents->damage.empty()) note(contents->damage);
    for (mcap::Schema& schema : contents->schemas) keep(index_.schemas, schema);
    for (mcap::Channel& channel : contents->channels) keep(index_.channels, channel);

    mcap::Numbers<std::uint16_t> messages;
    for (const auto& [channel, index] : contents->indexes) {
      messages.emplace_back(channel, index.entries.size());
      looked_for_.insert(channel);
    }
    std::sort(chunk.messages.begin(), chunk.messages.end());
    if (chunk.messages != messages) chunk.index.message_indexes.clear(), chunk.index.message_index_bytes = 0;
    chunk.messages = std::move(messages);
    return {};
  }

  void count() {
    mcap::Statistics& statistics = index_.statistics;
    if (summary_counts_) {
      statistics = *summary_->statistics;
    } else {
      std::vector<ChunkInfo> all = index_.chunks;
      all.insert(all.end(), index_.runs.begin(), index_.runs.end());
      statistics = statistics_of(all);
    }
    statistics.chunks = static_cast<std::uint32_t>(index_.chunks.size());
    statistics.schemas = static_cast<std::uint16_t>(index_.schemas.size());
    statistics.channels = static_cast<std::uint32_t>(index_.channels.size());
    statistics.metadata = static_cast<std::uint32_t>(index_.metadata.size());
    index_.unchunked_messages = statistics_of(index_.runs).messages;
    for (const auto& [channel, messages] : statistics.channel_messages)
      if (!index_.channels.contains(channel))
        note("channel " + std::to_string(channel) + " is not described: " + std::to_string(messages) +
             " messages are left out");
  }

  void note(const std::string& sentence) {
    if (++damages_ > kMostSentences) return;
    index_.damage += (index_.damage.empty() ? source_.name() + ": " : "; ") + sentence;
  }

  const ByteSource& source_;
  BlockReader block_;
  const mcap::Summary* const summary_;
  bool summary_differs_ = false;  // it lacks a chunk of the data, or has one that is refused
  bool summary_counts_ = false;   // see summary_counts()
  std::uint64_t at_ = mcap::kMagic.size();
  bool in_run_ = false;                                  // the last run goes on
  std::map<std::uint16_t, std::uint64_t> run_messages_;  // of the last run, by channel
  std::set<std::uint16_t> looked_for_;                   // channels of the chunks that were unpacked
  std::size_t damages_ = 0;
  McapIndex index_;
};

}  // namespace

McapIndex scan(const ByteSource& source, const mcap::Summary* summary) { return Scan(source, summary).run(); }

}  // namespace robot::logging
