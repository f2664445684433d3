#include "robot/app/services/live_parameter_service.h"

#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "proto/foresight/live_parameters.pb.h"
#include "robot/memory/schema.h"

namespace robot::app {
namespace {

using foresight::LiveParameter;
using foresight::LiveParameters;

struct Live : ::testing::Test {
  /// Returns the channel to which the process `name` writes, like the door.
  std::shared_ptr<memory::Channel> process(const std::string& name, const std::string& encoding = "protobuf") {
    const std::string topic = "/14/2/live_parameters/" + name;
    if (const auto known = channels.find(topic)) return known;
    const auto made = std::make_shared<memory::RawChannel>(
        memory::ChannelInfo{
            .topic = topic, .message_encoding = encoding, .schema = memory::schema_of(*LiveParameters::descriptor())},
        clock);
    EXPECT_TRUE(channels.add(made));
    return made;
  }

  static LiveParameter number(const std::string& name, double initial, double present) {
    LiveParameter parameter;
    parameter.set_name(name);
    parameter.set_type(LiveParameter::TYPE_NUMBER);
    parameter.set_initial_number(initial);
    parameter.set_number(present);
    parameter.set_min(0);
    parameter.set_max(10);
    return parameter;
  }

  void announce(const std::string& name, const std::vector<LiveParameter>& announced) {
    LiveParameters message;
    for (const LiveParameter& parameter : announced) *message.add_parameter() = parameter;
    EXPECT_TRUE(process(name)->write_bytes(message.SerializeAsString(), 1));
  }

  LiveParameters told() const {
    LiveParameters message;
    EXPECT_TRUE(message.ParseFromString(std::string(channels.find("/14/2/live_parameters")->newest()->bytes())));
    return message;
  }

  std::string refusal(const std::string& name, const net::ParameterValue& value) {
    const auto set = parameters.set(name, value);
    return set ? "" : set.error();
  }

  void start() {
    auto opened = LiveParameterService::open(parameters, "14/2", channels, clock);
    ASSERT_TRUE(opened) << opened.error();
    service = std::move(*opened);
  }

  ManualClock clock{5 * kSecond};
  memory::Channels channels;
  net::Parameters parameters;
  std::unique_ptr<LiveParameterService> service;
};

TEST_F(Live, AnAnnouncementIsOfferedAndItsValuesAreTold) {
  start();
  EXPECT_EQ(told().parameter_size(), 0);
  announce("walk", {number("height", 2, 2), number("speed", 3, 3)});
  EXPECT_EQ(parameters.number("walk.height"), 2);
  EXPECT_EQ(refusal("walk.height", std::int64_t{4}), "");
  const LiveParameters message = told();
  ASSERT_EQ(message.parameter_size(), 2);
  EXPECT_EQ(message.parameter(0).name(), "walk.height");
  EXPECT_EQ(message.parameter(0).number(), 4);
  EXPECT_EQ(message.parameter(0).initial_number(), 2);
  EXPECT_EQ(message.parameter(1).number(), 3);
  EXPECT_EQ(message.problem_size(), 0);
}

TEST_F(Live, BadValuesGetOneSentence) {
  start();
  announce("walk", {number("height", 2, 2)});
  EXPECT_EQ(refusal("walk.height", 11.0), "parameter 'walk.height': expected 0 .. 10, got 11");
  EXPECT_EQ(refusal("walk.height", "2"), "parameter 'walk.height': expected a number, got a text");
  EXPECT_NE(refusal("walk.height", std::nan("")), "");
  EXPECT_EQ(refusal("walk.size", 1.0), "parameter 'walk.size': there is no parameter of this name");
  EXPECT_EQ(parameters.number("walk.height"), 2);

  LiveParameter text;
  text.set_name("name");
  text.set_type(LiveParameter::TYPE_TEXT);
  announce("team", {text});
  EXPECT_EQ(refusal("team.name", std::string(200, 'a')), "");
  EXPECT_EQ(refusal("team.name", std::string(201, 'a')),
            "parameter 'team.name': expected a text of at most 200 bytes, got 201");
}

TEST_F(Live, ParametersOfAProcessThatHasGoneStayAndAreNotSet) {
  start();
  announce("walk", {number("height", 2, 2)});
  ASSERT_EQ(refusal("walk.height", 5.0), "");
  service->ended("/14/2/ball");
  service->ended("/14/2/live_parameters/kick");
  EXPECT_FALSE(told().parameter(0).gone());
  service->ended("/14/2/live_parameters/walk");
  EXPECT_TRUE(told().parameter(0).gone());
  EXPECT_EQ(refusal("walk.height", 6.0),
            "parameter 'walk.height': expected a process that runs, but 'walk' has disconnected");
  // it comes back with the values of its file
  announce("walk", {number("height", 2, 2)});
  EXPECT_FALSE(told().parameter(0).gone());
  EXPECT_EQ(told().parameter(0).number(), 5);
  EXPECT_EQ(refusal("walk.height", 6.0), "");
}

TEST_F(Live, ANewRuntimeLearnsTheValueFromTheProcess) {
  announce("walk", {number("height", 2, 7)});  // also if the process was first
  start();
  EXPECT_EQ(parameters.number("walk.height"), 7);
  EXPECT_EQ(told().parameter(0).initial_number(), 2);
}

TEST_F(Live, AParameterThatIsNotAnnouncedAnyMoreIsRemoved) {
  start();
  announce("walk", {number("height", 2, 2), number("speed", 3, 3)});
  announce("walk", {number("speed", 3, 3)});
  EXPECT_FALSE(parameters.get("walk.height"));
  EXPECT_EQ(told().parameter_size(), 1);
}

TEST_F(Live, AWrongParameterIsRefusedAndTheOthersAreTaken) {
  start();
  announce("walk", {number("height", 2, 2), number("speed", 3, 30), number("height", 1, 1)});
  const LiveParameters message = told();
  EXPECT_EQ(message.parameter_size(), 1);
  ASSERT_EQ(message.problem_size(), 1);
  EXPECT_EQ(message.problem(0), "walk: parameter 'speed': expected 0 .. 10, got 30");
  announce("walk", {number("height", 2, 2), number("height", 1, 1)});
  EXPECT_EQ(told().problem(0), "walk: parameter 'height': expected each name once, got it again");
  announce("walk", {number("height", 2, 2)});
  EXPECT_EQ(told().problem_size(), 0);
}

TEST_F(Live, AllProcessesTogetherHaveAtMost256Parameters) {
  start();
  std::vector<LiveParameter> many;
  for (int i = 0; i < 200; ++i) many.push_back(number("p" + std::to_string(i), 0, 0));
  announce("a", many);
  announce("b", many);
  EXPECT_EQ(told().parameter_size(), 256);
  EXPECT_EQ(told().problem(0), "b: parameter 'p56': expected at most 256 parameters of all processes, got one more");
  announce("a", {});
  announce("b", many);
  EXPECT_EQ(told().parameter_size(), 200);
}

TEST_F(Live, OtherMessagesAreRefusedWithASentence) {
  start();
  EXPECT_TRUE(process("walk")->write_bytes("{}", 1));
  EXPECT_EQ(told().problem(0), "walk: expected a message foresight.LiveParameters, got something else");
  EXPECT_TRUE(process("talk", "json")->write_bytes("{}", 1));
  EXPECT_EQ(told().problem(0), "talk: expected a message foresight.LiveParameters, got something else");
  announce("a.b", {number("height", 2, 2)});
  EXPECT_EQ(told().problem(0), "a.b: expected a name of a process of 1 to 32 letters, digits, '_' and '-'");
  EXPECT_EQ(told().parameter_size(), 0);
}

TEST_F(Live, EveryTruncationAndFlippedByteLeavesTheTableRight) {
  start();
  LiveParameters message;
  *message.add_parameter() = number("height", 2, 3);
  LiveParameter choice;
  choice.set_name("gait");
  choice.set_type(LiveParameter::TYPE_CHOICE);
  choice.set_text("slow");
  choice.set_initial_text("slow");
  choice.add_choice("slow");
  *message.add_parameter() = choice;
  const std::string bytes = message.SerializeAsString();
  const auto try_one = [&](const std::string& wrong) {
    EXPECT_TRUE(process("walk")->write_bytes(wrong, 1));
    EXPECT_EQ(static_cast<std::size_t>(told().parameter_size()), parameters.names().size());
    for (const std::string& name : parameters.names())
      if (const auto value = parameters.get(name)) {
        EXPECT_EQ(refusal(name, *value), "") << name;
      }
  };
  for (std::size_t n = 0; n < bytes.size(); ++n) try_one(bytes.substr(0, n));
  std::mt19937 random(1);
  for (std::size_t n = 0; n < bytes.size(); ++n)
    for (int i = 0; i < 8; ++i) {
      std::string wrong = bytes;
      wrong[n] = static_cast<char>(random());
      try_one(wrong);
    }
}

TEST_F(Live, AfterTheServiceNothingIsTold) {
  start();
  announce("walk", {number("height", 2, 2)});
  service.reset();
  announce("walk", {number("height", 3, 3)});
  EXPECT_EQ(refusal("walk.height", 6.0), "");
  EXPECT_EQ(told().parameter(0).number(), 2);
}

TEST_F(Live, PeopleSetWhileProcessesComeAndGo) {
  start();
  std::thread person([&] {
    for (int i = 0; i < 2000; ++i) (void)parameters.set("walk.height", static_cast<double>(i % 10));
  });
  for (int i = 0; i < 200; ++i) {
    announce("walk", {number("height", 2, 2)});
    service->ended("/14/2/live_parameters/walk");
  }
  person.join();
  announce("walk", {number("height", 2, 2)});
  EXPECT_EQ(told().parameter(0).number(), parameters.number("walk.height"));
}

}  // namespace
}  // namespace robot::app
