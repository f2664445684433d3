#include "sim/match/snapshot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/match/fields.h"
#include "sim/match/hash.h"
#include "tests/sim/support/states.h"

namespace sim {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(Snapshot, RestoresTheSameState) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const State state = test::scrambled(seed);
    const Restored restored = restore(snapshot_of(state));
    ASSERT_TRUE(restored.state) << restored.refusal;
    EXPECT_EQ(hash_of(*restored.state), hash_of(state)) << difference(*restored.state, state);
    EXPECT_EQ(restored.refusal, "");
  }
}

TEST(Snapshot, IsTheSameBytesOnEveryMachine) {
  State state{};
  state.world.key.seed = 0x0123456789abcdef;
  state.world.players = 4;
  const Bytes bytes = snapshot_of(state);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 8), (Bytes{'F', 'S', 'I', 'M', kSnapshotVersion, 0, 0, 0}));
  EXPECT_EQ(Bytes(bytes.begin() + 8, bytes.begin() + 16), (Bytes{0xef, 0xcd, 0xab, 0x89, 0x67, 0x45, 0x23, 0x01}));
}

TEST(Snapshot, IsRefusedWhenCutAnywhere) {
  const Bytes bytes = snapshot_of(test::scrambled(1));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Restored restored = restore(std::span(bytes).first(size));
    EXPECT_FALSE(restored.state) << size;
    EXPECT_TRUE(restored.refusal.starts_with("snapshot: expected")) << restored.refusal;
  }
}

TEST(Snapshot, IsRefusedWithAnyByteChanged) {
  Bytes bytes = snapshot_of(test::scrambled(2));
  for (std::size_t i = 0; i < bytes.size(); i += i < 32 ? 1 : 61) {
    bytes[i] ^= 0x10;
    EXPECT_FALSE(restore(bytes).state) << i;
    bytes[i] ^= 0x10;
  }
  EXPECT_TRUE(restore(bytes).state);
}

TEST(Snapshot, SaysWhyItIsRefused) {
  Bytes bytes = snapshot_of(test::scrambled(3));
  const std::string size = std::to_string(bytes.size());
  EXPECT_EQ(restore(Bytes(7)).refusal, "snapshot: expected at least 8 bytes, got 7");
  EXPECT_EQ(restore(Bytes(100)).refusal, "snapshot: expected the bytes FSIM at the beginning");
  EXPECT_EQ(restore(std::span(bytes).first(9)).refusal, "snapshot: expected " + size + " bytes, got 9");
  bytes[20] ^= 1;
  EXPECT_EQ(restore(bytes).refusal, "snapshot: the hash at its end does not match its bytes; it is damaged");
  bytes[4] = kSnapshotVersion + 1;
  EXPECT_EQ(restore(bytes).refusal, "snapshot: expected version " + std::to_string(kSnapshotVersion) + ", got " +
                                        std::to_string(kSnapshotVersion + 1));
}

TEST(Snapshot, IsRefusedWithImpossibleValues) {
  const auto refusal = [](auto&& spoil) {
    State state = test::scrambled(4);
    spoil(state);
    return restore(snapshot_of(state)).refusal;
  };
  const auto impossible = [](const char* name) {
    return "snapshot: " + std::string(name) + " has an impossible value";
  };
  EXPECT_EQ(refusal([](State& s) { s.world.ball.position.x = std::nanf(""); }), impossible("world.ball.position.x"));
  EXPECT_EQ(refusal([](State& s) { s.world.bodies[2].doing = static_cast<Body::Doing>(10); }),
            impossible("world.bodies[2].doing"));
  EXPECT_EQ(refusal([](State& s) { s.world.players = 8; }), impossible("world.players"));
  EXPECT_EQ(refusal([](State& s) { s.world.home_attacks = 0.5f; }), impossible("world.home_attacks"));
  EXPECT_EQ(refusal([](State& s) { s.book.last_toucher = 14; }), impossible("book.last_toucher"));
  EXPECT_EQ(refusal([](State& s) { s.book.kick_off_by = 14; }), impossible("book.kick_off_by"));
  EXPECT_EQ(refusal([](State& s) { s.robots[13].command.kick = motion::kMaxKicks; }),
            impossible("robots[13].command.kick"));
}

TEST(Snapshot, IsRefusedWithABoolThatIsNeitherTrueNorFalse) {
  // the two snapshots differ in the byte of the bool
  State state = test::scrambled(5);
  const Bytes bytes = snapshot_of(state);
  state.book.ball_free = !state.book.ball_free;
  const Bytes other = snapshot_of(state);
  const auto at =
      static_cast<std::size_t>(std::mismatch(bytes.begin(), bytes.end(), other.begin()).first - bytes.begin());
  Bytes spoilt = bytes;
  spoilt[at] = 2;
  seal(spoilt);
  EXPECT_EQ(restore(spoilt).refusal, "snapshot: book.ball_free has an impossible value");
}

}  // namespace
}  // namespace sim
