#include "robot/logging/sessions/stream_name.h"

#include <cstdint>

#include "robot/core/encoding.h"

namespace robot::logging {
namespace {

constexpr std::string_view kEnding = ".mcap";
// each of these follows a '-' only here, so that no other topic has the same name
constexpr std::string_view kWithoutSlash = "-_", kOnlySlash = "-", kHashed = "-.";

std::string hex(std::uint8_t byte) {
  constexpr std::string_view digits = "0123456789abcdef";
  return {digits[byte / 16], digits[byte % 16]};
}

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

/// Reports whether `c` stays as it is. Does not depend on the locale.
bool is_plain(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; }

std::string encoded(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (is_plain(c))
      name += c;
    else if (c == '/' && !name.empty())
      name += '.';
    else if (is_upper(c))
      name.append("--").push_back(static_cast<char>(c - 'A' + 'a'));
    else
      name += '-' + hex(static_cast<std::uint8_t>(c));
  }
  return name;
}

std::string sha1_of(std::string_view topic) {
  std::string text;
  for (const std::uint8_t byte : sha1(topic)) text += hex(byte);
  return text;
}

}  // namespace

std::string stream_file_name(std::string_view topic) {
  std::string name;
  if (!topic.starts_with('/'))
    name = std::string(kWithoutSlash) + encoded(topic);
  else if (topic == "/")
    name = kOnlySlash;
  else
    name = encoded(topic.substr(1));
  if (name.size() + kEnding.size() > kMaxStreamName) {
    const std::string end = std::string(kHashed) + sha1_of(topic);
    name = name.substr(0, kMaxStreamName - kEnding.size() - end.size()) + end;
  }
  return name + std::string(kEnding);
}

}  // namespace robot::logging
