// Logs of the Small Size League for tests, byte by byte.
#pragma once

#include <cstdint>
#include <string>

namespace tests {

inline const std::string kSslLogHead("SSL_LOG_FILE\0\0\0\1", 16);

inline std::string big_endian(std::uint64_t value, int size) {
  std::string bytes;
  for (int i = size - 1; i >= 0; --i) bytes.push_back(static_cast<char>(value >> (8 * i)));
  return bytes;
}

inline std::string ssl_log_message(std::uint64_t received_ns, std::uint32_t type, const std::string& bytes) {
  return big_endian(received_ns, 8) + big_endian(type, 4) + big_endian(bytes.size(), 4) + bytes;
}

}  // namespace tests
