// What the server asks the program it is part of.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/net/http/http.h"

namespace robot::net {

/// What `GET /logs/…` asks for. Times are capture times [ns since the epoch].
struct LogRequest {
  std::string session;                          // a safe name: no separators, no leading dot
  std::optional<std::string> file;              // a file as it lies on the disk, likewise; then the rest is empty
  std::optional<std::string> stream;            // one stream's file name without ".mcap"; nothing: the whole session
  std::optional<std::uint64_t> from_ns, to_ns;  // only the chunks that overlap this range
  std::optional<std::uint64_t> until_ns;        // of a live session: what was recorded up to then
};

/// The answer: a file to send, or where to look.
struct LogFile {
  std::shared_ptr<const ByteSource> body;
  std::string etag;                                // without quotes
  std::optional<std::uint64_t> redirect_until_ns;  // the session is live: ask again with this `until`; no body then
};

/// What `GET /api/played` asks for: a part of one topic of the recording that is played.
struct PlayedRequest {
  std::string topic;                                                             // "/14/2/ball"
  std::uint64_t from_ns = 0, to_ns = std::numeric_limits<std::uint64_t>::max();  // capture times, both included
};

/// Until when the answer to a PlayedRequest reaches [ns since the epoch]; the rest is to be asked for.
inline constexpr const char* kPlayedUntil = "Foresight-Until";

/// Where status, sessions and recordings come from. Called by one thread of the server that may wait for the disk.
class Backend {
 public:
  virtual ~Backend() = default;

  /// The body of `GET /api/status`: a JSON object.
  virtual std::string status_json() = 0;

  /// The body of `GET /api/sessions`: a JSON object with "sessions".
  virtual std::string sessions_json() = 0;

  /// Opens a recording; an Error is told to the client (404).
  virtual Result<LogFile> open_log(const LogRequest& request) = 0;

  /// The answer to `GET /api/sessions/<session>/files`: 200 with a JSON object with "files", 404, 409 while it is recorded.
  virtual HttpResponse session_files(const std::string& session) = 0;

  /// The answer to `DELETE /logs/<session>`: 204, 404, 409 for one that is kept or being recorded.
  virtual HttpResponse delete_session(const std::string& session) = 0;

  /// The answer to `GET /api/played`: an MCAP file of one channel with the messages captured in that time, as they are
  /// played, or so many of the first of them as go into one answer, with the header kPlayedUntil. 404 where nothing is
  /// played, or nothing of that topic.
  virtual HttpResponse played(const PlayedRequest& /*request*/) {
    return error_response(404, "no recording is played here");
  }

  /// Whether a real game is in progress that the league's rules hold for: wireless networks stay silent, and from
  /// beyond this machine nobody controls or downloads anything. Any thread; asked ten times a second.
  virtual bool match_mode() const = 0;
};

}  // namespace robot::net
