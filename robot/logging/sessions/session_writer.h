// The writer of a whole session without threads, for imported and synthetic recordings.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/compression.h"
#include "robot/logging/sessions/owned_folder.h"
#include "robot/logging/sessions/session.h"
#include "robot/logging/streams/file_provider.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// A session in writing, with one stream per topic. Used by one thread.
class SessionWriter {
 public:
  /// Creates the folder, owns it until close(), and begins the session. Returns an Error if the folder holds one already.
  static Result<std::unique_ptr<SessionWriter>> create(std::filesystem::path folder, SessionInfo info,
                                                       Compression compression = Compression::zstd);

  /// Writes one message. The first message of a topic begins its stream; later ones do not change its channel.
  /// Numbers the messages of a stream in the order of the calls.
  Result<void> write(const memory::ChannelInfo& info, std::uint64_t capture_ns, std::string_view bytes);

  /// Sets the description of the session, for session.json after close() and for streams that begin later.
  void describe(std::string about) { info_.about = std::move(about); }

  /// Closes all streams and the session.
  Result<void> close();

  const std::filesystem::path& folder() const { return folder_; }

 private:
  struct Stream {
    std::unique_ptr<memory::RawChannel> channel;
    std::unique_ptr<FileOutProvider> file;
  };

  SessionWriter(OwnedFolder owned, SessionInfo info, Compression compression)
      : folder_(owned.path()), owned_(std::move(owned)), info_(std::move(info)), compression_(compression) {}

  Result<Stream*> stream_of(const memory::ChannelInfo& info);

  const std::filesystem::path folder_;
  std::optional<OwnedFolder> owned_;
  SessionInfo info_;
  const Compression compression_;
  ManualClock clock_;  // an imported message enters memory at its capture time
  std::map<std::string, Stream> streams_;
};

/// Writes a session that `fill` fills. After an Error there is no session, unless the folder held one before.
Result<void> write_session(const std::filesystem::path& folder, SessionInfo info,
                           const std::function<Result<void>(SessionWriter&)>& fill);

}  // namespace robot::logging
