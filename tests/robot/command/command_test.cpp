#include "robot/command/command.h"

#include <gtest/gtest.h>

namespace robot::command {
namespace {

/// A command `name` with one option, which counts its runs and returns `status`.
class Counting final : public Command {
 public:
  Counting(CLI::App& app, const char* name, int status, int& runs)
      : Command(app.add_subcommand(name)), status_(status), runs_(runs) {
    options().add_option("--size", size_)->check(CLI::Range(1, 9));
  }
  int run() override {
    ++runs_;
    return status_;
  }

 private:
  int size_ = 1;
  const int status_;
  int& runs_;
};

struct Program : testing::Test {
  Program() {
    app.require_subcommand(1);
    commands.push_back(std::make_unique<Counting>(app, "play", kDone, played));
    commands.push_back(std::make_unique<Counting>(app, "check", 1, checked));
  }

  int status_of(std::vector<const char*> words) {
    words.insert(words.begin(), "program");
    return run(app, commands, static_cast<int>(words.size()), words.data());
  }

  int played = 0, checked = 0;
  CLI::App app;
  Commands commands;
};

TEST_F(Program, RunsTheCommandThatTheLineNamesAndReturnsItsStatus) {
  EXPECT_EQ(status_of({"check", "--size", "3"}), 1);
  EXPECT_EQ(checked, 1);
  EXPECT_EQ(played, 0);
}

TEST_F(Program, AUsageErrorIsBadInputAndRunsNothing) {
  for (const std::vector<const char*>& words :
       std::initializer_list<std::vector<const char*>>{{}, {"sing"}, {"play", "--size", "10"}})
    EXPECT_EQ(status_of(words), kBadInput);
  EXPECT_EQ(played + checked, 0);
}

TEST_F(Program, HelpIsDoneAndRunsNothing) {
  EXPECT_EQ(status_of({"play", "--help"}), kDone);
  EXPECT_EQ(played + checked, 0);
}

}  // namespace
}  // namespace robot::command
