#include "robot/net/foxglove/hub.h"

#include <gtest/gtest.h>

#include <limits>

#include <thread>

#include "tests/robot/net/foxglove/hub_fixture.h"

namespace robot::net {
namespace {

TEST_F(HubTest, AClientReceivesServerInfoAndChannels) {
  const auto client = hub->join({});
  const auto messages = said(*client);
  ASSERT_EQ(messages.size(), 3u);
  EXPECT_EQ(messages[0]["op"], "serverInfo");
  EXPECT_EQ(messages[0]["capabilities"], (Json{"time", "parameters", "parametersSubscribe", "services"}));
  EXPECT_EQ(messages[0]["metadata"]["robots"], "14/2");
  const Json& channels = messages[1]["channels"];
  ASSERT_EQ(channels.size(), 4u);
  EXPECT_EQ(channels[0]["metadata"], (Json{{"delivery", "latest"}, {"robot", "14/2"}, {"object", "base"}}));
  EXPECT_EQ(channels[1]["topic"], "/14/2/base/twice");
  EXPECT_EQ(channels[1]["metadata"],
            (Json{{"delivery", "latest"}, {"robot", "14/2"}, {"object", "base/twice"}, {"derived", "true"}}));
  EXPECT_EQ(channels[3]["metadata"], (Json{{"delivery", "latest"}, {"object", "truth/world"}}));
  EXPECT_EQ(channels[0]["schema"], "c2NoZW1h");
  EXPECT_EQ(messages[2]["services"][0]["name"], "clock_sync");
}

TEST_F(HubTest, LaterChannelsAreAdvertisedAndATopicOnlyOnce) {
  const auto client = join();
  TestChannel late("/15/3/ball"), again("/15/3/ball");
  hub->add_channel(late.channel, derive_twice);
  hub->add_channel(again.channel, derive_twice);
  const auto messages = said(*client);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0]["channels"][0]["metadata"]["robot"], "15/3");
}

TEST_F(HubTest, AStreamRunsFromTheFirstSubscriberToTheLast) {
  const auto one = join(), two = join();
  subscribe(*one, 1, 7);
  auto& provider = streams.wait_started(1);
  subscribe(*two, 1, 8);
  EXPECT_TRUE(provider.write(base.write("a")));
  drain();
  EXPECT_EQ(said(*one).at(0), (Json{{"op", "data"}, {"sub", 7}, {"text", "a"}}));
  EXPECT_EQ(said(*two).at(0), (Json{{"op", "data"}, {"sub", 8}, {"text", "a"}}));
  hub->on_text(*one, R"({"op":"unsubscribe","subscriptionIds":[7]})");
  EXPECT_TRUE(provider.write(base.write("b")));
  drain();
  EXPECT_EQ(gist(*one), "");
  EXPECT_EQ(gist(*two), "data:b");
  hub->leave(*two);
  streams.wait_log("+/14/2/base -1 ");
  subscribe(*one, 1, 9);
  streams.wait_log("+/14/2/base -1 +/14/2/base ");
}

TEST_F(HubTest, ALateSubscriberGetsTheLastValueAtOnceAndOnce) {
  const auto one = join(), two = join();
  subscribe(*one, 1);
  auto& provider = streams.wait_started(1);
  const auto version = base.write("a");
  EXPECT_TRUE(provider.write(version));
  subscribe(*two, 1);
  EXPECT_EQ(gist(*two), "data:a");
  drain();
  EXPECT_EQ(gist(*one), "data:a");
  EXPECT_EQ(gist(*two), "");
}

TEST_F(HubTest, ADerivedChannelConvertsItsMessages) {
  const auto one = join(), two = join();
  subscribe(*one, 2);
  auto& provider = streams.wait_started(1);
  EXPECT_TRUE(provider.write(base.write("ab")));
  EXPECT_TRUE(provider.write(base.write("skip")));
  const auto failed = provider.write(base.write("fail"));
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error(), "/14/2/base/twice: told to fail");
  drain();
  EXPECT_EQ(gist(*one), "data:abab");
  subscribe(*two, 2);
  EXPECT_EQ(gist(*two), "data:abab");
}

TEST_F(HubTest, WrongSubscriptionsAreAnsweredAndTheConnectionStays) {
  const auto client = join();
  subscribe(*client, 99);
  subscribe(*client, 1, 1);
  subscribe(*client, 2, 1);
  subscribe(*client, 1, 2);
  hub->on_text(*client, R"({"op":"unsubscribe","subscriptionIds":[5]})");
  EXPECT_EQ(gist(*client),
            "status:subscribe: there is no channel 99 status:subscribe: the subscription id 1 is in use "
            "status:subscribe: /14/2/base is subscribed already status:unsubscribe: there is no subscription 5");
  hub->on_text(*client, "nonsense");
  hub->on_binary(*client, "");
  hub->on_binary(*client, foxglove::to_bytes(foxglove::ClientPublish{1, "x"}));
  hub->on_text(*client, R"({"op":"fetchAsset","uri":"x","requestId":1})");
  const auto messages = said(*client);
  ASSERT_EQ(messages.size(), 4u);
  for (const Json& message : messages) EXPECT_EQ(message["level"], 2);
  EXPECT_FALSE(client->queue.finished());
}

TEST_F(HubTest, AnOverflowingReliableChannelEndsOnlyItsConnection) {
  const auto slow = join(), quick = join();
  subscribe(*slow, 3);
  subscribe(*quick, 3);
  auto& provider = streams.wait_started(1);
  for (const char* text : {"123456", "789012"}) {
    EXPECT_TRUE(provider.write(events.write(text)));
    drain();
    EXPECT_EQ(gist(*quick), "data:" + std::string(text));
  }
  EXPECT_EQ(gist(*slow),
            "status:the connection is too slow for /14/2/events, whose messages must not be dropped: it is closed, "
            "connect again to go "
            "on close");
  EXPECT_FALSE(quick->queue.finished());
}

TEST_F(HubTest, ALosslessClientIsDisconnectedWhenAMessageIsMissing) {
  const auto lossless = join(true), other = join();
  subscribe(*lossless, 1);
  subscribe(*other, 1);
  auto& provider = streams.wait_started(1);
  EXPECT_TRUE(provider.write(base.write("a")));
  base.write("lost");
  EXPECT_TRUE(provider.write(base.write("b")));
  drain();
  EXPECT_EQ(gist(*lossless),
            "status:1 messages of /14/2/base were lost on the robot, but this connection must get all: it is closed, "
            "connect again to "
            "go on close");
  EXPECT_EQ(gist(*other), "data:b");
  EXPECT_EQ(hub->statistics().clients.at(1).channels.at(0).dropped, 2u);  // the lost one, and "a", which "b" replaced
}

TEST_F(HubTest, TimeDoesNotGoBackExceptWithANewSession) {
  const auto client = join();
  const auto time_of = [&] { return said(*client).at(0)["bytes"].get<std::string>(); };
  clock.set(5000);
  hub->send_time();
  EXPECT_EQ(time_of(), foxglove::time(5000).substr(1));
  clock.set(4000);
  hub->send_time();
  EXPECT_EQ(time_of(), foxglove::time(5000).substr(1));
  hub->restart_time();
  EXPECT_EQ(gist(*client), "serverInfo");
  hub->send_time();
  EXPECT_EQ(time_of(), foxglove::time(4000).substr(1));
}

TEST_F(HubTest, AClientWithControlPausesAndSeeksARecording) {
  HandPlayback playback;
  make_hub(&playback);
  const auto unaware = join();
  const auto stranger = hub->join({.context = {.address = "10.0.0.9:1"}, .playback = true});
  const auto first = said(*stranger);
  EXPECT_EQ(first.at(0)["capabilities"].back(), "playbackControl");
  EXPECT_EQ(first.at(0)["dataStartTime"], Json({{"sec", 0}, {"nsec", 1000}}));
  EXPECT_EQ(first.at(0)["dataEndTime"], Json({{"sec", 9}, {"nsec", 5}}));
  EXPECT_EQ(first.back()["bytes"], foxglove::playback_state(foxglove::Playback::playing, 0, 1, false, "").substr(1));

  const auto wish = [&](Client& client, float speed, std::optional<std::uint64_t> to_ns) {
    hub->on_binary(client, foxglove::to_bytes(foxglove::PlaybackControl{false, speed, to_ns, "r1"}));
  };
  wish(*stranger, 1, 5000);
  EXPECT_NE(gist(*stranger).find("needs the control token"), std::string::npos);
  const auto owner = join();
  for (const float speed : {0.F, -1.F, 1001.F, std::numeric_limits<float>::quiet_NaN()}) {
    wish(*owner, speed, 5000);
    EXPECT_NE(gist(*owner).find("expected a speed of 0.01 .. 1000"), std::string::npos);
  }
  EXPECT_EQ(playback.now.time_ns, 0u);

  subscribe(*stranger, 1);
  said(*stranger);
  clock.set(8000);
  hub->send_time();
  said(*stranger);
  hub->deliver({1, 1, base.write("before the seek")});
  wish(*owner, 2, 5000);
  EXPECT_EQ(said(*owner).back()["bytes"],
            foxglove::playback_state(foxglove::Playback::paused, 5000, 2, true, "r1").substr(1));
  const auto told = said(*stranger);  // unsent messages are dropped
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0]["bytes"], foxglove::playback_state(foxglove::Playback::paused, 5000, 2, true, "").substr(1));

  EXPECT_EQ(gist(*unaware), "");

  clock.set(5000);
  playback.now.status = foxglove::Playback::ended;  // by itself
  hub->send_time();
  const auto end = said(*stranger);
  ASSERT_EQ(end.size(), 2u);
  EXPECT_EQ(end[0]["bytes"], foxglove::playback_state(foxglove::Playback::ended, 5000, 2, false, "").substr(1));
  EXPECT_EQ(end[1]["bytes"], foxglove::time(5000).substr(1));
}

TEST_F(HubTest, ALiveServerRefusesPlaybackControl) {
  const auto client = join();
  hub->on_binary(*client, foxglove::to_bytes(foxglove::PlaybackControl{true, 1, 5000, "r1"}));
  EXPECT_EQ(gist(*client), "status:playback: this server does not play a recording");
}

TEST_F(HubTest, ParametersAreReadSetAndSubscribed) {
  const auto client = join(), watcher = join();
  hub->on_text(*watcher, R"({"op":"subscribeParameterUpdates","parameterNames":[]})");
  hub->on_text(*client, R"({"op":"getParameters","parameterNames":[],"id":"all"})");
  EXPECT_EQ(said(*client).at(0),
            Json::parse(R"({"op":"parameterValues","id":"all","parameters":[{"name":"quality","value":75}]})"));
  hub->on_text(*client, R"({"op":"setParameters","parameters":[{"name":"quality","value":200}],"id":"s"})");
  auto answers = said(*client);
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[0]["message"], "parameter 'quality': expected 1 .. 100, got 200");
  EXPECT_EQ(answers[1]["parameters"][0]["value"], 75);
  hub->on_text(*client, R"({"op":"setParameters","parameters":[{"name":"quality","value":50}]})");
  EXPECT_EQ(said(*client).at(0)["parameters"][0]["value"], 50);
  hub->parameter_changed("quality");
  EXPECT_EQ(said(*watcher).at(0)["parameters"][0]["value"], 50);
  EXPECT_EQ(gist(*client), "");
}

TEST_F(HubTest, ManyParametersAreSetByOneRequestAndRefusedByOneSentence) {
  Json request{{"op", "setParameters"}, {"id", "many"}, {"parameters", Json::array()}};
  for (int i = 0; i < 200; ++i) request["parameters"].push_back({{"name", "quality"}, {"value", i}});
  const auto client = join(), stranger = join(false, false);
  hub->on_text(*client, request.dump());
  const auto answers = said(*client);
  ASSERT_EQ(answers.size(), 1u + 1 + 99);  // 0 and 101 .. 199 are out of range
  EXPECT_EQ(answers.back()["parameters"][0]["value"], 100);
  hub->on_text(*stranger, request.dump());
  const auto refused = said(*stranger);
  ASSERT_EQ(refused.size(), 2u);
  EXPECT_EQ(refused[0]["message"].get<std::string>().find("parameter 'quality' and 199 more: "), 0u);
}

TEST_F(HubTest, ControlNeedsTheTokenAndClockSyncDoesNot) {
  const auto stranger = join(false, false);
  hub->on_text(*stranger, R"({"op":"setParameters","parameters":[{"name":"quality","value":50}],"id":"s"})");
  const auto answers = said(*stranger);
  EXPECT_NE(answers.at(0)["message"].get<std::string>().find("needs the control token"), std::string::npos);
  EXPECT_EQ(answers.at(0)["cause"], "token");
  EXPECT_EQ(answers.at(1)["parameters"][0]["value"], 75);
  hub->on_binary(*stranger, foxglove::to_bytes(foxglove::ServiceCall{1, 5, "json", R"({"sent_ns":"1"})"}));
  EXPECT_NE(said(*stranger).at(0)["bytes"].get<std::string>().find(R"("ok":true,"received_ns":"1000")"),
            std::string::npos);
  ask(*stranger, "a");
  EXPECT_NE(answered(*stranger).at(0)["error"].get<std::string>().find("needs the control token"), std::string::npos);
  hub->on_binary(*stranger, foxglove::to_bytes(foxglove::ServiceCall{9, 5, "json", "{}"}));
  EXPECT_EQ(gist(*stranger), "serviceCallFailure:there is no service 9 status:there is no service 9");
}

TEST_F(HubTest, AFactThatIsLearntLateReachesAllClientsInTheSameSession) {
  const auto early = hub->join({});
  const Json before = said(*early).at(0);
  EXPECT_FALSE(before["metadata"].contains("rules"));
  hub->set_metadata("rules", "spl2012:4");
  const auto late = hub->join({});
  for (const auto& client : {early, late}) {
    const Json info = said(*client).at(0);
    EXPECT_EQ(info["op"], "serverInfo");
    EXPECT_EQ(info["metadata"]["rules"], "spl2012:4");
    EXPECT_EQ(info["sessionId"], before["sessionId"]);
  }
}

TEST_F(HubTest, DuringAGameClientsOfOtherMachinesHaveNoControl) {
  const auto early = join();
  hub->set_match_mode(true);
  const auto late = join();
  const auto set = [&](Client& client) {
    hub->on_text(client, R"({"op":"setParameters","parameters":[{"name":"quality","value":50}]})");
    return said(client).at(0).dump();
  };
  EXPECT_NE(set(*early).find("a game is in progress"), std::string::npos);
  EXPECT_NE(set(*late).find("a game is in progress"), std::string::npos);
  hub->set_match_mode(false);
  EXPECT_NE(set(*early).find("\"value\":50"), std::string::npos);
}

TEST_F(HubTest, OneQuestionRunsOneWaitsAndTheNextIsRefused) {
  holds_questions = true;
  const auto one = join(), two = join(), three = join();
  ask(*one, "a");
  ask(*two, "b");
  ask(*three, "c");
  ASSERT_EQ(background.size(), 1u);
  EXPECT_EQ(answered(*three),
            (std::vector<Json>{{{"ok", false},
                                {"error",
                                 "think: another question is running and one more waits: ask again when they are "
                                 "answered"}}}));
  do_next();
  EXPECT_EQ(answered(*one), (std::vector<Json>{{{"ok", true}, {"about", "a"}}}));
  EXPECT_TRUE(answered(*two).empty());
  ask(*three, "d");
  do_next();
  EXPECT_EQ(answered(*two), (std::vector<Json>{{{"ok", true}, {"about", "b"}}}));
  do_next();
  EXPECT_EQ(answered(*three), (std::vector<Json>{{{"ok", true}, {"about", "d"}}}));
  EXPECT_TRUE(background.empty());
}

TEST_F(HubTest, AQuestionOfADisconnectedClientIsNotBegun) {
  holds_questions = true;
  auto one = join(), two = join();
  const auto three = join();
  ask(*one, "a");
  ask(*two, "b");
  hub->leave(*two);
  ask(*three, "c");
  hub->leave(*one);  // its question is running, and no client waits for the answer
  one.reset();
  do_next();
  do_next();
  EXPECT_EQ(thought_about, (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ(answered(*three), (std::vector<Json>{{{"ok", true}, {"about", "c"}}}));
  EXPECT_TRUE(background.empty());
}

TEST_F(HubTest, QuestionsAreAnsweredDuringAGameToo) {
  holds_questions = true;
  const auto local = hub->join({.context = {.loopback = true, .may_control = true}}), other = join();
  said(*local);
  ask(*other, "a");
  ask(*local, "b");
  hub->set_match_mode(true);
  do_next();
  EXPECT_EQ(answered(*other), (std::vector<Json>{{{"ok", true}, {"about", "a"}}}));
  do_next();
  EXPECT_EQ(answered(*local), (std::vector<Json>{{{"ok", true}, {"about", "b"}}}));
  ask(*other, "c");
  do_next();
  EXPECT_EQ(answered(*other), (std::vector<Json>{{{"ok", true}, {"about", "c"}}}));
  hub->set_match_mode(false);
  ask(*local, "d");
  do_next();
  EXPECT_EQ(answered(*local), (std::vector<Json>{{{"ok", true}, {"about", "d"}}}));
}

TEST_F(HubTest, ARoundTripIsMeasuredAndSilenceEndsTheConnection) {
  const auto client = join();
  hub->every_second(1 * kSecond);
  EXPECT_EQ(gist(*client), "ping");
  hub->on_pong(*client, 1 * kSecond + 42);
  hub->on_pong(*client, 9 * kSecond);  // a pong without a ping has no effect
  EXPECT_EQ(hub->statistics().clients.at(0).round_trip_ns, 42u);
  hub->every_second(2 * kSecond);
  hub->every_second(30 * kSecond);
  EXPECT_EQ(gist(*client), "ping");
  hub->every_second(33 * kSecond);
  EXPECT_EQ(gist(*client), "status:the connection has not answered for too long: it is closed close");
}

TEST_F(HubTest, ManyDropsAreReportedAndTheReportIsWithdrawn) {
  const auto client = join();
  subscribe(*client, 1);
  auto& provider = streams.wait_started(1);
  const auto write = [&](int messages) { send(*client, provider, messages); };
  write(4);
  hub->every_second(5 * kSecond);
  EXPECT_EQ(gist(*client), "ping") << "a few drops are not reported";
  write(31);
  hub->every_second(10 * kSecond);
  const auto told = said(*client);
  EXPECT_EQ(told.at(0)["id"], "drops");
  EXPECT_EQ(told.at(0)["level"], 1);
  EXPECT_EQ(told.at(0)["message"],
            "30 of 31 messages of /14/2/base were dropped for newer ones in the last 5 s: the connection or the page "
            "is too slow");
  hub->every_second(12 * kSecond);
  EXPECT_EQ(gist(*client), "");
  hub->every_second(16 * kSecond);
  EXPECT_EQ(gist(*client), "removeStatus");
}

TEST_F(HubTest, DropsAreNotReportedOfATopicThatIsNotWatchedOrHardlySuffers) {
  const auto client = join();
  subscribe(*client, 1);
  auto& provider = streams.wait_started(1);
  const auto write = [&](int messages) { send(*client, provider, messages); };
  for (int i = 0; i < 100; ++i) write(1);
  write(31);  // 30 are dropped of 131
  hub->every_second(5 * kSecond);
  EXPECT_EQ(gist(*client), "ping");
  write(31);
  hub->on_text(*client, R"({"op":"unsubscribe","subscriptionIds":[1]})");
  hub->every_second(10 * kSecond);
  EXPECT_EQ(gist(*client), "");
}

TEST(Inbox, WakesOncePerBatchAndHoldsBackWhenFull) {
  int woken = 0;
  Inbox inbox(10, [&] { ++woken; });
  TestChannel channel;
  bool cancelled = false;
  EXPECT_TRUE(inbox.put({1, 1, channel.write("123456789012")}, cancelled));  // alone it may be larger
  inbox.post([] {});
  EXPECT_EQ(woken, 1);

  std::thread blocked([&] { EXPECT_TRUE(inbox.put({1, 1, channel.write("x")}, cancelled)); });
  Inbox::Contents contents;
  inbox.take(contents);
  EXPECT_EQ(contents.tasks.size(), 1u);
  blocked.join();
  inbox.take(contents);  // or the batch before had both

  EXPECT_TRUE(inbox.put({1, 1, channel.write("1234567890")}, cancelled));
  std::thread waiting([&] { EXPECT_FALSE(inbox.put({1, 1, channel.write("1234567890")}, cancelled)); });
  inbox.cancel(cancelled);
  waiting.join();
  inbox.close();
  bool other = false;
  EXPECT_FALSE(inbox.put({1, 1, channel.write("x")}, other));
}

}  // namespace
}  // namespace robot::net
