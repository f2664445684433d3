// Names of sessions and of their folders.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot::logging {

/// The longest name that a person may give to a session [bytes].
inline constexpr std::size_t kMaxSessionName = 100;

/// Returns an Error if `name` cannot name a session: it is too long, is not UTF-8 or has control characters.
Result<void> check_session_name(std::string_view name);

/// Returns a folder name for a session that starts at `start_ns`, for example "2026-11-21_14-02-11_game". The time is
/// UTC, so that names sort by time. Characters that do not suit a file name or an address become '_'.
std::string session_folder_name(std::uint64_t start_ns, std::string_view name, std::string_view profile);

}  // namespace robot::logging
