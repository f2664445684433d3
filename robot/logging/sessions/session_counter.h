// The number of the next session of a log folder, and the identity of this boot: an order that no clock can change.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace robot::logging {

/// The name of the file in the log folder that holds the last number.
inline constexpr const char* kCounterFile = ".last_session";

/// Returns the next number: greater than each one before and than `greatest`, the greatest known number of a session.
/// The file is only a help: a damaged one counts as 0, and a failure to write it has no other effect. Processes may call
/// this at the same time.
std::uint64_t next_session_number(const std::filesystem::path& log_folder, std::uint64_t greatest);

/// Returns the identity of the current boot of this machine, or an empty string if the system does not give it.
std::string boot_id();

}  // namespace robot::logging
