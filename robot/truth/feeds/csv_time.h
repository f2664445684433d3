// Times as people write them in files.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace robot::truth {

/// Returns the time of an ISO 8601 text such as "2026-03-14T15:09:26.5Z" [ns since the epoch]. A blank may stand for the T.
/// The zone is Z, an offset such as +02:00, or absent for UTC. Returns nothing for another text, and for a time before
/// 1970 or after 2262.
std::optional<std::uint64_t> parse_iso_time(std::string_view text);

}  // namespace robot::truth
