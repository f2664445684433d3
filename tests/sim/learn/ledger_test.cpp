#include "sim/learn/ledger.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/support/temporary_folder.h"

namespace sim::learn {
namespace {

const std::vector<Score> kScores{
    {0.1f, true}, {-2, false}, {std::numeric_limits<float>::denorm_min(), true}, {1e30f, false}};

TEST(Ledger, KeepsScoresToTheBit) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "ledger.txt";
  {
    Ledger ledger = *Ledger::open(file);
    EXPECT_EQ(ledger.find(7), nullptr);
    ASSERT_TRUE(ledger.add(7, kScores));
    ASSERT_TRUE(ledger.add(0xffffffffffffffffu, {{1, true}}));
    EXPECT_EQ(*ledger.find(7), kScores);
  }
  const Ledger again = *Ledger::open(file);
  EXPECT_EQ(again.size(), 2u);
  EXPECT_EQ(*again.find(7), kScores);
  EXPECT_EQ(again.find(0xffffffffffffffffu)->size(), 1u);
}

TEST(Ledger, ALineThatAKillCutOffIsDroppedAndWrittenAgain) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "ledger.txt";
  {
    Ledger ledger = *Ledger::open(file);
    ASSERT_TRUE(ledger.add(1, kScores));
    ASSERT_TRUE(ledger.add(2, kScores));
  }
  const auto size = std::filesystem::file_size(file);
  for (std::uintmax_t cut = 1; cut < size / 2; ++cut) {
    std::filesystem::resize_file(file, size - cut);
    Ledger ledger = *Ledger::open(file);
    EXPECT_NE(ledger.find(1), nullptr);
    EXPECT_EQ(ledger.find(2), nullptr);
    ASSERT_TRUE(ledger.add(2, kScores));
    EXPECT_EQ(std::filesystem::file_size(file), size);
  }
}

TEST(Ledger, ADamagedLineIsNamed) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "ledger.txt";
  for (const char* damaged : {"xyz 1\n", "0000000000000001\n", "0000000000000001 a\n", "0000000000000001  1\n", "\n"}) {
    std::ofstream(file) << "0000000000000007 1 2+\n" << damaged;
    const auto ledger = Ledger::open(file);
    ASSERT_FALSE(ledger) << damaged;
    EXPECT_NE(ledger.error().find("line 2 must be a key and scores"), std::string::npos) << ledger.error();
  }
}

TEST(Ledger, AFolderThatIsNotThereIsAnError) { EXPECT_FALSE(Ledger::open("/nowhere/at/all/ledger.txt")); }

}  // namespace
}  // namespace sim::learn
