// The interface from the server to its program.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/net/http/http.h"

namespace robot::net {

/// A function that returns whether the client has left, so that nobody needs its answer any more. Any thread.
using ClientLeft = std::function<bool()>;

/// A request of `GET /logs/…`. Times are capture times [ns since the epoch].
struct LogRequest {
  std::string session;                          // a safe name: no separators, no leading dot
  std::optional<std::string> file;              // a file on the disk, a safe name; all later fields are then empty
  std::optional<std::string> stream;            // file name of one stream without ".mcap"; absent: the whole session
  std::optional<std::uint64_t> from_ns, to_ns;  // only the chunks that overlap this range
  std::optional<std::uint64_t> until_ns;        // of a live session: only records until this time
  bool foxglove = false;                        // with the scenes, frames and images that other viewers draw
  ClientLeft left;                              // ends their making early; may be empty
};

/// The answer to a LogRequest: a file to send, or a redirect.
struct LogFile {
  std::shared_ptr<const ByteSource> body;
  std::string etag;                                // without quotes
  std::optional<std::uint64_t> redirect_until_ns;  // a live session: repeat the request with this `until`; no body
};

/// A request of `GET /api/played`: a part of one topic of the played recording.
struct PlayedRequest {
  std::string topic;                                                             // "/14/2/ball"
  std::uint64_t from_ns = 0, to_ns = std::numeric_limits<std::uint64_t>::max();  // capture times, both included
};

/// Header of the answer to a PlayedRequest: its end [ns since the epoch]. The client requests the rest separately.
inline constexpr const char* kPlayedUntil = "Foresight-Until";

/// The beginning of the paths of questions about the whole of the played recording.
inline constexpr std::string_view kWhole = "/api/whole/";

/// The source of status, sessions and recordings. Called by threads of the server that may wait: one for the status, one
/// for checksums, one for the rest. Functions of different threads run at the same time.
class Backend {
 public:
  virtual ~Backend() = default;

  /// Returns the body of `GET /api/status`: a JSON object. Does not wait for other functions.
  virtual std::string status_json() = 0;

  /// Returns the body of `GET /api/sessions`: a JSON object with "sessions" and "reports".
  virtual std::string sessions_json() = 0;

  /// Opens a recording. The client gets an Error as 404.
  virtual Result<LogFile> open_log(const LogRequest& request) = 0;

  /// Returns the answer to `GET /api/sessions/<session>/files`: 200 with a JSON object with "files", 404, or 409 during
  /// recording. It may read every byte of the session, and ends early when the client has left.
  virtual HttpResponse session_files(const std::string& session, const ClientLeft& left) = 0;

  /// Returns the answer to `DELETE /logs/<session>`: 204, 404, or 409 if the session is kept or being recorded.
  virtual HttpResponse delete_session(const std::string& session) = 0;

  /// Returns the answer to `GET /api/played`: an MCAP file of one channel with the messages captured in that time, as
  /// they are played. A long range is cut to the first messages; the header kPlayedUntil gives its end.
  /// 404 if no recording is played, or if it has no such topic.
  virtual HttpResponse played(const PlayedRequest& /*request*/) {
    return error_response(404, "no recording is played here");
  }

  /// Returns the answer to `GET /api/whole/…`: events, numbers and runs of the whole played recording. It may read every
  /// byte of the recording, and ends early when the client has left. 404 if no recording is played.
  virtual HttpResponse whole(const Target& /*target*/, const ClientLeft& /*left*/) {
    return error_response(404, "no recording is played here");
  }

  /// Returns the answer to `GET /api/recent?topics=…`: an MCAP file with the last minutes of small objects, up to now.
  /// Without topics, of all of them. 404 if nothing is kept, as where a recording is played.
  virtual HttpResponse recent(const std::vector<std::string>& /*topics*/) {
    return error_response(404, "the last minutes are not kept here");
  }

  /// Returns the answer to `GET /reports/<page>`: an HTML page that lies beside the played recording. `page` is a safe name.
  /// 404 if there is none, or if no recording is played.
  virtual HttpResponse report_page(const std::string& /*page*/) {
    return error_response(404, "no recording is played here");
  }

  /// Returns whether a real game under the league's rules is in progress. Wireless networks then stay silent, and no
  /// other machine controls or downloads anything. Any thread; called ten times a second.
  virtual bool match_mode() const = 0;
};

}  // namespace robot::net
