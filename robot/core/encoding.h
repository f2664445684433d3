// Encodings that the protocols need: base64 (RFC 4648), SHA-1 (RFC 3174), UTF-8 (RFC 3629).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot {

/// Returns `bytes` as base64 with padding.
std::string to_base64(std::string_view bytes);

/// Decodes base64. Returns an Error if a character or the padding is wrong.
Result<std::string> from_base64(std::string_view text);

/// Returns the SHA-1 digest of `bytes`. The WebSocket handshake needs it; it protects nothing.
std::array<std::uint8_t, 20> sha1(std::string_view bytes);

/// Reports whether `text` is well-formed UTF-8: no overlong forms, no surrogates, nothing above U+10FFFF.
bool is_utf8(std::string_view text);

}  // namespace robot
