#include "sim/contest/run_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace sim::contest {
namespace {

using Pairs = std::vector<compare::Pair>;
using Use = RunFolder::Use;

constexpr const char* kRun = R"({"a":"baseline","b":"kick_now"})";

/// A block of pairs without two equal numbers in a row.
Pairs some_pairs(int first) {
  Pairs pairs(static_cast<std::size_t>(RunFolder::kPairsPerBlock));
  for (compare::Pair& pair : pairs)
    for (compare::GameResult& game : pair.games) {
      game = {.gain = first - 30, .goals = {first, first + 1}, .conceded = {first + 2, first + 3}};
      ++first;
    }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].same = i % 3 == 0;
    pairs[i].hash = 0xfedcba9876543210u + i;
  }
  return pairs;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class RunFolders : public testing::Test {
 protected:
  RunFolder open(const std::string& name, Use use = Use::begin, const std::string& specification = kRun) {
    auto run = RunFolder::open(root_ / name, specification, use);
    EXPECT_TRUE(run) << run.error();
    return *std::move(run);
  }
  std::string error_of_open(const std::string& name, Use use, const std::string& specification = kRun) {
    const auto run = RunFolder::open(root_ / name, specification, use);
    return run ? "" : run.error();
  }
  std::filesystem::path block(const std::string& name, int number) const {
    return root_ / name / ("block-0000000" + std::to_string(number) + ".json");
  }
  static std::string error_of(const RunFolder& run, std::int64_t block) {
    const auto pairs = run.read(block);
    return pairs ? "" : pairs.error();
  }

  tests::TemporaryFolder folder_;
  std::filesystem::path root_ = folder_.path();
};

TEST_F(RunFolders, ReturnTheBlocksThatWereWritten) {
  const RunFolder run = open("run");
  EXPECT_EQ(run.blocks(), 0);
  for (const int number : {2, 0}) ASSERT_TRUE(run.write(number, some_pairs(number)));
  EXPECT_EQ(run.blocks(), 3);
  EXPECT_TRUE(run.has(0));
  EXPECT_FALSE(run.has(1));
  for (const int number : {0, 2}) EXPECT_EQ(*run.read(number), some_pairs(number));
}

TEST_F(RunFolders, RefuseEveryDamage) {
  const RunFolder run = open("run");
  ASSERT_TRUE(run.write(0, some_pairs(40)));
  const std::string whole = text_of(block("run", 0)), place = "block " + block("run", 0).string() + ": ";
  for (std::size_t length = 0; length + 1 < whole.size(); length += 7) {
    std::ofstream(block("run", 0)) << whole.substr(0, length);
    EXPECT_EQ(error_of(run, 0), place + "is damaged") << length;
  }
  std::string changed = whole;
  *std::find(changed.begin() + static_cast<long>(changed.find("pairs")), changed.end(), '4') = '5';
  std::ofstream(block("run", 0)) << changed;
  EXPECT_EQ(error_of(run, 0), place + "its pairs do not have its hash");
}

TEST_F(RunFolders, RefuseABlockOfAnotherRunAndABlockWithAnotherNumber) {
  const RunFolder run = open("run"), other = open("other", Use::begin, R"({"a":"baseline","b":"idle"})");
  ASSERT_TRUE(other.write(0, some_pairs(0)));
  std::filesystem::copy_file(block("other", 0), block("run", 0));
  EXPECT_EQ(error_of(run, 0),
            "block " + block("run", 0).string() + ": belongs to another run, or to another build of it");
  std::filesystem::copy_file(block("other", 0), block("other", 1));
  EXPECT_EQ(error_of(other, 1), "block " + block("other", 1).string() + ": is another block than its name says");
}

TEST_F(RunFolders, RefuseABlockWithTooFewPairs) {
  const RunFolder run = open("run");
  Pairs pairs = some_pairs(0);
  pairs.pop_back();
  ASSERT_TRUE(run.write(0, pairs));
  EXPECT_EQ(error_of(run, 0), "block " + block("run", 0).string() + ": holds another number of pairs than a block has");
}

TEST_F(RunFolders, BelongToOneComparison) {
  const std::string place = "run " + (root_ / "run").string() + ": ";
  open("run");
  EXPECT_EQ(error_of_open("run", Use::begin), place + "it exists already; --resume continues it");
  EXPECT_EQ(error_of_open("run", Use::go_on), "");
  EXPECT_EQ(error_of_open("run", Use::go_on, "{}"),
            place + "expected nothing or the same comparison on the same build, got another one; choose another --out");
}

TEST_F(RunFolders, RefuseARunOfAnotherFormat) {
  const std::string place = "run " + (root_ / "run").string() + ": ";
  open("run");
  EXPECT_EQ(error_of_open("run", Use::go_on, R"({"format":2,"a":"baseline","b":"kick_now"})"),
            place + "expected format 2, got format 1 of another version of this program; choose another --out");
}

TEST_F(RunFolders, HaveOneUserUnlessAllShare) {
  const std::string place = "run " + (root_ / "run").string() + ": ";
  {
    const RunFolder alone = open("run");
    for (const Use use : {Use::go_on, Use::share})
      EXPECT_EQ(error_of_open("run", use), place + "another process is working on it");
  }
  const RunFolder shared = open("run", Use::share);
  EXPECT_EQ(error_of_open("run", Use::share), "");
  EXPECT_EQ(error_of_open("run", Use::go_on), place + "another process is working on it");
}

}  // namespace
}  // namespace sim::contest
