// Sessions as they are sent away: one MCAP file each, put together when somebody asks.
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <string>

#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/assembly.h"
#include "robot/logging/sessions/session.h"

namespace robot::logging {

/// Opens downloads, and keeps the last few: a viewer asks for many ranges of the same one. Any thread.
class Downloads {
 public:
  /// How far back a download of a live session ends [ns]: chunks are written at most a second after their first message,
  /// and a slow disk or a late message has another second.
  static constexpr std::uint64_t kLiveMarginNs = 2'000'000'000;

  /// The whole of `session`, or its stream in the file `stream` ("14.2.ball.mcap").
  Result<std::shared_ptr<const Assembly>> open(const Session& session, const std::optional<std::string>& stream,
                                               const AssemblyOptions& options);

 private:
  static constexpr std::size_t kKept = 4;

  struct Kept {
    std::string what;  // session, files with their sizes, range
    std::shared_ptr<const Assembly> assembly;
  };

  std::shared_ptr<const Assembly> kept(const std::string& what);

  Mutex lock_;
  std::list<Kept> kept_;  // the one used last in front
};

}  // namespace robot::logging
