// The WebSocket frames of a client, for tests of the server and for benches.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "robot/net/websocket/frames.h"

namespace tests {

/// Appends a masked frame. `final` is false for all but the last fragment of a message.
inline void append_masked_frame(std::string& out, robot::net::Opcode opcode, std::string_view payload,
                                std::uint32_t mask, bool final = true) {
  const std::size_t start = out.size();
  robot::net::append_frame_header(out, opcode, payload.size());
  if (!final) out[start] = static_cast<char>(opcode);
  out[start + 1] = static_cast<char>(static_cast<unsigned char>(out[start + 1]) | 0x80);
  for (int i = 0; i < 4; ++i) out += static_cast<char>((mask >> (8 * i)) & 0xff);
  for (std::size_t i = 0; i < payload.size(); ++i)
    out += static_cast<char>(static_cast<unsigned char>(payload[i]) ^ ((mask >> (8 * (i & 3))) & 0xff));
}

}  // namespace tests
