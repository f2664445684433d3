// No order, touch or sensor value makes the guardian break the body's limits.
#include "tests/support/guardian_laws.h"

#include <gtest/gtest.h>

#include <random>

namespace robot::nao {
namespace {

TEST(NaoGuardianLaws, HoldForRandomEvents) {
  int stood = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    tests::GuardianLaws laws;
    // the seed sets how often events happen; at times all is well again and the chest button is pressed
    const unsigned calm = 1 + seed % 8 * 10;
    for (int i = 0; i < 10'000; ++i) {
      auto byte = static_cast<std::uint8_t>(i % 1000 > 300 && random() % calm == 0 ? random() : 39);
      if (i % 1000 == 0) byte = 26;
      if (i % 1000 > 0 && i % 1000 < 13) byte = i % 4 < 2 ? 0 : 1;
      const std::string broken = laws.step(byte, static_cast<std::uint32_t>(random()));
      ASSERT_EQ(broken, "") << "seed " << seed << ", cycle " << i;
    }
    stood += laws.stood();
  }
  EXPECT_GT(stood, 10'000) << "it must stand often, or the laws would prove nothing";
}

}  // namespace
}  // namespace robot::nao
