// Points in time for tests of recordings.
#pragma once

#include "robot/core/clock.h"

namespace tests {

inline constexpr std::uint64_t kHour = 3600 * robot::kSecond;
inline constexpr std::uint64_t kNow = 1'700'000'000 * robot::kSecond;  // [ns since the epoch]

}  // namespace tests
