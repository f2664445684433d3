#include "robot/logging/mcap/format.h"

#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <limits>

#include "robot/logging/mcap/codec.h"

namespace robot::logging::mcap {
namespace {

// Each record's fields, once, in the order of the specification. Encoder and Decoder both use these lists.
template <class Codec, class Record>
using In = typename Codec::template Access<Record>;

template <class Codec>
void fields(Codec& see, In<Codec, Header>& record) {
  see.text("profile", record.profile);
  see.text("library", record.library);
}

template <class Codec>
void fields(Codec& see, In<Codec, Footer>& record) {
  see.number("summary start", record.summary_start);
  see.number("summary offset start", record.summary_offset_start);
  see.number("summary checksum", record.summary_crc);
}

template <class Codec>
void fields(Codec& see, In<Codec, Schema>& record) {
  see.number("id", record.id);
  see.text("name", record.name);
  see.text("encoding", record.encoding);
  see.text("data", record.data);
}

template <class Codec>
void fields(Codec& see, In<Codec, Channel>& record) {
  see.number("id", record.id);
  see.number("schema id", record.schema_id);
  see.text("topic", record.topic);
  see.text("message encoding", record.message_encoding);
  see.texts("metadata", record.metadata);
}

template <class Codec>
void fields(Codec& see, In<Codec, Message>& record) {
  see.number("channel id", record.channel_id);
  see.number("sequence", record.sequence);
  see.number("log time", record.log_time);
  see.number("publish time", record.publish_time);
  see.rest("data", record.data);
}

template <class Codec>
void fields(Codec& see, In<Codec, ChunkHead>& record) {
  see.number("start time", record.start_ns);
  see.number("end time", record.end_ns);
  see.number("uncompressed size", record.unpacked_bytes);
  see.number("uncompressed checksum", record.unpacked_crc);
  see.text("compression", record.compression);
  see.number("size of the records", record.packed_bytes);
}

template <class Codec>
void fields(Codec& see, In<Codec, MessageIndex>& record) {
  see.number("channel id", record.channel_id);
  see.numbers("entries", record.entries);
}

template <class Codec>
void fields(Codec& see, In<Codec, ChunkIndex>& record) {
  see.number("start time", record.start_ns);
  see.number("end time", record.end_ns);
  see.number("chunk offset", record.offset);
  see.number("chunk length", record.record_bytes);
  see.numbers("message index offsets", record.message_indexes);
  see.number("message index length", record.message_index_bytes);
  see.text("compression", record.compression);
  see.number("compressed size", record.packed_bytes);
  see.number("uncompressed size", record.unpacked_bytes);
}

template <class Codec>
void fields(Codec& see, In<Codec, Attachment>& record) {
  see.number("log time", record.log_time);
  see.number("create time", record.create_time);
  see.text("name", record.name);
  see.text("media type", record.media_type);
  see.long_bytes("data", record.data);
  see.number("checksum", record.crc);
}

template <class Codec>
void fields(Codec& see, In<Codec, AttachmentIndex>& record) {
  see.number("offset", record.offset);
  see.number("length", record.record_bytes);
  see.number("log time", record.log_time);
  see.number("create time", record.create_time);
  see.number("data size", record.data_bytes);
  see.text("name", record.name);
  see.text("media type", record.media_type);
}

template <class Codec>
void fields(Codec& see, In<Codec, Statistics>& record) {
  see.number("message count", record.messages);
  see.number("schema count", record.schemas);
  see.number("channel count", record.channels);
  see.number("attachment count", record.attachments);
  see.number("metadata count", record.metadata);
  see.number("chunk count", record.chunks);
  see.number("start time", record.start_ns);
  see.number("end time", record.end_ns);
  see.numbers("channel message counts", record.channel_messages);
}

template <class Codec>
void fields(Codec& see, In<Codec, Metadata>& record) {
  see.text("name", record.name);
  see.texts("metadata", record.entries);
}

template <class Codec>
void fields(Codec& see, In<Codec, MetadataIndex>& record) {
  see.number("offset", record.offset);
  see.number("length", record.record_bytes);
  see.text("name", record.name);
}

template <class Codec>
void fields(Codec& see, In<Codec, SummaryOffset>& record) {
  see.op("group opcode", record.group);
  see.number("group start", record.start);
  see.number("group length", record.length_bytes);
}

template <class Codec>
void fields(Codec& see, In<Codec, DataEnd>& record) {
  see.number("data checksum", record.data_crc);
}

}  // namespace

std::string name(Op op) {
  static constexpr const char* kNames[] = {"Header",        "Footer",          "Schema",       "Channel",
                                           "Message",       "Chunk",           "MessageIndex", "ChunkIndex",
                                           "Attachment",    "AttachmentIndex", "Statistics",   "Metadata",
                                           "MetadataIndex", "SummaryOffset",   "DataEnd"};
  const unsigned number = static_cast<unsigned>(op);
  if (number >= 1 && number <= std::size(kNames)) return kNames[number - 1];
  char text[16];
  std::snprintf(text, sizeof text, "record 0x%02x", number);
  return text;
}

template <class Record>
void append(std::string& out, const Record& record, std::uint64_t payload_bytes) {
  put(out, static_cast<std::uint8_t>(Record::kOp));
  put(out, std::uint64_t{0});
  const std::size_t begin = out.size();
  Encoder encoder(out);
  fields(encoder, record);

  const std::uint64_t length = out.size() - begin + payload_bytes;
  for (std::size_t i = 0; i < sizeof length; ++i) out[begin - sizeof length + i] = static_cast<char>(length >> (8 * i));
}

template <class Record>
Result<Record> decode(std::string_view content, std::uint64_t offset) {
  Record record;
  Decoder decoder(content);
  fields(decoder, record);
  if (decoder.wrong().empty()) return record;
  return Error{name(Record::kOp) + " at byte " + std::to_string(offset) + ": " + decoder.wrong()};
}

#define ROBOT_LOGGING_MCAP_RECORD(Record)                           \
  template void append(std::string&, const Record&, std::uint64_t); \
  template Result<Record> decode<Record>(std::string_view, std::uint64_t);
ROBOT_LOGGING_MCAP_RECORD(Header)
ROBOT_LOGGING_MCAP_RECORD(Footer)
ROBOT_LOGGING_MCAP_RECORD(Schema)
ROBOT_LOGGING_MCAP_RECORD(Channel)
ROBOT_LOGGING_MCAP_RECORD(Message)
ROBOT_LOGGING_MCAP_RECORD(ChunkHead)
ROBOT_LOGGING_MCAP_RECORD(MessageIndex)
ROBOT_LOGGING_MCAP_RECORD(ChunkIndex)
ROBOT_LOGGING_MCAP_RECORD(Attachment)
ROBOT_LOGGING_MCAP_RECORD(AttachmentIndex)
ROBOT_LOGGING_MCAP_RECORD(Statistics)
ROBOT_LOGGING_MCAP_RECORD(Metadata)
ROBOT_LOGGING_MCAP_RECORD(MetadataIndex)
ROBOT_LOGGING_MCAP_RECORD(SummaryOffset)
ROBOT_LOGGING_MCAP_RECORD(DataEnd)
#undef ROBOT_LOGGING_MCAP_RECORD

Result<RecordHead> decode_record_head(std::string_view bytes, std::uint64_t offset, std::uint64_t left) {
  const auto where = [offset] { return " at byte " + std::to_string(offset); };  // only for errors: records are many
  if (left < kRecordHeadBytes || bytes.size() < kRecordHeadBytes)
    return Error{"record" + where() + ": expected " + std::to_string(kRecordHeadBytes) + " bytes, " +
                 std::to_string(std::min<std::uint64_t>(left, bytes.size())) + " are left"};
  const RecordHead head{static_cast<Op>(bytes[0]), ByteReader(bytes.substr(1)).number<std::uint64_t>()};
  if (head.op == Op{0}) return Error{"record" + where() + ": expected an op from 1 on, got 0"};
  if (head.length > left - kRecordHeadBytes)
    return Error{name(head.op) + where() + ": expected " + std::to_string(head.length) + " bytes, " +
                 std::to_string(left - kRecordHeadBytes) + " are left"};
  return head;
}

Result<RecordView> take_record(std::string_view bytes, std::size_t& at, std::uint64_t base) {
  const std::string_view left = bytes.substr(std::min(at, bytes.size()));
  const Result<RecordHead> head = decode_record_head(left, base + at, left.size());
  if (!head) return head.failure();
  const RecordView record{head->op, base + at, left.substr(kRecordHeadBytes, static_cast<std::size_t>(head->length))};
  at += kRecordHeadBytes + record.content.size();
  return record;
}

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) {
  // zlib takes sizes as unsigned int
  constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
  uLong crc = before;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(kMost, bytes.size())))
    crc = ::crc32(crc, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(std::min(kMost, bytes.size())));
  return static_cast<std::uint32_t>(crc);
}

std::uint32_t crc32_of_both(std::uint32_t first, std::uint32_t second, std::uint64_t second_bytes) {
  return static_cast<std::uint32_t>(::crc32_combine(first, second, static_cast<z_off_t>(second_bytes)));
}

}  // namespace robot::logging::mcap
