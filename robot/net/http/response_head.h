// The head of a response as it goes over the wire.
#pragma once

#include <string>

#include "robot/net/http/http.h"

namespace robot::net {

/// Returns status line, headers and the empty line. Adds Content-Length, Connection and the security headers.
std::string response_head(const HttpResponse& response, bool keep_alive);

/// Returns the same of `status` and `headers` alone. Adds no header.
std::string plain_head(int status, const Headers& headers);

}  // namespace robot::net
