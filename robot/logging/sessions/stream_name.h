// Names of the files of streams: each topic has a name of its own.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robot::logging {

/// The longest name that stream_file_name() returns [bytes].
inline constexpr std::size_t kMaxStreamName = 200;

/// Returns the file name of the stream of `topic`: "14.2.ball.mcap" for "/14/2/ball". Two topics never share a name, not
/// even in a file system that ignores case. A name consists of letters, digits, '.', '_' and '-', and begins with no '.'.
///
/// A lower-case letter, a digit and '_' stay, and '/' becomes '.'. An upper-case letter becomes "--" and its lower-case
/// letter, any other byte '-' and two hexadecimal digits. A name that would be too long ends with the topic's SHA-1.
std::string stream_file_name(std::string_view topic);

}  // namespace robot::logging
