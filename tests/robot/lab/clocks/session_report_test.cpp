#include "robot/lab/clocks/session_report.h"

#include <gtest/gtest.h>

#include "robot/core/clock.h"
#include "robot/core/json_library.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/support/temporary_folder.h"

namespace robot::lab {
namespace {

using nlohmann::json;

struct Reported : testing::Test {
  const tests::TemporaryFolder folder;

  /// Reports a session with one message.
  SessionReport report(logging::SessionInfo info) {
    auto writer = logging::SessionWriter::create(folder / "s", std::move(info));
    EXPECT_TRUE((*writer)->write({.topic = "/14/2/ball"}, kSecond, "a"));
    EXPECT_TRUE((*writer)->close());
    return *inspect(folder / "s");
  }
};

TEST_F(Reported, ChosenObjectsAreNamedSoThatTheOthersAreNoLoss) {
  const SessionReport chosen = report({.robot = "14/2", .only = {"ball", "pose"}});
  EXPECT_NE(to_text(chosen).find("\nobjects  ball, pose; the others were left out by choice\n"), std::string::npos);
  EXPECT_EQ(to_json(chosen)["only"], json::array({"ball", "pose"}));
}

TEST_F(Reported, WithoutAChoiceNoneIsNamed) {
  const SessionReport all = report({.robot = "14/2"});
  EXPECT_EQ(to_text(all).find("objects"), std::string::npos);
  EXPECT_EQ(to_json(all)["only"], json::array());
}

TEST_F(Reported, ItsBeginningIsTheTimeOfDayAlsoIfTheClockWasSetAfterTheProgramBegan) {
  const SessionReport set = report({.robot = "14/2", .behind_ns = 180 * static_cast<std::int64_t>(kSecond)});
  EXPECT_NE(to_text(set).find("time     1970-01-01 00:03:01 UTC, 0.0 s\n"), std::string::npos) << to_text(set);
  EXPECT_NE(to_text(set).find("clock    it was set while the program ran: the recorded times are 180.0 s behind the "
                              "time of day\n"),
            std::string::npos);
  EXPECT_EQ(to_json(set)["behind_ns"], "180000000000");
  EXPECT_EQ(to_json(set)["start_ns"], "1000000000");
}

}  // namespace
}  // namespace robot::lab
