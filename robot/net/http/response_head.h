// The head of a response as it goes over the wire.
#pragma once

#include <string>
#include <string_view>

#include "robot/net/http/http.h"

namespace robot::net {

/// Returns status line, headers and the empty line. Adds Content-Length, Connection and the security headers. A
/// Content-Security-Policy of `response` replaces the usual one. `frame_ancestors` are the pages that may show the answer
/// in a frame, see origin_policy.h.
std::string response_head(const HttpResponse& response, bool keep_alive, std::string_view frame_ancestors = "'none'");

/// Returns the same of `status` and `headers` alone. Adds no header.
std::string plain_head(int status, const Headers& headers);

}  // namespace robot::net
