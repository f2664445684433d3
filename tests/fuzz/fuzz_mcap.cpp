// Any bytes, read in every way we read a recording: no crash, and the output stays within bounds.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "robot/logging/mcap/assembly.h"
#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/reader.h"

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto source = std::make_shared<robot::MemorySource>(bytes);
  read_all(source, 0);
  read_all(source, 20);

  // an assembled file can be read again
  auto assembly = assemble({source});
  if (!assembly) return 0;
  const auto assembled = std::make_shared<Assembly>(std::move(*assembly));
  require(bool(robot::read_bytes(*assembled, 0, assembled->size())));
  require(bool(read_index(*assembled)));
  read_all(assembled, 0);
  return 0;
}
