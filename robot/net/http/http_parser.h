// HTTP/1.1 requests out of the bytes of a connection. The only place that knows Boost.Beast.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/net/http/http.h"

namespace robot::net {

/// Takes the bytes of one connection and gives out its requests, one after the other. We serve nothing that has a body.
class HttpParser {
 public:
  static constexpr std::uint32_t kMaxHeaderBytes = 16 << 10;

  HttpParser();
  ~HttpParser();

  /// Adds what has come in.
  void add(std::string_view bytes);

  /// The next request; nothing while it is incomplete. After an Error the connection is of no use any more.
  Result<std::optional<HttpRequest>> next();

  /// Whether part of a request is here.
  bool begun() const;

  /// What came after the last request: the first frames of an upgraded connection.
  std::string take_rest();

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::string bytes_;
  std::size_t request_bytes_ = 0;  // of the request being read, in the parser already
};

}  // namespace robot::net
