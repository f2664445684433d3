#include "robot/memory/schema_check.h"

#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

#include <functional>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/team.pb.h"
#include "robot/memory/schema.h"

namespace robot::memory {
namespace {

using google::protobuf::DescriptorProto;
using google::protobuf::FieldDescriptorProto;
using google::protobuf::FileDescriptorSet;

/// Returns the schema of `Message` after `change` of its last file, which holds the message itself.
template <class Message>
Schema changed(const std::function<void(google::protobuf::FileDescriptorProto&)>& change) {
  Schema schema = schema_of(*Message::descriptor());
  FileDescriptorSet files;
  EXPECT_TRUE(files.ParseFromString(schema.bytes));
  change(*files.mutable_file(files.file_size() - 1));
  schema.bytes = files.SerializeAsString();
  return schema;
}

FieldDescriptorProto& field(DescriptorProto& message, std::string_view name) {
  for (auto& field : *message.mutable_field())
    if (field.name() == name) return field;
  ADD_FAILURE() << name;
  return *message.add_field();
}

std::string verdict_on_ball(const std::function<void(DescriptorProto&)>& change) {
  const Schema schema = changed<foresight::Ball>([&](auto& file) { change(*file.mutable_message_type(0)); });
  const Result<void> verdict = check_same_meaning(*foresight::Ball::descriptor(), schema);
  return verdict ? "" : verdict.error();
}

TEST(SchemaCheck, OurOwnSchemasMeanTheSame) {
  EXPECT_TRUE(check_same_meaning(*foresight::Team::descriptor(), schema_of(*foresight::Team::descriptor())));
}

TEST(SchemaCheck, ARenumberedFieldIsRefused) {
  EXPECT_EQ(verdict_on_ball([](DescriptorProto& ball) { field(ball, "x").set_number(99); }),
            "field x of foresight.Ball: expected number 2, got number 99");
}

TEST(SchemaCheck, ARetypedFieldIsRefused) {
  EXPECT_EQ(
      verdict_on_ball([](DescriptorProto& ball) { field(ball, "x").set_type(FieldDescriptorProto::TYPE_DOUBLE); }),
      "field x of foresight.Ball: expected type float, got type double");
  EXPECT_EQ(
      verdict_on_ball([](DescriptorProto& ball) { field(ball, "x").set_label(FieldDescriptorProto::LABEL_REPEATED); }),
      "field x of foresight.Ball: expected type float, got type repeated float");
}

TEST(SchemaCheck, ANumberThatMeansAnotherFieldIsRefused) {
  EXPECT_EQ(verdict_on_ball([](DescriptorProto& ball) { field(ball, "x").set_name("bearing"); }),
            "number 2 of foresight.Ball: expected field x, got field bearing");
}

TEST(SchemaCheck, FieldsThatOnlyOneSideKnowsAreAllowed) {
  EXPECT_EQ(verdict_on_ball([](DescriptorProto& ball) {
              ball.mutable_field()->RemoveLast();
              auto& spin = *ball.add_field();
              spin.set_name("spin");
              spin.set_number(200);
              spin.set_type(FieldDescriptorProto::TYPE_FLOAT);
              spin.set_label(FieldDescriptorProto::LABEL_OPTIONAL);
            }),
            "");
}

TEST(SchemaCheck, InnerMessagesAndEnumsAreCompared) {
  Schema team = schema_of(*foresight::Team::descriptor());
  FileDescriptorSet files;
  ASSERT_TRUE(files.ParseFromString(team.bytes));
  for (auto& file : *files.mutable_file())
    if (file.name() == "foresight/ball.proto") field(*file.mutable_message_type(0), "y").set_number(77);
  team.bytes = files.SerializeAsString();
  EXPECT_EQ(check_same_meaning(*foresight::Team::descriptor(), team).error(),
            "field y of foresight.Ball: expected number 3, got number 77");

  const Schema game = changed<foresight::GameState>([](auto& file) {
    for (auto& values : *file.mutable_message_type(0)->mutable_enum_type())
      if (values.name() == "State") values.mutable_value(5)->set_number(50);
  });
  EXPECT_EQ(check_same_meaning(*foresight::GameState::descriptor(), game).error(),
            "value STATE_PLAYING of foresight.GameState.State: expected number 5, got number 50");
}

TEST(SchemaCheck, ReportsBytesThatAreNoSchema) {
  EXPECT_EQ(check_readable({.name = "a.B", .encoding = "protobuf", .bytes = "\xff"}).error(),
            "schema of a.B: expected a serialised FileDescriptorSet, got 1 bytes of something else");
  EXPECT_EQ(check_readable({.name = "a.B", .encoding = "protobuf", .bytes = ""}).error(),
            "schema of a.B: expected a description of that message with all it imports, got 0 files without it");
  EXPECT_TRUE(check_readable({.name = "a.B", .encoding = "jsonschema", .bytes = "{}"}));
}

TEST(SchemaCheck, SurvivesEveryTruncationAndFlippedByte) {
  const Schema whole = schema_of(*foresight::Team::descriptor());
  for (std::size_t at = 0; at < whole.bytes.size(); at += 7) {
    Schema damaged = whole;
    damaged.bytes[at] = static_cast<char>(damaged.bytes[at] ^ 0x41);
    (void)check_same_meaning(*foresight::Team::descriptor(), damaged);
    damaged.bytes.resize(at);
    (void)check_same_meaning(*foresight::Team::descriptor(), damaged);
  }
}

}  // namespace
}  // namespace robot::memory
