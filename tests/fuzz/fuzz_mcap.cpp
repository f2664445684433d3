// Any bytes, read in every way we read a recording: no crash, and the output stays within bounds.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robot/logging/mcap/assembly.h"
#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/ordered_reader.h"
#include "robot/logging/mcap/reader.h"
#include "robot/logging/mcap/time_span.h"
#include "robot/logging/mcap/topic_streams.h"

namespace {

using namespace robot::logging;

void require(bool holds) {
  if (!holds) std::abort();
}

/// Reads to the end, which must come.
std::size_t read_all(const std::shared_ptr<const robot::ByteSource>& source, std::uint64_t from_ns) {
  McapReader reader(source);
  if (from_ns > 0 && !reader.seek(from_ns)) return 0;
  std::size_t messages = 0;
  while (true) {
    const auto message = reader.next();
    if (!message) continue;
    if (!*message) break;
    require(reader.channels().contains((*message)->channel_id));
    require((*message)->record.capture_ns >= from_ns);
    ++messages;
  }
  require(reader.next() && !*reader.next());
  return messages;
}

/// Reads to the end, which must come. The messages are of described channels.
std::vector<McapMessage> all_of(OrderedReader& reader, const McapIndex& index) {
  std::vector<McapMessage> messages;
  while (true) {
    auto message = reader.next();
    if (!message) continue;
    if (!*message) return messages;
    require(index.channels.contains((*message)->channel_id));
    messages.push_back(std::move(**message));
  }
}

/// Reads the messages in the order of their times, from the start and from other times.
void read_ordered(const std::shared_ptr<const McapFile>& file) {
  const TimeSpan span = time_span(file->source(), file->index());
  require(span.start_ns <= span.end_ns);
  for (const TopicStream& stream : topic_streams(file->index())) require(!stream.channels.empty());
  OrderedReader whole(file), parts(file, {}, nullptr, /*open_bytes=*/0);
  const std::vector<McapMessage> messages = all_of(whole, file->index());
  require(all_of(parts, file->index()) == messages);
  for (const std::uint64_t time_ns : {std::uint64_t{0}, std::uint64_t{20}, span.end_ns}) {
    std::set<std::uint16_t> channels;
    for (const McapMessage& message : whole.newest_until(time_ns))
      require(message.record.capture_ns <= time_ns && channels.insert(message.channel_id).second);
    whole.seek(time_ns);
    for (const McapMessage& message : all_of(whole, file->index())) require(message.record.capture_ns >= time_ns);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto source = std::make_shared<robot::MemorySource>(bytes);
  read_all(source, 0);
  read_all(source, 20);
  if (const auto file = McapFile::open(source)) read_ordered(*file);

  // an assembled file can be read again
  auto assembly = assemble({source});
  if (!assembly) return 0;
  const auto assembled = std::make_shared<Assembly>(std::move(*assembly));
  require(bool(robot::read_bytes(*assembled, 0, assembled->size())));
  require(bool(read_index(*assembled)));
  read_all(assembled, 0);
  return 0;
}
