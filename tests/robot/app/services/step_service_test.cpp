#include "robot/app/services/step_service.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "robot/body/replay/replay.h"
#include "robot/core/byte_sink.h"
#include "robot/core/clock.h"
#include "robot/core/json_library.h"
#include "robot/logging/mcap/writer.h"
#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

using nlohmann::json;

constexpr std::uint64_t kStart = 1'700'000'000 * kSecond;

/// A recording whose topic has many chunks, messages of one time, and gaps.
struct StepService : testing::Test {
  StepService() {
    std::mt19937 random(7);
    const memory::ChannelInfo infos[] = {{.topic = "/14/2/ball", .message_encoding = "json", .schema = {}},
                                         {.topic = "/14/2/pose", .message_encoding = "json", .schema = {}}};
    auto writer = logging::McapWriter::open(std::move(*FileSink::create(folder / "game.mcap")), infos,
                                            {.metadata = {}, .chunk_bytes = 256});
    EXPECT_TRUE(writer);
    std::uint64_t time_ns = kStart;
    for (std::uint64_t i = 0; i < 300; ++i) {
      time_ns += random() % 3 * 33'000'000;  // 0: the same time
      EXPECT_TRUE(writer->write(0, {.sequence = i, .capture_ns = time_ns, .publish_ns = time_ns, .bytes = "{}"}, 0));
      EXPECT_TRUE(
          writer->write(1, {.sequence = i, .capture_ns = time_ns + 5, .publish_ns = time_ns + 5, .bytes = "{}"}, 0));
      times_ns.push_back(time_ns);
    }
    EXPECT_TRUE(writer->close());
    times_ns.erase(std::unique(times_ns.begin(), times_ns.end()), times_ns.end());
    auto opened = body::Replay::open({folder / "game.mcap"}, {});
    EXPECT_TRUE(opened) << opened.error();
    replay = std::move(*opened);
    add_step_service(services, [this](const std::string& topic) { return replay->stream_of(topic); });
  }

  json call(const json& request) const {
    return json::parse(services.call(1, request.dump(), {.loopback = true, .may_control = true}));
  }
  std::uint64_t step(std::uint64_t from_ns, std::int64_t by) const {
    const json said = call({{"topic", "/14/2/ball"}, {"from_ns", std::to_string(from_ns)}, {"by", by}});
    EXPECT_EQ(said["ok"], true) << said;
    return std::stoull(said.value("at_ns", "0"));
  }
  /// The same, found in the list of all times.
  std::uint64_t expected(std::uint64_t from_ns, std::int64_t by) const {
    std::uint64_t at_ns = from_ns;
    for (; by > 0; --by)
      if (const auto after = std::ranges::upper_bound(times_ns, at_ns); after != times_ns.end()) at_ns = *after;
    for (; by < 0; ++by)
      if (const auto at = std::ranges::lower_bound(times_ns, at_ns); at != times_ns.begin()) at_ns = *std::prev(at);
    return at_ns;
  }
  std::string refusal(const json& request) const {
    const json said = call(request);
    EXPECT_EQ(said["ok"], false);
    return said.value("error", "");
  }

  const tests::TemporaryFolder folder;
  std::vector<std::uint64_t> times_ns;
  std::unique_ptr<body::Replay> replay;
  net::Services services;
};

TEST_F(StepService, FindsTheMessageAnyNumberOfStepsAwayFromAnyMoment) {
  std::mt19937 random(11);
  for (int i = 0; i < 300; ++i) {
    const std::uint64_t message_ns = times_ns[random() % times_ns.size()];
    const std::uint64_t from_ns = i % 3 == 0 ? message_ns : message_ns - 1 + i % 3;
    const auto by = static_cast<std::int64_t>(random() % (2 * kLongestStep + 1)) - kLongestStep;
    EXPECT_EQ(step(from_ns, by), expected(from_ns, by)) << from_ns << " by " << by;
  }
}

TEST_F(StepService, EndsAtTheFirstAndTheLastMessage) {
  EXPECT_EQ(step(times_ns[1], -5), times_ns.front());
  EXPECT_EQ(step(times_ns.front(), -1), times_ns.front());
  EXPECT_EQ(step(kStart - kSecond, -1), kStart - kSecond) << "no message lies before";
  EXPECT_EQ(step(0, 1), times_ns.front());
  EXPECT_EQ(step(times_ns.back() - 1, 100), times_ns.back());
  EXPECT_EQ(step(times_ns.back(), 1), times_ns.back());
  EXPECT_EQ(step(UINT64_MAX, -1), times_ns.back());
  EXPECT_EQ(step(UINT64_MAX, 1), UINT64_MAX);
}

TEST_F(StepService, RefusesARequestThatNamesNoStep) {
  EXPECT_EQ(refusal({{"from_ns", "1"}, {"by", 1}}), "message_beside: 'topic' must be a text");
  EXPECT_EQ(refusal({{"topic", "/14/2/ball"}, {"from_ns", 1}, {"by", 1}}),
            "message_beside: 'from_ns' must be a text with a whole number");
  for (const json& by : {json(1.5), json("1"), json(101), json(-101), json()})
    EXPECT_EQ(refusal({{"topic", "/14/2/ball"}, {"from_ns", "1"}, {"by", by}}),
              "message_beside: 'by' must be a whole number from -100 to 100");
  EXPECT_EQ(refusal({{"topic", "/x"}, {"from_ns", "1"}, {"by", 1}}), "message_beside: topic '/x' is not played");
}

TEST_F(StepService, IsForClientsThatMayControl) {
  const json said = json::parse(services.call(1, "{}", {}));
  EXPECT_EQ(said["ok"], false);
}

}  // namespace
}  // namespace robot::app
