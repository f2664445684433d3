#include "sim/math/lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>
#include <random>
#include <vector>

namespace sim {
namespace {

#ifdef NDEBUG
constexpr int kRounds = 1'000'000 / kLanes;
#else
constexpr int kRounds = 5'000;  // without optimisation
#endif

struct Block {
  Lane<float> number;
  Lane<Vec2> point;
  DrawLanes draws;
  Lane<float> angle, luck, normal;
  Lane<Vec2> turned_point;
};

/// The formula of the test: something of everything that kernels use.
void compute(Block& block, const float& factor) {
  SIM_FOR_LANES(i) {
    const float angle = normalized(factor * block.number[i]);
    const auto words = block.draws.draw(i, Draw::walk_noise);
    const bool positive = block.number[i] > 0;
    block.angle[i] = angle;
    block.turned_point.set(i, select(positive, turned(block.point[i], direction(angle)), block.point[i]));
    block.luck[i] = uniform(words[0]);
    block.normal[i] = normals(words[1], words[2])[1];
  }
}

std::uint32_t bits(float x) { return x != x ? 0x7fc00000u : std::bit_cast<std::uint32_t>(x); }

/// All angles are within the range of `normalized`, and every kind of special number is among them.
float wild(std::mt19937& random) {
  using Limits = std::numeric_limits<float>;
  constexpr std::array kSpecial{0.f,   -0.f,        Limits::denorm_min(), -1e-40f, Limits::infinity(),
                                -kPi,  kPi,         Limits::quiet_NaN(),  1e-30f,  -Limits::infinity(),
                                1.57f, 3.14159274f, -3.14159298f};
  const std::uint32_t kind = random() % 64;
  if (kind < kSpecial.size()) return kSpecial[kind];
  return std::uniform_real_distribution<float>(-300, 300)(random);
}

TEST(Lanes, EachLaneHasTheBitsOfItsFormulaInVectorsOfEachWidth) {
  std::mt19937 random(1);
  for (int round = 0; round < kRounds; ++round) {
    Block narrow;
    std::array<std::uint64_t, kLanes> seeds;
    for (int i = 0; i < kLanes; ++i) {
      narrow.number[i] = wild(random);
      narrow.point.set(i, {wild(random), wild(random)});
      seeds[static_cast<std::size_t>(i)] = random() | std::uint64_t{random()} << 32;
      narrow.draws.set(i, {seeds[static_cast<std::size_t>(i)]}, i, static_cast<std::uint32_t>(random()));
    }
    Block wide = narrow;
    const float factor = 1.5f;
    detail::run_narrow<compute>(narrow, factor);
    if (detail::has_wide_lanes())
      detail::run_wide<compute>(wide, factor);
    else
      compute(wide, factor);
    for (int i = 0; i < kLanes; ++i) {
      const float number = narrow.number[i], angle = normalized(factor * number);
      const auto words = draw({seeds[static_cast<std::size_t>(i)]}, static_cast<std::uint32_t>(i), Draw::walk_noise,
                              narrow.draws.number[i]);
      const Vec2 point = number > 0 ? turned(narrow.point[i], direction(angle)) : narrow.point[i];
      for (const Block* block : {&narrow, &wide}) {
        ASSERT_EQ(bits(block->angle[i]), bits(angle)) << number;
        ASSERT_EQ(bits(block->turned_point[i].x), bits(point.x)) << number;
        ASSERT_EQ(bits(block->turned_point[i].y), bits(point.y)) << number;
        ASSERT_EQ(bits(block->luck[i]), bits(uniform(words[0])));
        ASSERT_EQ(bits(block->normal[i]), bits(normals(words[1], words[2])[1]));
      }
    }
  }
}

TEST(Lanes, NarrowLanesCanBeForced) {
  only_narrow_lanes = true;
  EXPECT_FALSE(detail::has_wide_lanes());
  only_narrow_lanes = false;
}

TEST(Lanes, AnyFindsEachLane) {
  for (int lane = 0; lane < kLanes; ++lane) {
    Lane<std::int32_t> lanes{};
    EXPECT_FALSE(any(lanes));
    lanes[lane] = lane % 2 == 0 ? 1 : -4;
    EXPECT_TRUE(any(lanes)) << lane;
  }
}

TEST(Lanes, BlocksHoldAllItemsInOrder) {
  for (std::size_t count = 0; count < 30; ++count) {
    std::vector<int> items(count);
    for (std::size_t i = 0; i < count; ++i) items[i] = static_cast<int>(i);
    std::vector<int> gathered, seen;
    in_blocks(
        std::span<const int>(items),
        [&](int item, int lane) {
          EXPECT_LT(lane, kLanes);
          EXPECT_EQ(lane, static_cast<int>(gathered.size() - seen.size()));
          gathered.push_back(item);
        },
        [&] { EXPECT_GT(gathered.size(), seen.size()); },
        [&](int item, int lane) {
          EXPECT_EQ(lane, static_cast<int>(seen.size()) % kLanes);
          seen.push_back(item);
        });
    EXPECT_EQ(gathered, items);
    EXPECT_EQ(seen, items);
  }
}

}  // namespace
}  // namespace sim
