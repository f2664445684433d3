// Parts of texts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace robot {

/// Returns `text` without the blanks, tabs and line ends at its beginning and end.
std::string_view trimmed(std::string_view text);

/// Returns the parts of `text` between the separators, each as it is written: one more than there are separators. They
/// point into `text`.
std::vector<std::string_view> split(std::string_view text, std::string_view separator);

/// Takes the next line off `text` and returns it without its end, "\n" or "\r\n".
std::string_view take_line(std::string_view& text);

/// Returns the parts with the separator between them, so that split() returns them again.
std::string joined(const std::vector<std::string>& parts, std::string_view separator);

/// Returns at most `most` bytes of text from outside for an error sentence, with a question mark for each byte that is no
/// printable ASCII.
std::string printable(std::string_view text, std::size_t most);

/// Returns the values in a format of printf, with any length. The compiler checks that a literal format fits the values.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace robot
