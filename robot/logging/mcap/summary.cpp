#include "robot/logging/mcap/summary.h"

#include <algorithm>
#include <utility>

namespace robot::logging::mcap {
namespace {

constexpr std::uint64_t kFooterBytes = kRecordHeadBytes + 8 + 8 + 4;
constexpr std::uint64_t kDataEndBytes = kRecordHeadBytes + 4;

/// The offsets of the parts of a file's end.
struct End {
  Footer footer;
  std::uint64_t footer_offset = 0, data_end = 0;
};

Result<Footer> read_footer(const ByteSource& source, std::uint64_t offset) {
  const Result<std::string> bytes = read_bytes(source, offset, kFooterBytes + kMagic.size());
  if (!bytes) return bytes.failure();
  const std::string_view view = *bytes;
  std::size_t at = 0;
  const Result<RecordView> record = take_record(view.substr(0, kFooterBytes), at, offset);
  if (view.substr(kFooterBytes) != kMagic || !record || record->op != Op::footer || at != kFooterBytes)
    return Error{"expected a Footer and the magic bytes at the end, from byte " + std::to_string(offset) +
                 " on: the file was cut or its writer interrupted"};
  return decode<Footer>(record->content, offset);
}

/// Reads the end of the file and verifies the order of its parts.
Result<End> read_end(const ByteSource& source) {
  constexpr std::uint64_t kLeast = kMagic.size() + kDataEndBytes + kFooterBytes + kMagic.size();
  if (source.size() < kLeast)
    return Error{"expected at least " + std::to_string(kLeast) + " bytes, the file has " +
                 std::to_string(source.size())};
  End end;
  end.footer_offset = source.size() - kMagic.size() - kFooterBytes;
  const Result<Footer> footer = read_footer(source, end.footer_offset);
  if (!footer) return footer.failure();
  end.footer = *footer;

  // the DataEnd record is directly before the summary
  const std::uint64_t start = footer->summary_start == 0 ? end.footer_offset : footer->summary_start;
  if (start < kMagic.size() + kDataEndBytes || start > end.footer_offset)
    return Error{"Footer: expected the summary before byte " + std::to_string(end.footer_offset) + ", got byte " +
                 std::to_string(start)};
  end.data_end = start - kDataEndBytes;
  const Result<std::string> bytes = read_bytes(source, end.data_end, kDataEndBytes);
  if (!bytes) return bytes.failure();
  std::size_t at = 0;
  const Result<RecordView> record = take_record(*bytes, at, end.data_end);
  if (!record || record->op != Op::data_end || at != kDataEndBytes)
    return Error{"expected a DataEnd before the summary, at byte " + std::to_string(end.data_end)};
  return end;
}

template <class Record>
Result<void> decode_into(std::vector<Record>& records, const RecordView& view) {
  Result<Record> record = decode<Record>(view.content, view.offset);
  if (!record) return record.failure();
  records.push_back(std::move(*record));
  return {};
}

Result<void> add(Summary& summary, const RecordView& view) {
  switch (view.op) {
    case Op::schema: return decode_into(summary.schemas, view);
    case Op::channel: return decode_into(summary.channels, view);
    case Op::metadata_index: return decode_into(summary.metadata_indexes, view);
    case Op::chunk_index: return decode_into(summary.chunk_indexes, view);
    case Op::statistics: {
      const Result<Statistics> statistics = decode<Statistics>(view.content, view.offset);
      if (!statistics) return statistics.failure();
      summary.statistics = *statistics;
      return {};
    }
    default: return {};
  }
}

/// Sorts the chunks by offset. Returns an Error if one exceeds the data or overlaps the next.
Result<void> order_chunks(Summary& summary) {
  auto& chunks = summary.chunk_indexes;
  std::sort(chunks.begin(), chunks.end(),
            [](const ChunkIndex& left, const ChunkIndex& right) { return left.offset < right.offset; });
  std::uint64_t free = kMagic.size();
  for (const ChunkIndex& chunk : chunks) {
    const std::uint64_t room = summary.data_end - std::min(chunk.offset, summary.data_end);
    const bool fits = chunk.offset >= free && chunk.record_bytes >= kRecordHeadBytes && chunk.record_bytes <= room &&
                      chunk.message_index_bytes <= room - chunk.record_bytes;
    if (!fits)
      return Error{"ChunkIndex: expected a chunk between byte " + std::to_string(free) + " and byte " +
                   std::to_string(summary.data_end) + ", got " + std::to_string(chunk.record_bytes) + " + " +
                   std::to_string(chunk.message_index_bytes) + " bytes from byte " + std::to_string(chunk.offset)};
    free = chunk.offset + chunk.record_bytes + chunk.message_index_bytes;
  }
  return {};
}

Result<Summary> decode_summary(std::string_view records, const End& end) {
  Summary summary;
  summary.data_end = end.data_end;
  for (std::size_t at = 0; at < records.size();) {
    const Result<RecordView> record = take_record(records, at, end.footer.summary_start);
    if (!record) return record.failure();
    if (const Result<void> added = add(summary, *record); !added) return added.failure();
  }
  if (const Result<void> ordered = order_chunks(summary); !ordered) return ordered.failure();
  return summary;
}

}  // namespace

std::string encode_end(const SummaryGroups& groups, std::uint64_t offset, std::uint32_t data_crc) {
  std::string out;
  append(out, DataEnd{data_crc});
  const std::size_t summary_begin = out.size();

  std::string offsets;
  const auto add_group = [&](Op op, const std::string& group) {
    if (group.empty()) return;
    append(offsets, SummaryOffset{op, offset + out.size(), group.size()});
    out += group;
  };
  add_group(Op::schema, groups.schemas);
  add_group(Op::channel, groups.channels);
  add_group(Op::statistics, groups.statistics);
  add_group(Op::metadata_index, groups.metadata_indexes);
  add_group(Op::chunk_index, groups.chunk_indexes);

  const Footer footer{offset + summary_begin, offset + out.size(), 0};
  out += offsets;
  append(out, footer);

  // the checksum is the footer's last field and covers all bytes of the summary before it
  out.resize(out.size() - sizeof footer.summary_crc);
  const std::uint32_t crc = crc32(std::string_view(out).substr(summary_begin));
  for (unsigned shift = 0; shift < 32; shift += 8) out.push_back(static_cast<char>(crc >> shift));
  return out.append(kMagic);
}

Result<std::optional<Summary>> read_summary(const ByteSource& source) {
  const Result<End> end = read_end(source);
  if (!end) return end.failure(source.name());
  const Footer& footer = end->footer;
  if (footer.summary_start == 0) return std::optional<Summary>();

  const std::uint64_t summary_bytes = end->footer_offset - footer.summary_start;
  if (summary_bytes > kMaxRecordBytes)
    return Error{source.name() + ": expected a summary of at most " + std::to_string(kMaxRecordBytes) + " bytes, got " +
                 std::to_string(summary_bytes)};
  constexpr std::uint64_t kCoveredFooterBytes = kFooterBytes - sizeof footer.summary_crc;
  const Result<std::string> bytes = read_bytes(source, footer.summary_start, summary_bytes + kCoveredFooterBytes);
  if (!bytes) return bytes.failure();
  if (footer.summary_crc != 0 && crc32(*bytes) != footer.summary_crc)
    return Error{source.name() + ": the summary at byte " + std::to_string(footer.summary_start) +
                 " is damaged: its checksum is wrong"};

  Result<Summary> summary =
      decode_summary(std::string_view(*bytes).substr(0, static_cast<std::size_t>(summary_bytes)), *end);
  if (!summary) return summary.failure(source.name());
  return std::optional<Summary>(std::move(*summary));
}

}  // namespace robot::logging::mcap
