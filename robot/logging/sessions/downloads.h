// Downloads of sessions: one MCAP file each, assembled on request.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/assembly.h"
#include "robot/logging/sessions/session.h"

namespace robot::logging {

/// The open downloads. It keeps the last kKept, because a viewer requests many ranges of the same one. Any thread.
class Downloads {
 public:
  /// The distance from now to the end of a live session's download [ns]. A chunk is written at most one second after
  /// its first message. The other second is for a slow disk or a late message.
  static constexpr std::uint64_t kLiveMarginNs = 2'000'000'000;

  /// Makes one more file for a download from the recorded ones.
  using Extend =
      std::function<Result<std::shared_ptr<const ByteSource>>(const std::shared_ptr<const Assembly>& recorded)>;

  /// Opens the whole of `session`, or its stream in the file `stream` ("14.2.ball.mcap"). With `extend`, its file is part
  /// of the download.
  Result<std::shared_ptr<const Assembly>> open(const Session& session, const std::optional<std::string>& stream,
                                               const AssemblyOptions& options, const Extend& extend = {});

 private:
  static constexpr std::size_t kKept = 4;

  struct Kept {
    std::string what;  // session, files with their sizes, range
    std::shared_ptr<const Assembly> assembly;
  };

  std::shared_ptr<const Assembly> kept(const std::string& what);

  Mutex lock_;
  std::list<Kept> kept_;  // the most recently used first
};

}  // namespace robot::logging
