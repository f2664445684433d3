// A State as bytes that any machine can read: little-endian numbers of fixed width, field by field.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/match/state.h"

namespace sim {

/// Goes up whenever the fields of State change; older snapshots are then refused.
inline constexpr std::uint32_t kSnapshotVersion = 2;

/// "FSIM", the version, every field in its order, and the hash of all that.
std::vector<std::uint8_t> snapshot_of(const State& state);

/// Writes the hash of all bytes before them into the last 8, as `snapshot_of` has done; for tests that change bytes.
void seal(std::span<std::uint8_t> bytes);

/// The state of a snapshot, or the sentence that says why these bytes are none. Whatever they are, a state that comes
/// back can be stepped: its enumerators exist, its indices are inside their arrays, its numbers are finite.
struct Restored {
  std::optional<State> state;
  std::string refusal;  // empty when there is a state
};
Restored restore(std::span<const std::uint8_t> bytes);

}  // namespace sim
