// Log files of the Small Size League's games (ssl-logtools, ssl-go-tools), format version 1.
//
// "SSL_LOG_FILE", int32 version; then for each message int64 time of reception [ns since the epoch], int32 type, int32 size,
// the message. Integers are big endian. Types: 0 blank, 1 unknown, 2 SSL-Vision of 2010, 3 referee, 4 SSL-Vision of 2014,
// 5 tracker, 6 index.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "robot/core/result.h"

namespace robot::truth {

/// One message of a log.
struct SslLogMessage {
  std::uint64_t received_ns = 0;  // [ns since the epoch]
  bool vision = false;            // a packet of SSL-Vision; false: another program's
  std::string_view bytes;
};

/// Reports whether the file is such a log.
bool is_ssl_log(std::string_view file_bytes);

/// A reader of a whole log in memory.
class SslLogReader {
 public:
  /// Returns an Error for another file, for another version, and with an advice for a packed file. `file_bytes` outlives
  /// this.
  static Result<SslLogReader> open(std::string_view file_bytes);

  /// Returns the next message, or nothing at the end. Returns an Error where the file is damaged; after it nothing comes.
  Result<std::optional<SslLogMessage>> next();

 private:
  explicit SslLogReader(std::string_view file_bytes) : all_(file_bytes), rest_(file_bytes) {}

  std::string_view all_, rest_;
};

}  // namespace robot::truth
