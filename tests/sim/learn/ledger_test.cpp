#include "sim/learn/ledger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

#include "tests/support/temporary_folder.h"

namespace sim::learn {
namespace {

const std::vector<Score> kScores{
    {0.1f, true}, {-2, false}, {std::numeric_limits<float>::denorm_min(), true}, {1e30f, false}};

TEST(Ledger, KeepsScoresToTheBit) {
  const tests::TemporaryFolder folder;
  {
    Ledger ledger = *Ledger::open(folder.path());
    EXPECT_EQ(ledger.find(7), nullptr);
    ASSERT_TRUE(ledger.add(7, kScores));
    ASSERT_TRUE(ledger.add(0xffffffffffffffffu, {{1, true}}));
    EXPECT_EQ(*ledger.find(7), kScores);
  }
  const Ledger again = *Ledger::open(folder.path());
  EXPECT_EQ(again.size(), 2u);
  EXPECT_EQ(*again.find(7), kScores);
  EXPECT_EQ(again.find(0xffffffffffffffffu)->size(), 1u);
}

TEST(Ledger, ALineThatAKillCutOffIsDroppedAndWrittenAgain) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "ledger-0.txt";
  {
    Ledger ledger = *Ledger::open(folder.path());
    ASSERT_TRUE(ledger.add(1, kScores));
    ASSERT_TRUE(ledger.add(2, kScores));
  }
  const auto size = std::filesystem::file_size(file);
  for (std::uintmax_t cut = 1; cut < size / 2; ++cut) {
    std::filesystem::resize_file(file, size - cut);
    Ledger ledger = *Ledger::open(folder.path());
    EXPECT_NE(ledger.find(1), nullptr);
    EXPECT_EQ(ledger.find(2), nullptr);
    ASSERT_TRUE(ledger.add(2, kScores));
    EXPECT_EQ(std::filesystem::file_size(file), size);
  }
}

TEST(Ledger, ADamagedLineIsNamed) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "ledger-0.txt";
  for (const char* damaged : {"xyz 1\n", "0000000000000001\n", "0000000000000001 a\n", "0000000000000001  1\n", "\n"}) {
    std::ofstream(file) << "0000000000000007 1 2+\n" << damaged;
    const auto ledger = Ledger::open(folder.path());
    ASSERT_FALSE(ledger) << damaged;
    EXPECT_NE(ledger.error().find("line 2 must be a key and scores"), std::string::npos) << ledger.error();
  }
}

TEST(Ledger, ProcessesReadWhatOthersWrote) {
  const tests::TemporaryFolder folder;
  Ledger first = *Ledger::open(folder.path(), {0, 2}), second = *Ledger::open(folder.path(), {1, 2});
  ASSERT_TRUE(first.add(1, kScores));
  EXPECT_EQ(second.find(1), nullptr);
  ASSERT_TRUE(second.refresh());
  ASSERT_NE(second.find(1), nullptr);
  EXPECT_EQ(*second.find(1), kScores);
  // a line that is still being written is read when it is whole
  std::ofstream other(folder.path() / "ledger-7.txt");
  (other << "000000000000000").flush();
  ASSERT_TRUE(second.refresh());
  (other << "2 1.5+").flush();
  ASSERT_TRUE(second.refresh());
  EXPECT_EQ(second.find(2), nullptr);
  (other << "\n").flush();
  ASSERT_TRUE(second.refresh());
  EXPECT_EQ(*second.find(2), (std::vector<Score>{{1.5f, true}}));
  // both have played the same task: one line is enough
  const auto size = std::filesystem::file_size(folder.path() / "ledger-1.txt");
  ASSERT_TRUE(second.add(1, kScores));
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "ledger-1.txt"), size);
}

TEST(Ledger, AShareHasOneProcess) {
  const tests::TemporaryFolder folder;
  const Ledger ledger = *Ledger::open(folder.path(), {1, 3});
  const auto second = Ledger::open(folder.path(), {1, 3});
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().find("another process is working on it"), std::string::npos) << second.error();
  EXPECT_TRUE(Ledger::open(folder.path(), {2, 3}));
}

TEST(Ledger, DamageInAnotherLedgerIsNamed) {
  const tests::TemporaryFolder folder;
  Ledger ledger = *Ledger::open(folder.path());
  std::ofstream(folder.path() / "ledger-3.txt") << "0000000000000007 1 2+\nnonsense\n";
  const auto read = ledger.refresh();
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().find("ledger-3.txt: line 2 must be"), std::string::npos) << read.error();
}

TEST(Ledger, AFolderThatIsNotThereIsAnError) { EXPECT_FALSE(Ledger::open("/nowhere/at/all")); }

TEST(Share, EachProcessTakesUpEachTaskOnceAndItsOwnFirst) {
  EXPECT_EQ(order_of(6, {0, 1}), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(order_of(6, {1, 3}), (std::vector<std::size_t>{2, 3, 1, 0, 5, 4}));
  for (const std::size_t tasks : {0u, 1u, 5u, 64u})
    for (int of = 1; of < 9; ++of) {
      std::set<std::size_t> begun;
      for (int number = 0; number < of; ++number) {
        const std::vector<std::size_t> order = order_of(tasks, {number, of});
        EXPECT_EQ(order.size(), tasks);
        EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), tasks);
        if (!order.empty()) begun.insert(order.front());
      }
      // they begin at different tasks while there are enough
      EXPECT_GE(begun.size(), std::min(tasks, static_cast<std::size_t>(of)));
    }
}

}  // namespace
}  // namespace sim::learn
