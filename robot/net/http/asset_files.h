// The viewer's files over HTTP.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "robot/core/result.h"
#include "robot/net/http/assets.h"
#include "robot/net/http/http.h"

namespace robot::net {

/// The response to GET or HEAD of `path` if it is one of `assets` ("/" is index.html); nothing if it is none.
/// Sent as they are stored, in gzip; inflated for a client that does not take that.
std::optional<HttpResponse> asset_response(std::span<const Asset> assets, const HttpRequest& request,
                                           std::string_view path);

/// The bytes within gzip `packed`.
Result<std::string> inflate_gzip(std::string_view packed);

}  // namespace robot::net
