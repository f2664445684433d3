#include "robot/app/whole_answers.h"

#include <gtest/gtest.h>

#include "robot/core/clock.h"
#include "robot/core/json_library.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/times.h"

namespace robot::app {
namespace {

using nlohmann::json;

using tests::kNow;

struct WholeAnswers : testing::Test {
  WholeAnswers() {
    auto writer = logging::SessionWriter::create(folder / "recorded", {.robot = "14/2", .team = 14, .player = 2});
    EXPECT_TRUE(writer);
    for (std::uint64_t i = 0; i <= 100; ++i)
      EXPECT_TRUE((*writer)->write({.topic = "/14/2/x", .message_encoding = "json", .schema = {}}, kNow + i * kSecond,
                                   R"({"n":)" + std::to_string(i) + R"(,"word":")" + (i < 50 ? "a" : "b") + "\"}"));
    EXPECT_TRUE((*writer)->close());
    auto opened = body::Replay::open({folder / "recorded"}, {});
    EXPECT_TRUE(opened) << opened.error();
    replay = std::move(*opened);
    whole.emplace(*replay);
  }
  net::HttpResponse get(
      const std::string& target, const net::ClientLeft& left = [] { return false; }) {
    const auto parsed = net::parse_target("/api/whole/" + target);
    EXPECT_TRUE(parsed) << target;
    return whole_answer(*whole, *parsed, left);
  }
  json ask(const std::string& target) {
    const net::HttpResponse response = get(target);
    EXPECT_EQ(response.status, 200) << target;
    return json::parse(std::get<std::string>(response.body));
  }
  std::string refusal(const std::string& target) {
    const net::HttpResponse response = get(target);
    EXPECT_EQ(response.status, 400) << target;
    return std::get<std::string>(response.body);
  }

  const tests::TemporaryFolder folder;
  std::unique_ptr<body::Replay> replay;
  std::optional<lab::WholeRecording> whole;
};

TEST_F(WholeAnswers, NumbersAreListsWithAnEntryForEachInterval) {
  const json all = ask("numbers?fields=/14/2/x.n+/14/2/x.none&intervals=2");
  EXPECT_EQ(all["from"], std::to_string(kNow));
  EXPECT_EQ(all["damages"], 0);
  const json& n = all["fields"][0];
  EXPECT_EQ(n["field"], "/14/2/x.n");
  ASSERT_EQ(n["least"].size(), 2u);
  EXPECT_EQ(n["least"][0], 0);
  EXPECT_EQ(n["most"][1], 100);
  EXPECT_EQ(n["mean"][0].get<double>() + n["most"][0].get<double>() / 2, n["most"][0].get<double>());
  EXPECT_TRUE(all["fields"][1]["mean"][0].is_null());
  const json part = ask("numbers?fields=/14/2/x.n&from=" + std::to_string(kNow + 10 * kSecond) +
                        "&to=" + std::to_string(kNow + 12 * kSecond) + "&intervals=4096");
  json found = json::array();
  for (const json& value : part["fields"][0]["mean"])
    if (!value.is_null()) found.push_back(value);
  EXPECT_EQ(found, (json{10, 11, 12}));
}

TEST_F(WholeAnswers, RunsNameTheirWordsOnce) {
  EXPECT_EQ(ask("runs?topic=/14/2/x&fields=word"),
            (json{{"from", std::to_string(kNow)},
                  {"words", {"a", "b"}},
                  {"full", false},
                  {"runs", {{0, 50 * kSecond, 0}, {50 * kSecond, 50 * kSecond, 1}}}}));
}

TEST_F(WholeAnswers, EventsOfARecordingWithoutOurObjectsAreNone) {
  EXPECT_EQ(ask("events"), (json{{"events", json::array()}, {"full", false}, {"damages", 0}}));
}

TEST_F(WholeAnswers, AWrongRequestGetsOneSentence) {
  EXPECT_EQ(refusal("numbers"), "whole: expected 1 to 16 fields such as fields=/14/2/ball.x, got 0\n");
  EXPECT_NE(refusal("numbers?fields=/9/9/x.n").find("a topic that is played, got '/9/9/x.n'"), std::string::npos);
  EXPECT_NE(refusal("numbers?fields=/14/2/x.%5B").find("expected a field"), std::string::npos);
  EXPECT_NE(refusal("numbers?fields=/14/2/x.n&from=noon").find("for 'from', got 'noon'"), std::string::npos);
  EXPECT_NE(refusal("numbers?fields=/14/2/x.n&to=99999999999999999999999").find("for 'to'"), std::string::npos);
  EXPECT_NE(refusal("numbers?fields=/14/2/x.n&from=9&to=8").find("got 9 and 8"), std::string::npos);
  for (const char* intervals : {"0", "4097", "-1", "1.5"})
    refusal("numbers?fields=/14/2/x.n&intervals=" + std::string(intervals));
  std::string many;
  for (int i = 0; i < 17; ++i) many += "/14/2/x.n+";
  refusal("numbers?fields=" + many);
  refusal("runs?fields=word");
  refusal("runs?topic=/14/2/x");
  refusal("runs?topic=/14/2/y&fields=word");
  EXPECT_EQ(get("nothing").status, 404);
}

TEST_F(WholeAnswers, AClientThatHasLeftGetsNothing) {
  EXPECT_EQ(get("runs?topic=/14/2/x&fields=word", [] { return true; }).status, 503);
}

}  // namespace
}  // namespace robot::app
