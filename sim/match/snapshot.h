// A State as bytes: little-endian numbers of fixed width, field by field, the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/match/state.h"

namespace sim {

/// The version of the format. Increment it when the fields of State change; older snapshots are then refused.
inline constexpr std::uint32_t kSnapshotVersion = 4;

/// Returns "FSIM", the version, every field in order, and the hash of all these bytes.
std::vector<std::uint8_t> snapshot_of(const State& state);

/// Writes the hash of all bytes but the last 8 into the last 8, as `snapshot_of` does. For tests that change bytes.
void seal(std::span<std::uint8_t> bytes);

/// The restored state, or the reason why the bytes were refused.
struct Restored {
  std::optional<State> state;
  std::string refusal;  // empty when there is a state
};

/// Reads a snapshot from untrusted bytes. A returned state can always be stepped: its enumerators exist, its indices
/// are inside their arrays, its numbers are finite.
Restored restore(std::span<const std::uint8_t> bytes);

}  // namespace sim
