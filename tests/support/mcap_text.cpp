#include "tests/support/mcap_text.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "robot/logging/mcap/reader.h"

namespace tests {

using namespace robot::logging;
using robot::Error;
using robot::Result;

Result<void> DiskSink::append(std::span<const std::string_view> pieces) {
  for (const std::string_view piece : pieces) {
    const std::uint64_t free = disk_.room - std::min<std::uint64_t>(disk_.room, disk_.bytes.size());
    disk_.bytes += piece.substr(0, free);
    if (piece.size() > free) return Error{"cannot write disk: no room"};
  }
  return {};
}

Result<void> DiskSink::truncate(std::uint64_t size) {
  if (!disk_.can_truncate) return Error{"cannot cut disk"};
  disk_.bytes.resize(size);
  return {};
}

robot::memory::ChannelInfo word_channel(const std::string& topic) {
  return {topic, "protobuf", {"foresight.Word", "protobuf", "schema of a word"}, robot::memory::Delivery::reliable};
}

McapWriter writer_to(Disk& disk, const McapOptions& options, const std::string& topic) {
  const robot::memory::ChannelInfo channel = word_channel(topic);
  Result<McapWriter> writer = McapWriter::open(std::make_unique<DiskSink>(disk), {&channel, 1}, options);
  if (!writer) std::fprintf(stderr, "%s\n", writer.error().c_str()), std::abort();
  return std::move(*writer);
}

OutMessage word(std::string_view word, std::uint64_t capture_ns) {
  return {capture_ns, capture_ns, capture_ns + 1, word};
}

McapText::McapText(std::string_view text, const McapOptions& options, bool finished) {
  Disk disk;
  McapWriter writer = writer_to(disk, options);
  std::istringstream words{std::string(text)};
  std::uint64_t capture_ns = 10;
  const auto end_chunk = [&] {
    chunks_.push_back(disk.bytes.size());
    if (!writer.flush()) std::abort();
  };
  for (std::string next; words >> next;) {
    if (next == "|") {
      end_chunk();
      continue;
    }
    if (!writer.write(0, word(next, capture_ns), 0)) std::abort();
    capture_ns += 10;
  }
  if (writer.flush_due_ns() != McapWriter::kNever) end_chunk();
  if (finished && !writer.close()) std::abort();
  bytes = disk.bytes;
}

void McapText::increment_byte(std::uint64_t offset, int delta) {
  bytes[offset] = static_cast<char>(static_cast<unsigned char>(bytes[offset]) + delta);
}

void McapText::fix_chunk_crcs() {
  for (const std::uint64_t chunk : chunks_) {
    std::size_t at = chunk;
    const auto record = mcap::take_record(bytes, at);
    auto head = mcap::decode<mcap::ChunkHead>(record->content, chunk);
    head->unpacked_crc = mcap::crc32(record->content.substr(head->size_bytes(), head->packed_bytes));
    std::string fixed;
    mcap::append(fixed, *head, head->packed_bytes);
    bytes.replace(chunk, fixed.size(), fixed);
  }
}

std::shared_ptr<const robot::ByteSource> McapText::source() const {
  return std::make_shared<robot::MemorySource>(bytes);
}

std::string words_of(std::shared_ptr<const robot::ByteSource> source, std::vector<std::string>* damages) {
  McapReader reader(std::move(source));
  std::string words;
  while (true) {
    const auto message = reader.next();
    if (message && !*message) return words;
    if (!words.empty()) words += ' ';
    words += message ? (*message)->record.bytes : "!";
    if (!message && damages) damages->push_back(message.error());
  }
}

std::string all_bytes(const robot::ByteSource& source) { return *robot::read_bytes(source, 0, source.size()); }

}  // namespace tests
