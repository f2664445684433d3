// The frame of a page: a single HTML file without scripts, which needs no other file.
#pragma once

#include <string>

namespace sim::report {

/// Escapes text for a page: "&lt;" for "<" and so on.
std::string escaped(const std::string& text);

/// Returns the page. Titles are plain text; `style` is what only this page needs, after the style of all pages; `body` is
/// HTML.
std::string html_page(const std::string& title, const char* style, const std::string& body);

}  // namespace sim::report
