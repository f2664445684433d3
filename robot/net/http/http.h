// HTTP requests and responses as plain data. The server's answer is a function from request to response.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"

namespace robot::net {

using Headers = std::vector<std::pair<std::string, std::string>>;

struct HttpRequest {
  std::string method;  // "GET"
  std::string target;  // path and query, as it came
  Headers headers;     // names in lower case
  bool keep_alive = true;

  /// Returns the first header called `name` (lower case).
  std::optional<std::string_view> header(std::string_view name) const;

  /// Returns whether the comma-separated header `name` has the element `token` (lower case), in any case.
  bool has_token(std::string_view name, std::string_view token) const;

  /// Returns whether the comma-separated header `name` has the element `token` in exactly this case.
  bool has_exact_token(std::string_view name, std::string_view token) const;
};

/// A range of a source that is read piece by piece during sending.
struct BodyPart {
  std::shared_ptr<const ByteSource> source;
  std::uint64_t offset = 0, size = 0;
};

struct HttpResponse {
  int status = 200;
  Headers headers;
  std::variant<std::string, std::string_view, BodyPart> body;  // own text, bytes of the program itself, or a stream

  std::uint64_t body_size() const;
};

/// Returns a response that owns its text.
HttpResponse text_response(int status, std::string_view content_type, std::string body);

/// Returns a refusing response with `sentence` as plain text.
HttpResponse error_response(int status, std::string sentence);

/// A parsed and decoded request target.
struct Target {
  std::string path;   // "/logs/a.mcap"
  std::string query;  // as it came, without '?'
  std::map<std::string, std::string> parameters;

  /// Returns the parameter `name`, or an empty string if it is missing.
  std::string parameter(const std::string& name) const;
};

/// Parses `target`. Refuses paths that do not begin with '/', that contain ".." or "." steps, and that encode a
/// separator, a '%' or a control character. Our routes need none of these.
Result<Target> parse_target(std::string_view target);

/// The bytes of a body that a Range header requests.
struct ByteRange {
  std::uint64_t offset = 0, size = 0;
};

enum class RangeOutcome { whole, part, unsatisfiable };

/// Parses a Range header for a body of `size` bytes. Several ranges and other units give the whole, as RFC 9110 allows.
std::pair<RangeOutcome, ByteRange> parse_range(std::string_view header, std::uint64_t size);

/// Returns the response to GET or HEAD of `source`: whole, part (206), not modified (304) or unsatisfiable (416).
/// Reads Range, If-Range and If-None-Match. `etag` includes its quotes.
HttpResponse body_response(const HttpRequest& request, std::shared_ptr<const ByteSource> source,
                           const std::string& etag, std::string_view content_type);

/// Returns whether If-None-Match of `request` names `etag`, so that the answer is 304.
bool not_modified(const HttpRequest& request, std::string_view etag);

}  // namespace robot::net
