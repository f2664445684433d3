#include "sim/match/snapshot.h"

#include <cmath>

#include "sim/match/fields.h"
#include "sim/match/hash.h"
#include "sim/motion/model.h"

namespace sim {
namespace {

constexpr std::uint32_t kMagic = 'F' | 'S' << 8 | 'I' << 16 | 'M' << 24;

void put(std::vector<std::uint8_t>& bytes, std::uint64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

/// Takes the next number of `size` bytes. The caller has checked that there are that many.
std::uint64_t take(std::span<const std::uint8_t>& bytes, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) number |= std::uint64_t{bytes[i]} << (8 * i);
  bytes = bytes.subspan(size);
  return number;
}

std::uint64_t hash_of_bytes(std::span<const std::uint8_t> bytes) {
  Hash hash;
  for (const std::uint8_t byte : bytes) hash.add(byte);
  return hash.value();
}

constexpr std::size_t kSealSize = 8;  // [bytes] hash at the end

/// Returns the size of a snapshot [bytes]. It is the same for every state.
std::size_t snapshot_size() {
  std::size_t size = 4 + 4 + kSealSize;
  const State any{};
  visit_fields(any, [&](const FieldPath&, auto field) { size += sizeof field; });
  return size;
}

template <class Field>
bool is_valid(Field field, std::uint64_t bits) {
  if constexpr (std::is_same_v<Field, float>) {
    return std::isfinite(field);
  } else if constexpr (std::is_same_v<Field, bool>) {
    return bits <= 1;
  } else if constexpr (std::is_enum_v<Field>) {
    return bits <= last_of<Field>();
  } else {
    return true;
  }
}

bool is_robot(std::uint8_t index) { return index < kMaxRobots || index == kNobody; }

/// Returns the path of a count or index that is outside its array, or an empty string.
std::string lost_index(const State& state) {
  const World& world = state.world;
  if (world.players < 1 || world.players > kMaxPlayers) return "world.players";
  if (std::abs(world.home_attacks) != 1) return "world.home_attacks";
  if (!is_robot(world.touched)) return "world.touched";
  if (!is_robot(world.kicked)) return "world.kicked";
  if (!is_robot(world.whiffed)) return "world.whiffed";
  if (!is_robot(state.book.last_toucher)) return "book.last_toucher";
  if (!is_robot(state.book.kick_off_by)) return "book.kick_off_by";
  for (int i = 0; i < kMaxRobots; ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    if (world.bodies[i].kind >= motion::kMaxKicks) return "world.bodies" + index + ".kind";
    if (state.robots[i].command.kick >= motion::kMaxKicks) return "robots" + index + ".command.kick";
    if (state.robots[i].mind.kick >= motion::kMaxKicks) return "robots" + index + ".mind.kick";
  }
  return {};
}

Restored refused(std::string sentence) { return {std::nullopt, "snapshot: " + std::move(sentence)}; }

}  // namespace

std::vector<std::uint8_t> snapshot_of(const State& state) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(snapshot_size());
  put(bytes, kMagic, 4);
  put(bytes, kSnapshotVersion, 4);
  visit_fields(state, [&](const FieldPath&, auto field) { put(bytes, bits_of(field), sizeof field); });
  bytes.resize(bytes.size() + kSealSize);
  seal(bytes);
  return bytes;
}

void seal(std::span<std::uint8_t> bytes) {
  const std::uint64_t hash = hash_of_bytes(bytes.first(bytes.size() - kSealSize));
  for (std::size_t i = 0; i < kSealSize; ++i)
    bytes[bytes.size() - kSealSize + i] = static_cast<std::uint8_t>(hash >> (8 * i));
}

Restored restore(std::span<const std::uint8_t> bytes) {
  // check magic, version, size and hash
  if (bytes.size() < 8) return refused("expected at least 8 bytes, got " + std::to_string(bytes.size()));
  std::span<const std::uint8_t> rest = bytes;
  if (take(rest, 4) != kMagic) return refused("expected the bytes FSIM at the beginning");
  if (const auto version = take(rest, 4); version != kSnapshotVersion)
    return refused("expected version " + std::to_string(kSnapshotVersion) + ", got " + std::to_string(version));
  if (bytes.size() != snapshot_size())
    return refused("expected " + std::to_string(snapshot_size()) + " bytes, got " + std::to_string(bytes.size()));
  std::span<const std::uint8_t> tail = bytes.last(kSealSize);
  if (take(tail, kSealSize) != hash_of_bytes(bytes.first(bytes.size() - kSealSize)))
    return refused("the hash at its end does not match its bytes; it is damaged");

  // read field by field and check each value
  State state;
  std::string wrong;
  visit_fields(state, [&](const FieldPath& path, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    const std::uint64_t bits = take(rest, sizeof(Field));
    const bool representable = !std::is_same_v<Field, bool> || bits <= 1;
    if (representable) field = field_of<Field>(bits);
    if ((!representable || !is_valid(field, bits)) && wrong.empty()) wrong = path.text();
  });
  if (wrong.empty()) wrong = lost_index(state);
  if (!wrong.empty()) return refused(wrong + " has an impossible value");
  return {state, {}};
}

}  // namespace sim
