// Parser of HTTP/1.1 requests from the bytes of a connection, on Boost.Beast.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/net/http/http.h"

namespace robot::net {

/// A parser that takes the bytes of one connection and returns its requests in order. Requests have no body.
class HttpParser {
 public:
  static constexpr std::uint32_t kMaxHeaderBytes = 16 << 10;

  HttpParser();
  ~HttpParser();

  /// Adds received bytes.
  void add(std::string_view bytes);

  /// Returns the next request, or nothing while it is incomplete. After an Error the connection must be closed.
  Result<std::optional<HttpRequest>> next();

  /// Returns whether a part of a request has arrived.
  bool begun() const;

  /// Returns the bytes after the last request: the first frames of an upgraded connection.
  std::string take_rest();

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::string bytes_;
  std::size_t request_bytes_ = 0;  // of the current request, already in the parser
};

}  // namespace robot::net
