// The facts about a session: in each of its MCAP files, and for people in the file session.json.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/logging/mcap/format.h"
#include "robot/logging/mcap/writer.h"

namespace robot::logging {

inline constexpr std::size_t kMaxSessionJsonBytes = 1 << 20;  // of a session.json that is read

/// The account of a session: each version that a recorder had to record in it is counted once.
struct SessionAccount {
  std::uint64_t messages = 0;  // in the files of the session
  std::uint64_t dropped = 0;   // lost; also those between the previous session of the same request and this one

  bool operator==(const SessionAccount&) const = default;
};

/// The facts about a session. The file `session.json` in its folder holds them.
struct SessionInfo {
  std::string name;   // from a person; may be empty
  std::string about;  // from the recording program, such as the error of a calibration; may be empty
  std::string robot;  // "14/2"
  int team = 0, player = 0;
  std::string build;                      // of the recording program
  std::string profile;                    // "game", "vision", "full", or "import"
  std::string rules;                      // of the game, which give its field, such as "spl2025"; empty: unknown
  std::vector<std::string> only;          // objects that a person chose, such as "ball"; empty: all
  std::uint64_t start_ns = 0;             // [ns since the epoch]
  std::int64_t behind_ns = 0;             // [ns] of its times behind the time of day; 0: less than a second, or unknown
  std::uint64_t number = 0;               // counts the sessions of a log folder from 1; 0: not recorded by a robot
  std::string boot;                       // identity of the boot in which it was recorded; empty: unknown
  bool kept = false;                      // never deleted to make room
  bool complete = false;                  // its writer closed it
  std::optional<SessionAccount> account;  // set at the end of a session that a recorder wrote

  bool operator==(const SessionInfo&) const = default;
};

/// Returns when the session began by the time of day [ns since the epoch].
inline std::uint64_t time_of_day_ns(const SessionInfo& info) {
  return info.start_ns + static_cast<std::uint64_t>(info.behind_ns);
}

/// Converts to the text of `session.json`.
std::string to_json(const SessionInfo& info);

/// Converts the text of `session.json`. `about`, `rules`, `only`, `behind_ns`, `number`, `boot`, `messages`
/// and `dropped` may be missing.
Result<SessionInfo> parse_session_info(std::string_view json);

/// Takes those facts from the text of a `session.json` that can be read, and leaves the others in `info` as they are.
/// Returns the first fault as an Error.
Result<void> take_session_info(std::string_view json, SessionInfo& info);

/// Returns the same facts as metadata records for each stream, so that a single downloaded file still names its origin.
/// They leave out `kept`, `complete` and `account`, which change later.
MetadataByName metadata_of(const SessionInfo& info);

/// Returns the facts in the metadata of a file, or nothing if it was not recorded as part of a session.
std::optional<SessionInfo> session_info_in(const std::vector<mcap::Metadata>& metadata);

}  // namespace robot::logging
