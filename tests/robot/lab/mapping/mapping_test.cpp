#include "robot/lab/mapping/mapping.h"

#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

#include <deque>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/truth.pb.h"
#include "robot/core/json_library.h"
#include "robot/memory/schema.h"

namespace robot::lab {
namespace {

using Json = nlohmann::json;

std::string problem(const std::string& text) {
  const auto mapping = parse_mapping("map.json", text);
  return mapping ? "" : mapping.error();
}

/// Returns a mapping of the topic /theirs to `object` with these fields.
TopicRule rule(const std::string& object, const Json& fields) {
  const auto mapping = parse_mapping(
      "map.json", Json{{"robot", "14/2"}, {"topics", {{"/theirs", {{"object", object}, {"fields", fields}}}}}}.dump());
  EXPECT_TRUE(mapping) << mapping.error();
  return mapping ? mapping->topics.at(0) : TopicRule();
}

template <class Message>
Message in_our_words(const std::string& object, const Json& fields, const Json& theirs, bool strict = true) {
  Message message;
  const auto bytes = mapped(rule(object, fields), theirs, 1'700'000'000'000'000'123, strict);
  EXPECT_TRUE(bytes) << bytes.error();
  EXPECT_TRUE(bytes && message.ParseFromString(*bytes));
  return message;
}

TEST(Mapping, TakesPathsConstantsScalesAndTheTime) {
  const auto ball = in_our_words<foresight::Ball>("ball",
                                                  {{"x", "position.x"},
                                                   {"y", {{"from", "position.y_mm"}, {"scale", 0.001}, {"add", 1}}},
                                                   {"seen_ns", "@time"},
                                                   {"velocity_x", "v[1]"},
                                                   {"deviation", {{"value", 0.25}}}},
                                                  {{"position", {{"x", 1.5}, {"y_mm", -500}}}, {"v", {1, 2}}});
  EXPECT_FLOAT_EQ(ball.x(), 1.5f);
  EXPECT_FLOAT_EQ(ball.y(), 0.5f);
  EXPECT_EQ(ball.seen_ns(), 1'700'000'000'000'000'123u) << "to the last digit";
  EXPECT_FLOAT_EQ(ball.velocity_x(), 2);
  EXPECT_FLOAT_EQ(ball.deviation(), 0.25f);
}

TEST(Mapping, TakesListsOfMessagesAndNamesOfEnums) {
  const auto truth = in_our_words<foresight::GroundTruth>(
      "/truth/world",
      {{"robots", {{"each", "players"}, {"fields", {{"x", "at[0]"}, {"y", "at[1]"}, {"player", "number"}}}}},
       {"ball", {{"from", "ball"}, {"fields", {{"x", "x"}, {"y", "y"}}}}}},
      {{"players", {{{"at", {1, 2}}, {"number", 3}}, {{"at", {4, 5}}, {"number", "6"}}}},
       {"ball", {{"x", 7}, {"y", 8}}}});
  ASSERT_EQ(truth.robots_size(), 2);
  EXPECT_FLOAT_EQ(truth.robots(1).y(), 5);
  EXPECT_EQ(truth.robots(1).player(), 6u);
  EXPECT_FLOAT_EQ(truth.ball().x(), 7);
  const auto game = in_our_words<foresight::GameState>(
      "game", {{"state", {{"from", "phase"}, {"names", {{"PLAY", "STATE_PLAYING"}, {"3", "STATE_SET"}}}}}},
      {{"phase", "PLAY"}});
  EXPECT_EQ(game.state(), foresight::GameState::STATE_PLAYING);
  EXPECT_EQ(in_our_words<foresight::GameState>("game", {{"state", "s"}}, {{"s", "STATE_SET"}}).state(),
            foresight::GameState::STATE_SET);
}

TEST(Mapping, AMissingValueIsLeftOutAndAWrongTypeRefused) {
  const TopicRule ball = rule("ball", {{"x", "position.x"}, {"seen_ns", "seen"}});
  EXPECT_EQ(mapped(ball, {{"seen", 5}}, 0, true).error(), "/theirs: expected 'position.x' for x, it is not there");
  const auto lenient = mapped(ball, {{"seen", 5}}, 0, false);
  ASSERT_TRUE(lenient);
  foresight::Ball expected;
  expected.set_seen_ns(5);
  EXPECT_EQ(*lenient, expected.SerializeAsString());
  EXPECT_EQ(mapped(ball, {{"position", {{"x", "far"}}}, {"seen", 5}}, 0, false).error(),
            "/theirs: expected a number at 'position.x' for x, got \"far\"");
  EXPECT_EQ(mapped(ball, {{"position", {{"x", 1}}}, {"seen", -5}}, 0, false).error(),
            "/theirs: expected a whole number at 'seen' for seen_ns, got -5");
}

TEST(Mapping, MistakesAreOneSentenceWithTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"{", "map.json: expected JSON, got something else"},
      {"[]", "map.json: $: expected an object with robot, topics, got []"},
      {R"({"topics": {}})", "map.json: $.robot: expected a text, got nothing"},
      {R"({"robot": "tim", "topics": {"/a": {}}})",
       "map.json: $.robot: expected <team>/<player> such as \"14/2\", got \"tim\""},
      {R"({"robot": "14/2", "topics": {}})", "map.json: $.topics: expected an object of topics, got {}"},
      {R"({"robot": "14/2", "topics": {"/a": {"object": "ball"}}})",
       "map.json: $.topics[\"/a\"].fields: expected an object of fields of foresight.Ball, got nothing"},
      {R"({"robot": "14/2", "topics": {"/a": {"object": "ball", "field": {}}}})",
       "map.json: $.topics[\"/a\"]: expected object, fields, got \"the unknown key field\""},
      {R"({"robot": "14/2", "topics": {"/a": {"object": "ball", "fields": {"x": 5}}}})",
       "map.json: $.topics[\"/a\"].fields.x: expected an object with from, scale, add, names, got 5"},
      {R"({"robot": "14/2", "topics": {"/a": {"object": "ball", "fields": {"x": {"from": "x", "scale": "mm"}}}}})",
       "map.json: $.topics[\"/a\"].fields.x.scale: expected a number, got \"mm\""},
      {R"({"robot": "14/2", "topics": {"/a": {"object": "game", "fields": {"state": {"from": "x", "names": {"P": "STATE_X"}}}}}})",
       "map.json: $.topics[\"/a\"].fields.state.names.P: expected a value of foresight.GameState.State, got "
       "\"STATE_X\""},
  };
  for (const auto& [text, sentence] : cases) EXPECT_EQ(problem(text), sentence);
  EXPECT_EQ(problem(R"({"robot": "14/2", "topics": {"/a": {"object": "boll", "fields": {}}}})")
                .find("map.json: $.topics[\"/a\"].object: expected one of /sim/state, /truth/world, ball, battery"),
            0u);
  EXPECT_EQ(problem(R"({"robot": "14/2", "topics": {"/a": {"object": "ball", "fields": {"z": "z"}}}})")
                .find("map.json: $.topics[\"/a\"].fields: expected fields of foresight.Ball (seen_ns, x, y, "),
            0u);
}

TEST(Mapping, SurvivesEveryTruncation) {
  const std::string text =
      R"({"robot": "14/2", "topics": {"/a": {"object": "ball", "fields": {"x": {"from": "x", "scale": 2}}}}})";
  EXPECT_EQ(problem(text), "");
  for (std::size_t n = 0; n < text.size(); ++n) EXPECT_NE(problem(text.substr(0, n)), "") << n;
}

/// A stream in memory.
class Records final : public logging::InProvider {
 public:
  Records(memory::ChannelInfo info, std::vector<std::string> messages)
      : info_(std::move(info)), messages_(std::move(messages)) {}
  Result<memory::ChannelInfo> open() override { return info_; }
  Result<std::optional<logging::Record>> read() override {
    if (next_ == messages_.size()) return std::optional<logging::Record>();
    const std::uint64_t number = ++next_;
    return std::optional(logging::Record{number, number * 1000, number * 1000 + 1, messages_[number - 1]});
  }
  Result<void> seek(std::uint64_t capture_ns) override {
    next_ = capture_ns / 1000;
    return {};
  }

 private:
  const memory::ChannelInfo info_;
  const std::vector<std::string> messages_;
  std::size_t next_ = 0;
};

TEST(MappedStream, TranslatesJsonAndProtobufToOurObject) {
  MappedInProvider json(
      std::make_unique<Records>(memory::ChannelInfo{.topic = "/theirs", .message_encoding = "json", .schema = {}},
                                std::vector<std::string>{R"({"x": 1})", R"({"x": 2})"}),
      rule("ball", {{"x", "x"}}));
  const auto info = json.open();
  ASSERT_TRUE(info) << info.error();
  EXPECT_EQ(info->topic, "/14/2/ball");
  EXPECT_EQ(info->schema.name, "foresight.Ball");
  foresight::Ball ball;
  for (const float x : {1.0f, 2.0f}) {
    const auto record = json.read();
    ASSERT_TRUE(record && *record);
    ASSERT_TRUE(ball.ParseFromString((*record)->bytes));
    EXPECT_FLOAT_EQ(ball.x(), x);
    EXPECT_EQ((*record)->capture_ns, static_cast<std::uint64_t>(x) * 1000);
  }
  EXPECT_FALSE(json.read()->has_value());

  // their message in protobuf: any message type
  foresight::Odometry odometry;
  odometry.set_x(1.25f);
  MappedInProvider protobuf(
      std::make_unique<Records>(
          memory::ChannelInfo{.topic = "/theirs", .schema = memory::schema_of(*foresight::Odometry::descriptor())},
          std::vector<std::string>{odometry.SerializeAsString()}),
      rule("ball", {{"x", {{"from", "x"}, {"scale", 2}}}}));
  ASSERT_TRUE(protobuf.open());
  ASSERT_TRUE(ball.ParseFromString((*protobuf.read())->bytes));
  EXPECT_FLOAT_EQ(ball.x(), 2.5f);
}

TEST(MappedStream, AWrongMappingIsReportedBeforeAnythingIsPlayed) {
  MappedInProvider wrong(
      std::make_unique<Records>(memory::ChannelInfo{.topic = "/theirs", .message_encoding = "json", .schema = {}},
                                std::vector<std::string>{R"({"x": 1})"}),
      rule("ball", {{"x", "z"}}));
  EXPECT_EQ(wrong.open().error(), "/theirs: expected 'z' for x, it is not there");
  MappedInProvider ros(
      std::make_unique<Records>(memory::ChannelInfo{.topic = "/theirs", .message_encoding = "ros1", .schema = {}},
                                std::vector<std::string>{"?"}),
      rule("ball", {{"x", "z"}}));
  EXPECT_EQ(ros.open().error(), "/theirs: expected protobuf or JSON, got 'ros1'");
}

TEST(MappedStream, ALaterMessageThatDoesNotFitIsReportedOnceAndCounted) {
  MappedInProvider stream(
      std::make_unique<Records>(memory::ChannelInfo{.topic = "/theirs", .message_encoding = "json", .schema = {}},
                                std::vector<std::string>{R"({"x": 1})", R"({"x": "a"})", "{", R"({"x": 4})"}),
      rule("ball", {{"x", "x"}}));
  ASSERT_TRUE(stream.open());
  EXPECT_EQ((*stream.read())->capture_ns, 1000u);
  EXPECT_FALSE(stream.read());
  EXPECT_EQ((*stream.read())->capture_ns, 4000u);
  EXPECT_EQ(stream.lost_before(), 2u);
}

}  // namespace
}  // namespace robot::lab
