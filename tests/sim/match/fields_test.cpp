#include "sim/match/fields.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "sim/match/hash.h"
#include "tests/sim/support/states.h"

namespace sim {
namespace {

std::vector<std::string> names_of(const State& state) {
  std::vector<std::string> names;
  visit_fields(state, [&](const FieldPath& path, auto) { names.push_back(path.text()); });
  return names;
}

/// Returns `state` with another value in field number `wanted`.
State changed(State state, std::size_t wanted) {
  std::size_t i = 0;
  visit_fields(state, [&](const FieldPath&, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    if (i++ == wanted) field = static_cast<Field>(field == Field{} ? static_cast<Field>(1) : Field{});
  });
  return state;
}

TEST(Fields, HaveDifferentNames) {
  const auto names = names_of(State{});
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(names.front(), "world.key.seed");
  EXPECT_EQ(std::count(names.begin(), names.end(), "robots[3].beliefs.ball.position.x"), 1);
}

TEST(Fields, AreAllOfTheStateWithoutPadding) {
  std::size_t size = 0;
  const State any{};
  visit_fields(any, [&](const FieldPath&, auto field) { size += sizeof field; });
  EXPECT_LE(size, sizeof(State));
  EXPECT_GT(size, sizeof(State) * 9 / 10);
}

TEST(Difference, IsTheNameOfTheFirstFieldThatDiffers) {
  const State state = test::scrambled(1);
  const auto names = names_of(state);
  EXPECT_EQ(difference(state, state), "");
  for (std::size_t i = 0; i + 1 < names.size(); i += 7) {
    EXPECT_EQ(difference(state, changed(state, i)), names[i]);
    EXPECT_EQ(difference(state, changed(changed(state, i), names.size() - 1)), names[i]);
  }
}

TEST(Difference, TakesMinusZeroForZero) {
  State state{}, other{};
  other.world.ball.position.y = -0.f;
  EXPECT_EQ(difference(state, other), "");
}

TEST(Hash, DiffersWithEveryField) {
  const State state = test::scrambled(2);
  std::set<std::uint64_t> hashes{hash_of(state)};
  const std::size_t count = names_of(state).size();
  for (std::size_t i = 0; i < count; i += 3) hashes.insert(hash_of(changed(state, i)));
  EXPECT_EQ(hashes.size(), 1 + (count + 2) / 3);
}

TEST(Hash, IgnoresPadding) {
  const State state = test::scrambled(3);
  alignas(State) unsigned char memory[sizeof(State)];
  std::fill(std::begin(memory), std::end(memory), static_cast<unsigned char>(0xa5));
  State* other = new (memory) State(test::scrambled(4));
  *other = state;
  EXPECT_EQ(hash_of(*other), hash_of(state));
}

TEST(Hash, ChangesHalfOfItsBitsForOneBit) {
  const State state = test::scrambled(5);
  const std::uint64_t hash = hash_of(state);
  int moved = 0;
  for (Tick bit = 0; bit < 32; ++bit) {
    State other = state;
    other.world.tick ^= Tick{1} << bit;
    moved += std::popcount(hash ^ hash_of(other));
  }
  EXPECT_NEAR(moved, 32 * 32, 150);
}

TEST(Hex, IsSixteenDigits) {
  EXPECT_EQ(hex(0), "0000000000000000");
  EXPECT_EQ(hex(0x0123456789abcdef), "0123456789abcdef");
}

}  // namespace
}  // namespace sim
