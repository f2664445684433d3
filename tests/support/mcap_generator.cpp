#include "tests/support/mcap_generator.h"

#include <zlib.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string_view>
#include <utility>

#include "tests/support/foreign_frames.h"
#include "tests/support/mcap_bytes.h"

namespace tests {
namespace {

constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
constexpr std::uint64_t kNow = 1'764'000'000'000'000'000;  // in 2025
constexpr std::uint64_t kFar = std::uint64_t{1} << 63;     // in 2262
constexpr std::uint64_t kTooLarge = 3'000'000'000;         // bytes of a chunk

enum Op : unsigned {
  kHeader = 1,
  kFooter,
  kSchema,
  kChannel,
  kMessage,
  kChunk,
  kMessageIndex,
  kChunkIndex,
  kAttachment,
  kAttachmentIndex,
  kStatistics,
  kMetadata,
  kMetadataIndex,
  kSummaryOffset,
  kDataEnd
};

std::uint32_t crc_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

struct Described {
  std::uint16_t id, schema;  // schema 0: none
  std::string topic, encoding;
  bool damaged = false;
};

/// A written chunk, for its index.
struct Written {
  std::uint64_t start_ns = 0, end_ns = 0, offset = 0, bytes = 0, index_bytes = 0, packed = 0, unpacked = 0;
  std::string compression;
  std::map<std::uint16_t, std::uint64_t> indexes;
};

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : random_(seed) {}

  GeneratedMcap run() {
    choose();
    describe();
    file_.raw(kMagic).record(kHeader, McapBytes().text(one_in(2) ? "" : "x-profile").text("somebody else"));
    if (!inside_ || !chunked_) write_descriptions(file_);
    write_parts();
    write_end();
    made_.bytes = file_.bytes();
    std::ranges::stable_sort(made_.messages, {}, &GeneratedMessage::log_ns);
    return std::move(made_);
  }

 private:
  bool one_in(unsigned n) { return random_() % n == 0; }
  std::uint64_t below(std::uint64_t n) { return random_() % n; }

  /// Makes a choice that people can read.
  bool chosen(unsigned n, const char* name) {
    const bool taken = one_in(n);
    if (taken) made_.features += (made_.features.empty() ? "" : ", ") + std::string(name);
    return taken;
  }

  void choose() {
    chunked_ = !chosen(5, "no chunks");
    loose_ = chunked_ && chosen(6, "messages between the chunks");
    inside_ = chunked_ && !loose_ && chosen(3, "channels described in the chunks");
    summary_ = !chosen(4, "no summary");
    statistics_ = !chosen(4, "no statistics");
    repeats_channels_ = !chosen(4, "channels not repeated");
    repeats_schemas_ = !chosen(4, "schemas not repeated");
    chunk_indexes_ = !chosen(4, "no chunk indexes");
    message_indexes_ = !chosen(3, "no message indexes");
    checksums_ = !chosen(3, "no checksums");
    unordered_ = chosen(3, "unordered");
    overlapping_ = chosen(3, "overlapping chunks");
    one_time_ = chosen(8, "one time for all");
    strays_ = chosen(6, "stray times");
    damages_ = chosen(6, "damaged records");
    early_ = chosen(8, "in 1970");
    if (chosen(10, "at 2^63")) base_ns_ = kFar;
    if (early_) base_ns_ = one_in(2) ? 0 : 5'000'000'000;
  }

  void describe() {
    const std::uint64_t topics = chosen(25, "1000 topics") ? 1000 : 1 + below(8);
    const bool twins = chosen(4, "several channels of a topic");
    for (std::uint16_t id = 1; id <= 3; ++id)
      schemas_[id] = {"theirs.Kind" + std::to_string(id), one_in(2) ? "jsonschema" : "protobuf"};
    std::uint16_t id = static_cast<std::uint16_t>(below(3));
    for (std::uint64_t i = 0; i < topics; ++i) {
      const std::string topic = "/topic/" + std::to_string(i);
      for (std::uint64_t kind = 0; kind < (twins && one_in(2) ? 2 + below(2) : 1); ++kind)
        channels_.push_back({id++, static_cast<std::uint16_t>(below(4)), topic, one_in(2) ? "json" : "protobuf"});
    }
    // a channel without a readable description; nobody else describes it again
    if (damages_ && one_in(2)) {
      channels_.back().damaged = true;
      inside_ = repeats_channels_ = false;
    }
    damaged_schema_ = damages_ && one_in(2) ? 1 : 0;
    if (damages_) made_.is_valid = false;
  }

  /// A record that claims one byte more than it has.
  static McapBytes damaged(unsigned id) { return McapBytes().u16(id).u16(0).u32(99).raw("x"); }

  void write_schema(McapBytes& out, std::uint16_t id) {
    if (id == damaged_schema_) {
      out.record(kSchema, McapBytes().u16(id).u32(99).raw("x"));
      return;
    }
    const auto& [name, encoding] = schemas_.at(id);
    out.record(kSchema, McapBytes().u16(id).text(name).text(encoding).text("{}"));
  }

  void write_channel(McapBytes& out, const Described& channel) {
    if (channel.damaged) {
      out.record(kChannel, damaged(channel.id));
      return;
    }
    out.record(kChannel, McapBytes()
                             .u16(channel.id)
                             .u16(channel.schema)
                             .text(channel.topic)
                             .text(channel.encoding)
                             .texts({{"from", "elsewhere"}}));
  }

  void write_descriptions(McapBytes& out) {
    for (const auto& [id, schema] : schemas_) write_schema(out, id);
    for (const Described& channel : channels_) write_channel(out, channel);
  }

  std::uint64_t next_time() {
    if (one_time_) return base_ns_ + 7;
    clock_ns_ += below(3) * 1'000'000;
    if (strays_ && one_in(30)) return one_in(2) ? below(3) : kFar + below(3);
    return base_ns_ + clock_ns_ + (unordered_ ? below(50'000'000) : 0);
  }

  GeneratedMessage next_message() {
    const Described& channel = channels_[below(channels_.size())];
    GeneratedMessage message{
        .channel = channel.id, .sequence = ++sequence_, .log_ns = next_time(), .publish_ns = 0, .data = ""};
    message.publish_ns = message.log_ns + below(5);
    message.data.assign(one_in(20) ? below(20'000) : below(60), static_cast<char>('a' + below(26)));
    if (!message.data.empty()) message.data[below(message.data.size())] = static_cast<char>(random_());
    return message;
  }

  /// Notes a message that is written, as readers must find it.
  void expect(const GeneratedMessage& message, bool refused = false) {
    ++count_[message.channel];
    const auto of = std::ranges::find(channels_, message.channel, &Described::id);
    if (refused || of->damaged)
      ++made_.unreadable;
    else
      made_.messages.push_back(message);
    first_ns_ = total_ == 0 ? message.log_ns : std::min(first_ns_, message.log_ns);
    last_ns_ = std::max(last_ns_, message.log_ns);
    ++total_;
  }

  static void write_message(McapBytes& out, const GeneratedMessage& message) {
    out.record(kMessage, McapBytes()
                             .u16(message.channel)
                             .u32(message.sequence)
                             .u64(message.log_ns)
                             .u64(message.publish_ns)
                             .raw(message.data));
  }

  void write_parts() {
    const std::uint64_t parts = one_in(12) ? 0 : 1 + below(6);
    for (std::uint64_t i = 0; i < parts; ++i) {
      write_others();
      if (overlapping_) clock_ns_ = below(100) * 1'000'000;
      if (chunked_) write_chunk();
      if (!chunked_ || (loose_ && one_in(2))) write_loose();
    }
    write_others();
  }

  void write_loose() {
    for (std::uint64_t n = below(40); n > 0; --n) {
      const GeneratedMessage message = next_message();
      write_message(file_, message);
      expect(message);
      if (one_in(20)) write_others();
    }
  }

  /// Writes records that carry no message.
  void write_others() {
    if (one_in(4)) file_.record(0x80 + static_cast<unsigned>(below(100)), McapBytes().raw(std::string(below(30), 'u')));
    if (one_in(4)) file_.record(kMetadata, McapBytes().text("theirs").texts({{"key", "value"}}));
    if (damages_ && one_in(2)) file_.record(kMetadata, McapBytes().text("theirs").u32(99).raw("x"));
    if (!one_in(4)) return;
    const McapBytes fields = McapBytes().u64(1).u64(2).text("file.txt").text("text/plain").u64(3).raw("abc");
    file_.record(kAttachment, McapBytes(fields).u32(checksums_ ? crc_of(fields.bytes()) : 0));
  }

  void write_chunk() {
    McapBytes records;
    std::map<std::uint16_t, McapBytes> indexes;
    std::vector<GeneratedMessage> messages;
    std::set<std::uint16_t> described;
    Written chunk;
    const std::uint64_t count = one_in(8) ? 0 : below(60);
    for (std::uint64_t n = 0; n < count; ++n) {
      const GeneratedMessage message = next_message();
      if (inside_ && described.insert(message.channel).second) {
        const auto channel = std::ranges::find(channels_, message.channel, &Described::id);
        if (channel->schema != 0) write_schema(records, channel->schema);
        write_channel(records, *channel);
      }
      indexes[message.channel].u64(message.log_ns).u64(records.size());
      write_message(records, message);
      if (one_in(40)) records.record(0x90, McapBytes().raw("unknown"));
      chunk.start_ns = n == 0 ? message.log_ns : std::min(chunk.start_ns, message.log_ns);
      chunk.end_ns = std::max(chunk.end_ns, message.log_ns);
      messages.push_back(message);
    }
    const bool refused = damages_ && !inside_ && one_in(4);
    const std::string packed = pack(records.bytes(), chunk.compression, refused);
    for (const GeneratedMessage& message : messages) expect(message, refused);

    chunk.offset = file_.size();
    chunk.unpacked = refused ? kTooLarge : records.size();
    chunk.packed = packed.size();
    file_.record(kChunk, McapBytes()
                             .u64(chunk.start_ns)
                             .u64(chunk.end_ns)
                             .u64(chunk.unpacked)
                             .u32(checksums_ ? crc_of(records.bytes()) : 0)
                             .text(chunk.compression)
                             .u64(packed.size())
                             .raw(packed));
    chunk.bytes = file_.size() - chunk.offset;
    for (const auto& [channel, entries] : indexes) {
      if (!message_indexes_) break;
      chunk.indexes[channel] = file_.size();
      file_.record(kMessageIndex, McapBytes().u16(channel).text(entries.bytes()));
    }
    chunk.index_bytes = file_.size() - chunk.offset - chunk.bytes;
    chunks_.push_back(std::move(chunk));
  }

  /// Compresses the records of a chunk in any way, or not at all.
  std::string pack(const std::string& records, std::string& compression, bool must_expand) {
    const std::uint64_t kind = must_expand ? 1 + below(2) : below(3);
    if (kind == 0) return records;
    compression = kind == 1 ? "lz4" : "zstd";
    const FrameOptions options{.compression = compression,
                               .level = static_cast<int>(kind == 1 ? below(13) : 1 + below(one_in(10) ? 22 : 9)),
                               .frames = one_in(2) ? 1 : 1 + static_cast<int>(below(4)),
                               .skippable = one_in(3),
                               .content_size = !one_in(3),
                               .checksum = one_in(2)};
    return foreign_frames(records, options, random_);
  }

  void write_end() {
    file_.record(kDataEnd, McapBytes().u32(checksums_ ? crc_of(file_.bytes()) : 0));
    const std::uint64_t start = file_.size();
    McapBytes summary;
    if (summary_) write_summary(summary);
    const bool has = summary.size() > 0;
    McapBytes footer = McapBytes().u8(kFooter).u64(20).u64(has ? start : 0).u64(0);
    const std::uint32_t crc = has && checksums_ ? crc_of(summary.bytes() + footer.bytes()) : 0;
    file_.raw(summary.bytes()).raw(footer.bytes()).u32(crc).raw(kMagic);
  }

  void write_summary(McapBytes& out) {
    if (repeats_schemas_)
      for (const auto& [id, schema] : schemas_) write_schema(out, id);
    if (repeats_channels_)
      for (const Described& channel : channels_) write_channel(out, channel);
    if (statistics_) {
      McapBytes counts;
      for (const auto& [channel, count] : count_) counts.u16(channel).u64(count);
      out.record(kStatistics, McapBytes()
                                  .u64(total_)
                                  .u16(static_cast<unsigned>(schemas_.size()))
                                  .u32(channels_.size())
                                  .u32(0)
                                  .u32(0)
                                  .u32(chunks_.size())
                                  .u64(first_ns_)
                                  .u64(last_ns_)
                                  .text(counts.bytes()));
    }
    for (const Written& chunk : chunks_) {
      if (!chunk_indexes_) break;
      McapBytes offsets;
      for (const auto& [channel, offset] : chunk.indexes) offsets.u16(channel).u64(offset);
      out.record(kChunkIndex, McapBytes()
                                  .u64(chunk.start_ns)
                                  .u64(chunk.end_ns)
                                  .u64(chunk.offset)
                                  .u64(chunk.bytes)
                                  .text(offsets.bytes())
                                  .u64(chunk.index_bytes)
                                  .text(chunk.compression)
                                  .u64(chunk.packed)
                                  .u64(chunk.unpacked));
    }
  }

  std::mt19937 random_;
  GeneratedMcap made_;
  McapBytes file_;

  bool chunked_ = true, loose_ = false, inside_ = false, summary_ = true, statistics_ = true;
  bool repeats_channels_ = true, repeats_schemas_ = true, chunk_indexes_ = true, message_indexes_ = true;
  bool checksums_ = true, unordered_ = false, overlapping_ = false, one_time_ = false, strays_ = false;
  bool damages_ = false, early_ = false;
  std::uint64_t base_ns_ = kNow;

  std::map<std::uint16_t, std::pair<std::string, std::string>> schemas_;  // name, encoding
  std::vector<Described> channels_;
  std::uint16_t damaged_schema_ = 0;  // 0: none

  std::uint64_t clock_ns_ = 0;
  std::uint32_t sequence_ = 0;
  std::map<std::uint16_t, std::uint64_t> count_;
  std::uint64_t total_ = 0, first_ns_ = 0, last_ns_ = 0;
  std::vector<Written> chunks_;
};

}  // namespace

GeneratedMcap generate_mcap(std::uint32_t seed) { return Generator(seed).run(); }

}  // namespace tests
