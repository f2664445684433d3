#include "sim/math/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace {

using sim::draw;
using sim::Draw;
using Words = std::array<std::uint32_t, 4>;

constexpr sim::RandomKey kKey{20250715};

/// Philox4x32 with 7 rounds, written from the paper: the reference for the library.
Words philox(Words counter, std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 7; ++round) {
    const std::uint64_t first = 0xD2511F53ull * counter[0], second = 0xCD9E8D57ull * counter[2];
    counter = {static_cast<std::uint32_t>(second >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(second),
               static_cast<std::uint32_t>(first >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(first)};
    key = {key[0] + 0x9E3779B9u, key[1] + 0xBB67AE85u};
  }
  return counter;
}

/// Returns the chi-square of counts that should be equal, in standard deviations from its expected value.
double surprise(const std::vector<int>& counts) {
  double total = 0, squares = 0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  for (const int count : counts) squares += (count - expected) * (count - expected) / expected;
  const auto freedom = static_cast<double>(counts.size() - 1);
  return (squares - freedom) / std::sqrt(2 * freedom);
}

TEST(Random, ReferenceGivesThePublishedAnswers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x5f6fb709, 0x0d893f64, 0x4f121f81, 0x4f730a48}));
  const std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}), (Words{0x5207ddc2, 0x45165e59, 0x4d8ee751, 0x8c52f662}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0x4dfccaba, 0x190a87f0, 0xc47362ba, 0xb6b5242a}));
}

TEST(Random, DrawIsPhiloxOfSeedRobotPurposeAndNumber) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const std::uint64_t seed = 0x9876543210fedcbaull * i;
    const auto event = static_cast<Draw>(i % 19 + 1);
    EXPECT_EQ(draw({seed}, i % 14, event, i * 77777u),
              philox({i * 77777u, i % 19 + 1, i % 14, 0},
                     {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}));
  }
}

TEST(Random, EveryPartOfTheAddressCounts) {
  std::set<Words> seen;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    for (const std::uint64_t high : {0ull, 1ull << 32})
      for (std::uint32_t robot = 0; robot < 14; ++robot)
        for (std::uint32_t event = 1; event <= 19; ++event)
          for (std::uint32_t number = 0; number < 10; ++number)
            seen.insert(draw({seed + high}, robot, static_cast<Draw>(event), number));
  EXPECT_EQ(seen.size(), 4u * 2 * 14 * 19 * 10);
}

TEST(Random, UniformIsInRangeAndEvenlyDistributed) {
  EXPECT_EQ(sim::uniform(0), 0);
  EXPECT_LT(sim::uniform(0xffffffff), 1);
  std::vector<int> counts(100);
  double sum = 0, squares = 0;
  constexpr int kDraws = 100000;
  for (std::uint32_t tick = 0; tick < kDraws; ++tick)
    for (const std::uint32_t word : draw(kKey, 3, Draw::ball_seen, tick)) {
      const float value = sim::uniform(word);
      ++counts[static_cast<std::size_t>(value * 100)];
      sum += value;
      squares += value * value;
    }
  EXPECT_LT(std::fabs(surprise(counts)), 3.5);
  EXPECT_NEAR(sum / (4 * kDraws), 0.5, 0.002);
  EXPECT_NEAR(squares / (4 * kDraws), 1. / 3, 0.002);
}

/// Checks by chi-square, on a grid of 16 x 16, that the words of two neighbouring addresses are independent.
template <class Other>
void expect_independent(Other&& other) {
  for (std::size_t word = 0; word < 4; ++word) {
    std::vector<int> counts(256);
    for (std::uint32_t tick = 0; tick < 50000; ++tick)
      ++counts[(draw(kKey, 2, Draw::walk_noise, tick)[word] >> 28) * 16 + (other(tick)[word] >> 28)];
    EXPECT_LT(std::fabs(surprise(counts)), 3.5) << "word " << word;
  }
}

TEST(Random, NeighbouringTicksAreIndependent) {
  expect_independent([](std::uint32_t tick) { return draw(kKey, 2, Draw::walk_noise, tick + 1); });
}

TEST(Random, NeighbouringRobotsAreIndependent) {
  expect_independent([](std::uint32_t tick) { return draw(kKey, 3, Draw::walk_noise, tick); });
}

TEST(Random, NeighbouringPurposesAreIndependent) {
  expect_independent([](std::uint32_t tick) { return draw(kKey, 2, Draw::kick_noise, tick); });
}

TEST(Random, NeighbouringSeedsAreIndependent) {
  expect_independent([](std::uint32_t tick) { return draw({kKey.seed + 1}, 2, Draw::walk_noise, tick); });
}

TEST(Random, WordsOfOneDrawAreIndependent) {
  expect_independent([](std::uint32_t tick) {
    const Words words = draw(kKey, 2, Draw::walk_noise, tick);
    return Words{words[1], words[2], words[3], words[0]};
  });
}

TEST(Random, NormalsHaveTheMomentsAndTailsOfTheirDistribution) {
  constexpr int kDraws = 200000;
  double sum = 0, squares = 0, cubes = 0, fourths = 0, products = 0;
  int beyond[4] = {};
  for (std::uint32_t tick = 0; tick < kDraws; ++tick) {
    const Words words = draw(kKey, 1, Draw::ball_noise, tick);
    for (const auto& [x, y] : {sim::normals(words[0], words[1]), sim::normals(words[2], words[3])}) {
      products += x * y;
      for (const double value : {static_cast<double>(x), static_cast<double>(y)}) {
        sum += value;
        squares += value * value;
        cubes += value * value * value;
        fourths += value * value * value * value;
        for (int sigma = 1; sigma < 4; ++sigma) beyond[sigma] += std::fabs(value) > sigma;
      }
    }
  }
  constexpr double kCount = 4. * kDraws;
  EXPECT_NEAR(sum / kCount, 0, 0.005);
  EXPECT_NEAR(squares / kCount, 1, 0.007);
  EXPECT_NEAR(cubes / kCount, 0, 0.02);
  EXPECT_NEAR(fourths / kCount, 3, 0.05);
  EXPECT_NEAR(products / (kCount / 2), 0, 0.007);
  EXPECT_NEAR(beyond[1] / kCount, 0.31731, 0.003);
  EXPECT_NEAR(beyond[2] / kCount, 0.04550, 0.0015);
  EXPECT_NEAR(beyond[3] / kCount, 0.00270, 0.0004);
}

TEST(Random, NormalsHaveEveryDirectionEquallyOften) {
  std::vector<int> counts(64);
  for (std::uint32_t tick = 0; tick < 200000; ++tick) {
    const Words words = draw(kKey, 1, Draw::ball_noise, tick);
    const auto [x, y] = sim::normals(words[0], words[1]);
    ++counts[static_cast<std::size_t>((std::atan2(y, x) / (2 * sim::kPi) + 0.5f) * 63.999f)];
  }
  EXPECT_LT(std::fabs(surprise(counts)), 3.5);
}

TEST(Random, NormalsStayBelowSix) {
  for (const std::uint32_t first : {0u, 255u, 256u, 0x80000000u, 0xffffffffu})
    for (const std::uint32_t second : {0u, 1u, 0x1fffffffu, 0x20000000u, 0x3fffffffu, 0x80000000u, 0xffffffffu})
      for (const float value : sim::normals(first, second)) EXPECT_LT(std::fabs(value), 6) << first << ' ' << second;
}

}  // namespace
