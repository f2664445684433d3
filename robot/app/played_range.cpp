#include "robot/app/played_range.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "robot/core/byte_sink.h"
#include "robot/logging/mcap/compression.h"
#include "robot/logging/mcap/writer.h"

namespace robot::app {
namespace {

constexpr std::uint64_t kMostBytes = 8 << 20;

/// Writes the messages of `stream` in the requested range, up to kMostBytes. Returns the time up to which it is
/// complete.
Result<std::uint64_t> copy_range(logging::InProvider& stream, const net::PlayedRequest& request,
                                 logging::McapWriter& writer) {
  std::uint64_t bytes = 0, last_ns = request.from_ns;
  while (true) {
    auto record = stream.read();
    if (!record) continue;  // damaged records are skipped; the parser has reported them
    if (!*record || (*record)->capture_ns > request.to_ns) return request.to_ns;
    const logging::Record& message = **record;
    if (message.capture_ns < request.from_ns) continue;
    // messages of one time stay together, because the next request begins after that time
    if (bytes > kMostBytes && message.capture_ns > last_ns) return message.capture_ns - 1;
    const logging::OutMessage copy{.sequence = message.sequence,
                                   .capture_ns = message.capture_ns,
                                   .publish_ns = message.publish_ns,
                                   .bytes = message.bytes};
    const Result<void> written = writer.write(0, copy, 0);
    if (!written) return written.failure();
    bytes += message.bytes.size();
    last_ns = std::max(last_ns, message.capture_ns);
  }
}

}  // namespace

net::HttpResponse played_range(const body::Replay& replay, const net::PlayedRequest& request) {
  const auto stream = replay.stream_of(request.topic);
  if (!stream) return net::error_response(404, "topic '" + request.topic + "' is not played");
  const auto info = stream->open();
  if (!info) return net::error_response(404, info.error());
  // 1 ns earlier, because a seek finds the last of several messages of one time; a stream begins with those of time 0
  if (request.from_ns > 0)
    if (const Result<void> sought = stream->seek(request.from_ns - 1); !sought)
      return net::error_response(500, sought.error());
  std::string file;
  auto writer = logging::McapWriter::open(std::make_unique<MemorySink>(file), {&*info, 1},
                                          {.metadata = {}, .compression = logging::Compression::lz4});
  if (!writer) return net::error_response(500, writer.error());
  const Result<std::uint64_t> until_ns = copy_range(*stream, request, *writer);
  const Result<void> closed = writer->close();
  if (!until_ns || !closed) return net::error_response(500, until_ns ? closed.error() : until_ns.error());
  net::HttpResponse response = net::text_response(200, "application/octet-stream", std::move(file));
  response.headers.emplace_back(net::kPlayedUntil, std::to_string(*until_ns));
  return response;
}

}  // namespace robot::app
