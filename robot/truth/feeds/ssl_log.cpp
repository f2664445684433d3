#include "robot/truth/feeds/ssl_log.h"

#include <cstddef>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

constexpr std::string_view kName = "SSL_LOG_FILE";
constexpr std::uint64_t kVersion = 1;
constexpr std::uint64_t kLongest = std::uint64_t{1} << 31;  // sizes and times are signed

/// Takes a big endian integer of `size` bytes off `rest`, which has as many.
std::uint64_t take_integer(std::string_view& rest, std::size_t size) {
  std::uint64_t value = 0;
  for (const char byte : rest.substr(0, size)) value = value << 8 | static_cast<std::uint8_t>(byte);
  rest.remove_prefix(size);
  return value;
}

/// Reports whether messages of this type are packets of SSL-Vision. An unknown one may be.
bool is_vision(std::uint64_t type) { return type == 1 || type == 2 || type == 4; }

}  // namespace

bool is_ssl_log(std::string_view file_bytes) { return file_bytes.starts_with(kName); }

Result<SslLogReader> SslLogReader::open(std::string_view file_bytes) {
  if (file_bytes.starts_with("\x1f\x8b"))
    return Error{"expected a log of the SSL, got a packed file: unpack it with gunzip"};
  if (!is_ssl_log(file_bytes))
    return Error{"expected a log of the SSL that begins with SSL_LOG_FILE, got another file"};
  SslLogReader reader(file_bytes);
  reader.rest_.remove_prefix(kName.size());
  if (reader.rest_.size() < 4) return Error{"expected a version after SSL_LOG_FILE, got the end of the file"};
  const std::uint64_t version = take_integer(reader.rest_, 4);
  if (version != kVersion)
    return Error{formatted("expected version 1 of a log of the SSL, got version %llu",
                           static_cast<unsigned long long>(version))};
  return reader;
}

Result<std::optional<SslLogMessage>> SslLogReader::next() {
  constexpr std::size_t kHeadBytes = 16;
  if (rest_.empty()) return std::optional<SslLogMessage>();
  const std::size_t at = all_.size() - rest_.size();
  const auto damage = [&](const std::string& fault) {
    rest_ = {};
    return Error{formatted("byte %zu: ", at) + fault};
  };
  if (rest_.size() < kHeadBytes) return damage(formatted("expected a message, got the last %zu bytes", rest_.size()));
  const std::uint64_t received_ns = take_integer(rest_, 8);
  const std::uint64_t type = take_integer(rest_, 4);
  const std::uint64_t size = take_integer(rest_, 4);
  if (received_ns >> 63 != 0) return damage("expected a time since 1970, got an earlier one");
  if (size >= kLongest || size > rest_.size())
    return damage(
        formatted("expected a message of %llu bytes, got %zu", static_cast<unsigned long long>(size), rest_.size()));
  const SslLogMessage message{.received_ns = received_ns, .vision = is_vision(type), .bytes = rest_.substr(0, size)};
  rest_.remove_prefix(size);
  return std::optional(message);
}

}  // namespace robot::truth
