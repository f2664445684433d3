// A whole session written at once, without threads: imported and synthetic recordings.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/compression.h"
#include "robot/logging/sessions/session.h"
#include "robot/logging/streams/file_provider.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// Writes messages as they come into one stream per topic. Used by one thread.
class SessionWriter {
 public:
  /// Makes the folder and begins the session; an Error if there is one already.
  static Result<std::unique_ptr<SessionWriter>> create(std::filesystem::path folder, SessionInfo info,
                                                       Compression compression = Compression::zstd);

  /// Writes one message; a topic's first one begins its stream, and its channel stays as it was announced then.
  /// Messages of a stream are numbered as they come.
  Result<void> write(const memory::ChannelInfo& info, std::uint64_t capture_ns, std::string_view bytes);

  /// Ends all streams and the session in good order.
  Result<void> close();

  const std::filesystem::path& folder() const { return folder_; }

 private:
  struct Stream {
    std::unique_ptr<memory::RawChannel> channel;
    std::unique_ptr<FileOutProvider> file;
  };

  SessionWriter(std::filesystem::path folder, SessionInfo info, Compression compression)
      : folder_(std::move(folder)), info_(std::move(info)), compression_(compression) {}

  Result<Stream*> stream_of(const memory::ChannelInfo& info);

  const std::filesystem::path folder_;
  SessionInfo info_;
  const Compression compression_;
  ManualClock clock_;  // what is imported enters memory when it was captured
  std::map<std::string, Stream> streams_;
};

}  // namespace robot::logging
