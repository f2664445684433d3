#include "robot/lab/whole/whole_recording.h"

#include <gtest/gtest.h>

#include <fstream>

#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/runtime.pb.h"
#include "proto/foresight/sim.pb.h"
#include "robot/core/byte_sink.h"
#include "robot/core/clock.h"
#include "robot/logging/mcap/mcap_file.h"
#include "robot/logging/mcap/writer.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/memory/schema.h"
#include "tests/support/temporary_folder.h"

namespace robot::lab {
namespace {

namespace pb = foresight;

constexpr std::uint64_t kStart = 1'700'000'000 * kSecond;
constexpr std::uint64_t at(double seconds) { return kStart + static_cast<std::uint64_t>(seconds * 1e9); }

const memory::ChannelInfo kBall{.topic = "/14/2/ball", .message_encoding = "json", .schema = {}};
const memory::ChannelInfo kPose{.topic = "/14/2/pose", .message_encoding = "json", .schema = {}};

template <class Message>
memory::ChannelInfo info_of(const std::string& topic) {
  return {.topic = topic, .schema = memory::schema_of(*Message::descriptor())};
}

/// A message for the file of a test.
struct Written {
  memory::ChannelInfo info;
  std::uint64_t at_ns;
  std::string bytes;
};

/// 100 s of a ball whose x is the number of the message, ten times a second, and of a pose with y = -x.
std::vector<Written> ball_and_pose() {
  std::vector<Written> written;
  for (int i = 0; i <= 1000; ++i) {
    written.push_back(
        {kBall, at(0.1 * i), R"({"x":)" + std::to_string(i) + R"(,"skill":")" + (i < 500 ? "walk" : "kick") + R"("})"});
    written.push_back({kPose, at(0.1 * i), R"({"y":)" + std::to_string(-i) + "}"});
  }
  return written;
}

void write_session(const std::filesystem::path& folder, const std::vector<Written>& messages) {
  auto writer = logging::SessionWriter::create(folder, {.robot = "14/2", .team = 14, .player = 2});
  ASSERT_TRUE(writer);
  for (const auto& [info, at_ns, bytes] : messages) ASSERT_TRUE((*writer)->write(info, at_ns, bytes));
  ASSERT_TRUE((*writer)->close());
}

void write_file(const std::filesystem::path& path, const std::vector<Written>& messages) {
  std::vector<memory::ChannelInfo> infos;
  for (const Written& one : messages)
    if (std::ranges::find(infos, one.info) == infos.end()) infos.push_back(one.info);
  auto writer =
      logging::McapWriter::open(std::move(*FileSink::create(path)), infos, {.metadata = {}, .chunk_bytes = 4096});
  ASSERT_TRUE(writer);
  for (const auto& [info, at_ns, bytes] : messages)
    ASSERT_TRUE(writer->write(static_cast<std::uint16_t>(std::ranges::find(infos, info) - infos.begin()),
                              {.capture_ns = at_ns, .publish_ns = at_ns, .bytes = bytes}, 0));
  ASSERT_TRUE(writer->close());
}

std::unique_ptr<body::Replay> open(const std::filesystem::path& path, std::vector<ClockShift> shifts = {}) {
  auto replay = body::Replay::open({path}, {.robot = "", .shifts = std::move(shifts)});
  EXPECT_TRUE(replay) << replay.error();
  return std::move(*replay);
}

bool never() { return false; }

struct Summarised {
  std::optional<std::vector<WholeRecording::Summary>> summaries;
  const WholeRecording::Summary& operator[](std::size_t i) const { return summaries->at(i); }
};

Summarised summarise(WholeRecording& whole, const std::vector<std::string>& names, std::uint64_t from_ns,
                     std::uint64_t to_ns, std::size_t most) {
  std::vector<WholeField> fields;
  for (const std::string& name : names) fields.push_back(*whole.field(name));
  return {whole.summaries(fields, from_ns, to_ns, most, never)};
}

/// The same recording as a session with a file for each topic, and as one file.
struct WholeRecordingTest : testing::TestWithParam<bool> {
  WholeRecordingTest() {
    const bool one_file = GetParam();
    const auto path = folder / (one_file ? "all.mcap" : "recorded");
    if (one_file)
      write_file(path, ball_and_pose());
    else
      write_session(path, ball_and_pose());
    replay = open(path);
  }
  const tests::TemporaryFolder folder;
  std::unique_ptr<body::Replay> replay;
};

TEST_P(WholeRecordingTest, SummarisesTheWholeOfSeveralFields) {
  WholeRecording whole(*replay);
  const auto found = summarise(whole, {"/14/2/ball.x", "/14/2/pose.y"}, 0, UINT64_MAX, 10);
  const auto& x = found[0].grid->intervals();
  ASSERT_LE(x.size(), 10u);
  std::uint64_t count = 0;
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_LE(x[i].least, x[i].mean());
    EXPECT_LE(x[i].mean(), x[i].most);
    EXPECT_EQ(x[i].least, -found[1].grid->intervals()[i].most);
    if (i > 0) {
      EXPECT_EQ(x[i].least, x[i - 1].most + 1);
    }
    count += x[i].count;
    sum += x[i].sum;
  }
  EXPECT_EQ(count, 1001u);
  EXPECT_EQ(sum, 500'500);
  EXPECT_EQ(x.front().least, 0);
  EXPECT_EQ(x.back().most, 1000);
}

TEST_P(WholeRecordingTest, ARefinedRangeHasItsValuesAlone) {
  WholeRecording whole(*replay);
  const auto found = summarise(whole, {"/14/2/ball.x"}, at(40), at(40.9), 4000);
  EXPECT_EQ(found[0].grid->from_ns(), at(40));
  Interval all;
  for (const Interval& interval : found[0].grid->intervals()) {
    EXPECT_LE(interval.count, 1u);
    all.merge(interval);
  }
  EXPECT_EQ(all.count, 10u);
  EXPECT_EQ(all.least, 400);
  EXPECT_EQ(all.most, 409);
}

TEST_P(WholeRecordingTest, AFineAnswerAndAMergedOneAgree) {
  WholeRecording whole(*replay);
  const auto coarse = summarise(whole, {"/14/2/ball.x"}, at(0), at(100), 50);
  for (std::size_t i = 0; i < coarse[0].grid->intervals().size(); ++i) {
    const Interval& merged = coarse[0].grid->intervals()[i];
    const std::uint64_t from_ns = coarse[0].grid->from_ns() + i * coarse[0].grid->step_ns();
    Interval fine;
    const auto range = summarise(whole, {"/14/2/ball.x"}, from_ns, from_ns + coarse[0].grid->step_ns() - 1, 4096);
    for (const Interval& interval : range[0].grid->intervals()) fine.merge(interval);
    EXPECT_EQ(fine.count, merged.count);
    EXPECT_EQ(fine.least, merged.least);
    EXPECT_EQ(fine.most, merged.most);
  }
}

TEST_P(WholeRecordingTest, AHostileRangeIsCutToTheRecording) {
  WholeRecording whole(*replay);
  for (const auto& [from_ns, to_ns] : {std::pair<std::uint64_t, std::uint64_t>{0, 0},
                                       {UINT64_MAX, UINT64_MAX},
                                       {0, UINT64_MAX},
                                       {at(50), at(50)},
                                       {at(200), at(300)}})
    for (const std::size_t most : {1, 4096}) {
      const auto found = summarise(whole, {"/14/2/ball.x"}, from_ns, to_ns, most);
      EXPECT_LE(found[0].grid->intervals().size(), most);
      EXPECT_GE(found[0].grid->intervals().size(), 1u);
    }
}

TEST_P(WholeRecordingTest, FieldsThatAreNotThereHaveNoValues) {
  WholeRecording whole(*replay);
  const auto found = summarise(whole, {"/14/2/ball.nothing", "/14/2/ball.x"}, 0, UINT64_MAX, 10);
  for (const Interval& interval : found[0].grid->intervals()) EXPECT_EQ(interval.count, 0u);
  EXPECT_GT(found[1].grid->intervals()[0].count, 0u);
  EXPECT_FALSE(whole.field("/14/3/ball.x"));
  EXPECT_FALSE(whole.field("/14/2/ball"));
  EXPECT_FALSE(whole.field("/14/2/ball."));
  EXPECT_FALSE(whole.field(""));
}

TEST_P(WholeRecordingTest, ACancelledReadingHasNoAnswerAndLeavesNothingBehind) {
  WholeRecording whole(*replay);
  const std::vector<WholeField> fields{*whole.field("/14/2/ball.x")};
  int asked = 0;
  const auto after_two = [&] { return ++asked == 2; };
  EXPECT_FALSE(whole.summaries(fields, 0, UINT64_MAX, 10, after_two));
  EXPECT_EQ(asked, 2) << "it ended there";
  EXPECT_FALSE(whole.runs("/14/2/ball", {"skill"}, [] { return true; }));
  std::uint64_t count = 0;
  const auto found = summarise(whole, {"/14/2/ball.x"}, 0, UINT64_MAX, 10);
  for (const Interval& interval : found[0].grid->intervals()) count += interval.count;
  EXPECT_EQ(count, 1001u);
}

TEST_P(WholeRecordingTest, ASecondQuestionReadsNothing) {
  WholeRecording whole(*replay);
  summarise(whole, {"/14/2/ball.x"}, 0, UINT64_MAX, 10);
  const std::vector<WholeField> fields{*whole.field("/14/2/ball.x")};
  EXPECT_TRUE(whole.summaries(fields, at(0), at(50), 100, [] { return true; })) << "nothing to cancel";
}

TEST_P(WholeRecordingTest, ListsTheRunsOfWords) {
  const auto runs = WholeRecording(*replay).runs("/14/2/ball", {"skill"}, never);
  ASSERT_TRUE(runs);
  EXPECT_EQ(runs->words(), (std::vector<std::string>{"walk", "kick"}));
  ASSERT_EQ(runs->runs().size(), 2u);
  EXPECT_EQ(runs->runs()[0].from_ns, at(0));
  EXPECT_EQ(runs->runs()[1].from_ns, at(50));
  EXPECT_FALSE(WholeRecording(*replay).runs("/14/2/x", {"skill"}, never));
  EXPECT_FALSE(WholeRecording(*replay).runs("/14/2/ball", {"["}, never));
}

INSTANTIATE_TEST_SUITE_P(OfASessionAndOfAFile, WholeRecordingTest, testing::Bool());

TEST(WholeRecordingShifted, TimesAreThoseOfThePlayback) {
  const tests::TemporaryFolder folder;
  write_file(folder / "all.mcap", ball_and_pose());
  const auto replay = open(folder / "all.mcap", {-250'000'000});
  WholeRecording whole(*replay);
  const auto found = summarise(whole, {"/14/2/ball.x"}, at(9.75), at(9.84), 1);
  EXPECT_EQ(found[0].grid->intervals()[0].count, 1u);
  EXPECT_EQ(found[0].grid->intervals()[0].most, 100);
}

/// The values before and after a damage are summarised, and the damage is counted.
TEST(WholeRecordingDamaged, PassesOverDamages) {
  const tests::TemporaryFolder folder;
  const auto path = folder / "all.mcap";
  write_file(path, ball_and_pose());
  {
    const auto chunks = (*logging::McapFile::open(path))->index().chunks;
    ASSERT_GT(chunks.size(), 4u);
    const auto& damaged = chunks[chunks.size() / 2].index;
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(damaged.offset + damaged.record_bytes - 40));
    file.write("damage damage damage", 20);
  }
  const auto replay = open(path);
  WholeRecording whole(*replay);
  const auto found = summarise(whole, {"/14/2/ball.x"}, 0, UINT64_MAX, 1000);
  Interval all;
  for (const Interval& interval : found[0].grid->intervals()) all.merge(interval);
  EXPECT_GE(found[0].damages, 1u);
  EXPECT_LT(all.count, 1001u);
  EXPECT_GT(all.count, 500u);
  EXPECT_EQ(all.least, 0);
  EXPECT_EQ(all.most, 1000);
}

/// Every truncation gives an answer or is refused when it is opened.
TEST(WholeRecordingDamaged, EveryTruncationIsRead) {
  const tests::TemporaryFolder folder;
  std::vector<Written> some = ball_and_pose();
  some.resize(60);
  write_file(folder / "all.mcap", some);
  const auto size = std::filesystem::file_size(folder / "all.mcap");
  int opened = 0;
  for (std::uintmax_t length = size; length > 0; length -= std::min<std::uintmax_t>(length, 13)) {
    std::filesystem::resize_file(folder / "all.mcap", length);
    auto replay = body::Replay::open({folder / "all.mcap"}, {});
    if (!replay) continue;
    ++opened;
    WholeRecording whole(**replay);
    const auto field = whole.field("/14/2/ball.x");
    if (field) {
      EXPECT_TRUE(whole.summaries({*field}, 0, UINT64_MAX, 100, never));
    }
    EXPECT_TRUE(whole.events(never));
  }
  EXPECT_GT(opened, 10);
}

// events

pb::GameState game(pb::GameState::State state, std::uint32_t score, bool penalised = false) {
  pb::GameState game;
  game.set_state(state);
  game.mutable_own()->set_number(14);
  game.mutable_own()->set_score(score);
  game.mutable_own()->add_players()->set_penalised(penalised);
  game.mutable_opponent()->set_number(5);
  return game;
}

std::string motion(pb::MotionStatus::Fall fall, const std::string& running = "") {
  pb::MotionStatus status;
  status.set_fall(fall);
  if (fall == pb::MotionStatus::FALL_FALLING) status.set_fall_side(pb::MotionStatus::FALL_SIDE_FRONT);
  status.set_running(running);
  return status.SerializeAsString();
}

TEST(RecordedEvents, AreThoseOfAllRobotsInOrderOfTime) {
  const tests::TemporaryFolder folder;
  std::vector<Written> messages;
  const auto add = [&](const std::string& topic, double seconds, const auto& message) {
    messages.push_back({info_of<std::decay_t<decltype(message)>>(topic), at(seconds), message.SerializeAsString()});
  };
  using State = pb::GameState;
  for (const std::string robot : {"/14/2", "/14/3"}) {
    add(robot + "/game", 0, game(State::STATE_SET, 0));
    add(robot + "/game", robot == "/14/2" ? 10 : 11, game(State::STATE_PLAYING, 0));
    add(robot + "/game", 20, game(State::STATE_PLAYING, 1, true));
    add(robot + "/game", 40, game(State::STATE_PLAYING, 2, true));
  }
  const auto moves = info_of<pb::MotionStatus>("/14/3/motion_status");
  messages.push_back({moves, at(1), motion(pb::MotionStatus::FALL_UPRIGHT)});
  messages.push_back({moves, at(2), motion(pb::MotionStatus::FALL_UPRIGHT, "walk_forward")});
  messages.push_back({moves, at(3), motion(pb::MotionStatus::FALL_FALLING)});
  messages.push_back({moves, at(4), motion(pb::MotionStatus::FALL_FALLEN)});
  messages.push_back({moves, at(5), motion(pb::MotionStatus::FALL_UPRIGHT, "squat")});
  pb::LogText text;
  text.set_level(pb::LogText::LEVEL_ERROR);
  text.set_text("hot");
  add("/14/2/log", 6, text);
  text.set_level(pb::LogText::LEVEL_WARNING);
  add("/14/2/log", 7, text);
  pb::Simulation simulation;
  simulation.mutable_home()->set_number(14);
  add("/sim/state", 4, simulation);
  simulation.mutable_home()->set_score(1);
  simulation.set_tick(150);
  add("/sim/state", 9, simulation);  // the GameController reports the same goal later
  write_session(folder / "recorded", messages);

  const auto replay = open(folder / "recorded");
  const auto found = events_of(*replay, never);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->events, (std::vector<RecordedEvent>{
                               {at(2), "kick", "kick walk forward", "14/3"},
                               {at(3), "fall", "falls front", "14/3"},
                               {at(6), "error", "hot", "14/2"},
                               {at(9), "goal", "goal of team 14", ""},
                               {at(10), "state", "playing", "14/2"},
                               {at(20), "penalty", "14/1 penalised", "14/2"},
                               {at(40), "goal", "goal of team 14", "14/2"},
                           }));
  EXPECT_FALSE(found->full);
  EXPECT_EQ(found->damages, 0u);
}

TEST(RecordedEvents, AreNoneWithoutOurObjects) {
  const tests::TemporaryFolder folder;
  std::vector<Written> messages = ball_and_pose();
  messages.push_back({{.topic = "/14/2/game", .message_encoding = "json", .schema = {}}, at(1), "{}"});
  write_file(folder / "all.mcap", messages);
  const auto found = events_of(*open(folder / "all.mcap"), never);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->events.empty());
}

TEST(RecordedEvents, ACancelledReadingHasNoAnswer) {
  const tests::TemporaryFolder folder;
  std::vector<Written> messages;
  for (int i = 0; i < 1000; ++i)
    messages.push_back(
        {info_of<pb::MotionStatus>("/14/3/motion_status"), at(i), motion(pb::MotionStatus::FALL_UPRIGHT)});
  write_session(folder / "recorded", messages);
  const auto replay = open(folder / "recorded");
  EXPECT_FALSE(events_of(*replay, [] { return true; }));
  WholeRecording whole(*replay);
  EXPECT_EQ(whole.events([] { return true; }), nullptr);
  EXPECT_NE(whole.events(never), nullptr);
  EXPECT_NE(whole.events([] { return true; }), nullptr) << "known already";
}

}  // namespace
}  // namespace robot::lab
