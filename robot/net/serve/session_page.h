// The page with the list of recordings, for people without the viewer.
#pragma once

#include <string>
#include <string_view>

namespace robot::net {

/// Returns `sessions_json`, the body of `GET /api/sessions`, as HTML. Every text is escaped.
std::string session_page(std::string_view sessions_json);

/// Returns `text` escaped for HTML, also within quotes.
std::string escaped(std::string_view text);

}  // namespace robot::net
