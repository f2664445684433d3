// The records of an MCAP file, to bytes and back. A summary of https://mcap.dev/spec:
//
//   file    = magic Header record* DataEnd summary summary_offsets Footer magic
//   record  = op:u8 length:u64 content          all integers little endian; length counts the content
//   string  = length:u32 bytes                  map, array = bytes:u32 entry*
//
// Chunk, Message and Attachment carry many bytes. These are written and read separately from the other fields of their
// record, without a copy into it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/core/result.h"

namespace robot::logging::mcap {

inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
inline constexpr std::size_t kRecordHeadBytes = 9;  // op and length

/// The largest record or unpacked chunk that a reader takes into memory [bytes]. Our writers stay below it.
inline constexpr std::uint64_t kMaxRecordBytes = 64 << 20;

enum class Op : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0a,
  statistics = 0x0b,
  metadata = 0x0c,
  metadata_index = 0x0d,
  summary_offset = 0x0e,
  data_end = 0x0f,
};

/// Returns "Schema", "Chunk", …, or for example "record 0x2a" for an op that the specification does not define.
std::string name(Op op);

using Texts = std::map<std::string, std::string>;
template <class Key>
using Numbers = std::vector<std::pair<Key, std::uint64_t>>;  // a map or an array of pairs, in the order of the file

struct Header {
  static constexpr Op kOp = Op::header;
  std::string profile, library;
};

struct Footer {
  static constexpr Op kOp = Op::footer;
  std::uint64_t summary_start = 0;         // 0: no summary
  std::uint64_t summary_offset_start = 0;  // 0: none
  std::uint32_t summary_crc = 0;           // from summary_start up to this field; 0: not given
};

struct Schema {
  static constexpr Op kOp = Op::schema;
  std::uint16_t id = 0;  // never 0
  std::string name, encoding, data;
};

struct Channel {
  static constexpr Op kOp = Op::channel;
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;  // 0: no schema
  std::string topic, message_encoding;
  Texts metadata;
};

struct Message {
  static constexpr Op kOp = Op::message;
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;      // [ns since the epoch] in our files: the capture time
  std::uint64_t publish_time = 0;  // [ns since the epoch]
  std::string_view data;           // within the decoded bytes
};

/// The fields before the records of a chunk.
struct ChunkHead {
  static constexpr Op kOp = Op::chunk;
  std::uint64_t start_ns = 0, end_ns = 0;  // least and greatest log_time
  std::uint64_t unpacked_bytes = 0;
  std::uint32_t unpacked_crc = 0;  // 0: not given
  std::string compression;
  std::uint64_t packed_bytes = 0;  // of the records that follow

  /// Returns the size of this head within the content.
  std::size_t size_bytes() const { return 8 + 8 + 8 + 4 + 4 + compression.size() + 8; }
};

struct MessageIndex {
  static constexpr Op kOp = Op::message_index;
  std::uint16_t channel_id = 0;
  Numbers<std::uint64_t> entries;  // log_time, offset in the unpacked chunk
};

struct ChunkIndex {
  static constexpr Op kOp = Op::chunk_index;
  std::uint64_t start_ns = 0, end_ns = 0;
  std::uint64_t offset = 0;                // of the Chunk record in the file
  std::uint64_t record_bytes = 0;          // of the whole Chunk record
  Numbers<std::uint16_t> message_indexes;  // channel, offset of its MessageIndex in the file
  std::uint64_t message_index_bytes = 0;   // of all of them, directly after the chunk
  std::string compression;
  std::uint64_t packed_bytes = 0, unpacked_bytes = 0;
};

struct Attachment {
  static constexpr Op kOp = Op::attachment;
  std::uint64_t log_time = 0, create_time = 0;  // [ns since the epoch]
  std::string name, media_type;
  std::string_view data;  // within the decoded bytes
  std::uint32_t crc = 0;  // of all earlier fields; 0: not given
};

struct AttachmentIndex {
  static constexpr Op kOp = Op::attachment_index;
  std::uint64_t offset = 0, record_bytes = 0, log_time = 0, create_time = 0, data_bytes = 0;
  std::string name, media_type;
};

struct Statistics {
  static constexpr Op kOp = Op::statistics;
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0, attachments = 0, metadata = 0, chunks = 0;
  std::uint64_t start_ns = 0, end_ns = 0;   // 0 without messages
  Numbers<std::uint16_t> channel_messages;  // channel, messages; ascending
};

struct Metadata {
  static constexpr Op kOp = Op::metadata;
  std::string name;
  Texts entries;
};

struct MetadataIndex {
  static constexpr Op kOp = Op::metadata_index;
  std::uint64_t offset = 0, record_bytes = 0;
  std::string name;
};

struct SummaryOffset {
  static constexpr Op kOp = Op::summary_offset;
  Op group = Op::schema;
  std::uint64_t start = 0, length_bytes = 0;
};

struct DataEnd {
  static constexpr Op kOp = Op::data_end;
  std::uint32_t data_crc = 0;  // of the file up to this record; 0: not given
};

/// Appends one record of any of the types above to `out`. The caller appends `payload_bytes` more: the records of a
/// chunk, the data of a message.
template <class Record>
void append(std::string& out, const Record& record, std::uint64_t payload_bytes = 0);

/// Decodes the record in `content`. Ignores fields that later versions of the format add.
/// `offset` is the record's offset in its file or chunk, for the sentence of an Error.
template <class Record>
Result<Record> decode(std::string_view content, std::uint64_t offset);

struct RecordHead {
  Op op;
  std::uint64_t length;  // of the content
};

/// Decodes op and length from the first kRecordHeadBytes of `bytes`. `left` is the number of bytes from the record's
/// start at `offset` to the end of the data. Returns an Error if the record is longer, or has the forbidden op 0.
Result<RecordHead> decode_record_head(std::string_view bytes, std::uint64_t offset, std::uint64_t left);

/// A record in memory.
struct RecordView {
  Op op;
  std::uint64_t offset;  // of its first byte
  std::string_view content;
};

/// Returns the record at `at` in `bytes` and moves `at` to its end. `base` is the offset of `bytes` itself.
Result<RecordView> take_record(std::string_view bytes, std::size_t& at, std::uint64_t base = 0);

/// Returns zlib's CRC-32 of `bytes`, continued from the checksum `before` of the bytes that precede them.
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

/// Returns the CRC-32 of two consecutive runs of bytes from the checksum of each.
std::uint32_t crc32_of_both(std::uint32_t first, std::uint32_t second, std::uint64_t second_bytes);

}  // namespace robot::logging::mcap
