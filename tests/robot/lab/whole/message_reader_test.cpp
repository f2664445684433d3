#include "robot/lab/whole/message_reader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "proto/foresight/agent.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/truth.pb.h"
#include "robot/memory/schema.h"

namespace robot::lab {
namespace {

FieldPath path(const std::string& text) {
  const auto parsed = parse_field_path(text);
  EXPECT_TRUE(parsed) << text;
  return parsed ? *parsed : FieldPath();
}

template <class Message>
std::unique_ptr<MessageReader> reader_of(const Message& message) {
  auto reader = MessageReader::open({.topic = "/14/2/x", .schema = memory::schema_of(*Message::descriptor())});
  EXPECT_TRUE(reader);
  EXPECT_TRUE((*reader)->read(message.SerializeAsString()));
  return std::move(*reader);
}

std::unique_ptr<MessageReader> json_of(const std::string& text) {
  auto reader = MessageReader::open({.topic = "/x", .message_encoding = "json", .schema = {}});
  EXPECT_TRUE(reader);
  EXPECT_TRUE((*reader)->read(text)) << text;
  return std::move(*reader);
}

TEST(FieldPath, NamesIndicesAndFilters) {
  EXPECT_EQ(path("x"), (FieldPath{std::string("x")}));
  EXPECT_EQ(path("robots[0].detection.distance"),
            (FieldPath{std::string("robots"), std::size_t{0}, std::string("detection"), std::string("distance")}));
  EXPECT_EQ(path("robots[team=14,player=2].x"),
            (FieldPath{std::string("robots"), EntryFilter{{"team", 14}, {"player", 2}}, std::string("x")}));
  EXPECT_EQ(path("a[1][2]").size(), 3u);
}

TEST(FieldPath, AnythingElseIsRefusedWithASentence) {
  std::string deep = "a";
  for (int i = 0; i < 20; ++i) deep += ".a";
  for (const std::string& wrong :
       {std::string(), std::string("."), std::string("x."), std::string(".x"), std::string("a..b"), std::string("[0]"),
        std::string("a["), std::string("a[]"), std::string("a[-1]"), std::string("a[x]"), std::string("a[x=]"),
        std::string("a]"), std::string("a[=1]"), std::string("a[x=nan]"), std::string("a[0]b"), std::string("a.[0]"),
        std::string("a[x=1,]"), deep, std::string("a[99999999999999999999999]")}) {
    const auto parsed = parse_field_path(wrong);
    ASSERT_FALSE(parsed) << wrong;
    EXPECT_NE(parsed.error().find("expected a field"), std::string::npos);
  }
}

TEST(MessageReader, ReadsNumbersOfEveryKind) {
  foresight::GameState game;
  game.set_half(2);
  game.set_seconds_remaining(-1.5f);
  game.set_state(foresight::GameState::STATE_PLAYING);
  game.mutable_own()->add_players()->set_penalised(true);
  game.mutable_own()->add_players()->set_warnings(3);
  const auto reader = reader_of(game);
  EXPECT_EQ(reader->number(path("half")), 2);
  EXPECT_EQ(reader->number(path("seconds_remaining")), -1.5);
  EXPECT_EQ(reader->number(path("state")), 5);
  EXPECT_EQ(reader->number(path("own.players[0].penalised")), 1);
  EXPECT_EQ(reader->number(path("own.players[1].penalised")), 0) << "a field without presence has its default";
  EXPECT_EQ(reader->number(path("own.players[warnings=3].warnings")), 3);
}

TEST(MessageReader, WhatIsNotThereIsNoNumber) {
  const auto reader = reader_of(foresight::GameState());
  for (const char* absent : {"nothing", "kicking_team", "own.score", "own.players[0].code", "own.players[code=1].code",
                             "half.x", "half[0]", "own", "own.players"})
    EXPECT_TRUE(std::isnan(reader->number(path(absent)))) << absent;
}

TEST(MessageReader, ReadsWords) {
  foresight::DecisionTrace trace;
  trace.set_skill("approach_ball");
  trace.add_visited()->set_kind(foresight::DecisionTrace::Node::KIND_SKILL);
  trace.add_arguments()->set_value(0.25f);
  const auto reader = reader_of(trace);
  EXPECT_EQ(reader->word(path("skill")), "approach_ball");
  EXPECT_EQ(reader->word(path("role")), "");
  EXPECT_EQ(reader->word(path("visited[0].kind")), "KIND_SKILL");
  EXPECT_EQ(reader->word(path("arguments[0].value")), "0.25");
  EXPECT_EQ(reader->word(path("nothing")), "");
}

TEST(MessageReader, ReadsJson) {
  const auto reader = json_of(R"({"a":{"b":[1,{"c":true,"k":2},"word"]},"n":null})");
  EXPECT_EQ(reader->number(path("a.b[0]")), 1);
  EXPECT_EQ(reader->number(path("a.b[k=2].c")), 1);
  EXPECT_EQ(reader->word(path("a.b[2]")), "word");
  for (const char* absent : {"a", "a.b", "a.b[9]", "a.b[2]", "n", "x", "a.b.c"})
    EXPECT_TRUE(std::isnan(reader->number(path(absent)))) << absent;
  EXPECT_EQ(json_of("7")->number(path("value")), 7);
}

TEST(MessageReader, BytesThatAreNoMessageAreRefused) {
  const auto reader = reader_of(foresight::GameState());
  EXPECT_FALSE(reader->read("\x08"));
  const auto json = json_of("{}");
  EXPECT_FALSE(json->read("{"));
  EXPECT_TRUE(json->read("{\"x\":1}"));
  EXPECT_EQ(json->number(path("x")), 1);
}

TEST(MessageReader, AnotherEncodingIsAnError) {
  EXPECT_FALSE(MessageReader::open({.topic = "/x", .message_encoding = "cdr", .schema = {}}));
  EXPECT_FALSE(MessageReader::open({.topic = "/x", .schema = {"a.B", "protobuf", "nonsense"}}));
}

}  // namespace
}  // namespace robot::lab
