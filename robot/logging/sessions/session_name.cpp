#include "robot/logging/sessions/session_name.h"

#include <algorithm>
#include <cctype>
#include <ctime>

#include "robot/core/clock.h"
#include "robot/core/encoding.h"

namespace robot::logging {
namespace {

/// Replaces everything but letters, digits and a few signs by '_'.
std::string tame(std::string_view text) {
  std::string tame(text);
  for (char& c : tame)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_' && c != '.') c = '_';
  return tame;
}

bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

}  // namespace

Result<void> check_session_name(std::string_view name) {
  if (name.size() > kMaxSessionName)
    return Error{"session name: expected at most " + std::to_string(kMaxSessionName) + " bytes, got " +
                 std::to_string(name.size())};
  if (!is_utf8(name) || std::ranges::any_of(name, is_control))
    return Error{"session name: expected UTF-8 text without control characters, got '" + tame(name) + "'"};
  return {};
}

std::string session_folder_name(std::uint64_t start_ns, std::string_view name, std::string_view profile) {
  const std::time_t seconds = static_cast<std::time_t>(start_ns / kSecond);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d_%H-%M-%S", &utc);
  return std::string(text) + "_" + tame(name.empty() ? profile : name);
}

}  // namespace robot::logging
