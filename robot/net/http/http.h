// HTTP requests and responses as plain data: what the server answers is a function from one to the other.
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

  /// The first header called `name` (lower case).
  std::optional<std::string_view> header(std::string_view name) const;

  /// Whether one of the elements of the comma-separated header `name` is `token` (lower case), whatever its case.
  bool has_token(std::string_view name, std::string_view token) const;
};

/// A part of bytes that are read piece by piece while they are sent.
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

/// A response with a text of its own.
HttpResponse text_response(int status, std::string_view content_type, std::string body);

/// A response that refuses: `sentence` as plain text.
HttpResponse error_response(int status, std::string sentence);

/// Status line and headers with the empty line after them; adds Content-Length, Connection and the security headers.
std::string response_head(const HttpResponse& response, bool keep_alive);

/// A request target, taken apart and decoded.
struct Target {
  std::string path;   // "/logs/a.mcap"
  std::string query;  // as it came, without '?'
  std::map<std::string, std::string> parameters;

  /// The parameter `name`; empty if it is not there.
  std::string parameter(const std::string& name) const;
};

/// Takes `target` apart. Refused are paths that do not begin with '/', that step up ("..", "."), and that hide a
/// separator, a '%' or a control character behind an encoding: nothing we serve needs them.
Result<Target> parse_target(std::string_view target);

/// Which bytes of a body of `size` bytes a Range header asks for.
struct ByteRange {
  std::uint64_t offset = 0, size = 0;
};

enum class RangeOutcome { whole, part, unsatisfiable };

/// Reads a Range header of one range; several ranges and other units are answered with the whole, as RFC 9110 allows.
std::pair<RangeOutcome, ByteRange> parse_range(std::string_view header, std::uint64_t size);

/// The response to GET or HEAD of `source`: whole, part (206) or neither (416), by Range, If-Range and If-None-Match.
/// `etag` comes with its quotes.
HttpResponse body_response(const HttpRequest& request, std::shared_ptr<const ByteSource> source,
                           const std::string& etag, std::string_view content_type);

/// Whether If-None-Match of `request` names `etag`, so that 304 is the answer.
bool not_modified(const HttpRequest& request, std::string_view etag);

}  // namespace robot::net
