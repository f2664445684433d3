// The world at one moment, as a feed reports it.
#pragma once

#include <cstdint>

#include "proto/foresight/truth.pb.h"

namespace robot::truth {

namespace pb = foresight;

/// The greatest numbers of a team (from 0) and of a player (from 1), as in proto/foresight/truth.proto.
inline constexpr std::uint32_t kMaxTeam = 255, kMaxPlayer = 20;

/// A message of /truth/world with its capture time.
struct TimedTruth {
  std::uint64_t capture_ns = 0;  // [ns since the epoch]
  pb::GroundTruth truth;
};

}  // namespace robot::truth
