// HTTP responses with the viewer's files.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "robot/core/result.h"
#include "robot/net/http/assets.h"
#include "robot/net/http/http.h"

namespace robot::net {

/// Returns the response to GET or HEAD of `path`, or nothing if it is none of `assets`. "/" is index.html.
/// The files are sent as stored, in gzip, or inflated for a client that does not accept gzip.
std::optional<HttpResponse> asset_response(std::span<const Asset> assets, const HttpRequest& request,
                                           std::string_view path);

/// Returns the inflated bytes of the gzip data `packed`.
Result<std::string> inflate_gzip(std::string_view packed);

}  // namespace robot::net
