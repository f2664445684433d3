// The list of recordings as a page, for people without the viewer.
#pragma once

#include <string>
#include <string_view>

namespace robot::net {

/// The HTML of `sessions_json`, the body of `GET /api/sessions`. Every text is escaped.
std::string session_page(std::string_view sessions_json);

/// `text` so that HTML shows it as it is, also within quotes.
std::string escaped(std::string_view text);

}  // namespace robot::net
