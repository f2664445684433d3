// Playheads of single clients beside the shared playback of a recording.
#include <gtest/gtest.h>

#include "robot/net/foxglove/hub.h"
#include "tests/robot/net/foxglove/hub_fixture.h"

namespace robot::net {
namespace {

constexpr std::uint32_t kBase = 1, kTwice = 2, kEvents = 3;

struct OwnPlayheads : HubTest {
  void SetUp() override {
    HubTest::SetUp();
    make_hub(&playback);
  }
  void TearDown() override {
    hub.reset();  // clients and their playheads go before the playback
    HubTest::TearDown();
  }
  std::shared_ptr<Client> join_own(std::uint64_t from_ns = 0) {
    return hub->join({.context = {.address = "10.0.0.9:1"}, .playback = true, .playhead = from_ns});
  }
  HandPlayhead& own_of(std::uint64_t made_ns) { return *playback.own.at(made_ns); }
  void choose(Client& client, bool own) {
    hub->on_text(client, own ? R"({"op":"playhead","own":true})" : R"({"op":"playhead","own":false})");
  }
  void wish(Client& client, bool play, std::optional<std::uint64_t> to_ns) {
    hub->on_binary(client, foxglove::to_bytes(foxglove::PlaybackControl{play, 1, to_ns, "r1"}));
  }
  static std::string state(foxglove::Playback status, std::uint64_t time_ns, bool did_seek, std::string_view id = "") {
    return foxglove::playback_state(status, time_ns, 1, did_seek, id).substr(1);
  }
  HandPlayback playback;
};

TEST_F(OwnPlayheads, BeginPausedWhereTheClientAsksAndAreReported) {
  playback.now = {.status = foxglove::Playback::playing, .time_ns = 4000};
  const auto client = join_own(5000);
  const auto first = said(*client);
  EXPECT_EQ(first.at(first.size() - 2), Json({{"op", "playhead"}, {"own", true}}));
  EXPECT_EQ(first.back()["bytes"], state(foxglove::Playback::paused, 5000, false));
  // 0 means the start of the recording
  const auto other = join_own();
  EXPECT_EQ(said(*other).back()["bytes"], state(foxglove::Playback::paused, 1000, false));
}

TEST_F(OwnPlayheads, AreMovedWithoutATokenAndMoveNobodyElse) {
  const auto one = join_own(5000), shared = hub->join({.playback = true});
  said(*one);
  said(*shared);
  wish(*one, true, 6000);
  EXPECT_EQ(said(*one).at(0)["bytes"], state(foxglove::Playback::playing, 6000, true, "r1"));
  EXPECT_EQ(gist(*shared), "");
  EXPECT_EQ(playback.now.time_ns, 0u);
  EXPECT_EQ(own_of(5000).now.time_ns, 6000u);

  // and the other way round
  const auto owner = join();
  wish(*owner, false, 2000);
  EXPECT_EQ(said(*shared).at(0)["bytes"], state(foxglove::Playback::paused, 2000, true));
  EXPECT_EQ(gist(*one), "");
  hub->send_time();
  EXPECT_EQ(said(*one).at(0)["bytes"], foxglove::time(6000).substr(1));
}

TEST_F(OwnPlayheads, CarryTheTopicsOfTheRecordingAndTheirDerivedChannels) {
  const auto one = join_own(5000), shared = hub->join({.playback = true});
  subscribe(*one, kBase, 1);
  subscribe(*one, kTwice, 2);
  subscribe(*shared, kBase, 1);
  said(*one);
  said(*shared);
  EXPECT_EQ(own_of(5000).watches, 2);
  auto& base_of_one = streams.wait_started(1);
  EXPECT_TRUE(base_of_one.write(own_of(5000).base.write("a")));
  EXPECT_TRUE(streams.wait_started(2).write(own_of(5000).base.write("b")));
  EXPECT_TRUE(streams.wait_started(3).write(base.write("c")));
  drain();
  EXPECT_EQ(gist(*one), "data:a data:bb");
  EXPECT_EQ(gist(*shared), "data:c");

  hub->on_text(*one, foxglove::to_text(foxglove::Unsubscribe{{1, 2}}));
  EXPECT_EQ(own_of(5000).watches, 0);
  streams.wait_log("+/14/2/base +/14/2/base +/14/2/base -1 -2 ");
}

TEST_F(OwnPlayheads, GetObjectsOfTheServerItselfWithTheirOwnTime) {
  const auto one = join_own(5000);
  subscribe(*one, kEvents);
  said(*one);
  EXPECT_TRUE(streams.wait_started(1).write(events.write("x")));
  drain();
  Batch batch;
  std::string bytes;
  while (one->queue.fill(batch)) bytes.append(batch.bytes).append(batch.large);
  const auto data = foxglove::parse_message_data(bytes.substr(2));
  ASSERT_TRUE(data && *data);
  EXPECT_EQ((*data)->log_time_ns, 5000u);
}

TEST_F(OwnPlayheads, BeginWhereTheSharedOneIsWhenAClientLeavesIt) {
  playback.now = {.status = foxglove::Playback::playing, .time_ns = 4000};
  const auto client = hub->join({.playback = true});
  subscribe(*client, kBase);
  EXPECT_TRUE(streams.wait_started(1).write(base.write("shared")));
  drain();
  said(*client);
  choose(*client, true);
  auto answer = said(*client);
  EXPECT_EQ(answer.at(0), Json({{"op", "playhead"}, {"own", true}}));
  EXPECT_EQ(answer.at(1)["bytes"], state(foxglove::Playback::playing, 4000, true));
  EXPECT_TRUE(streams.wait_started(2).write(own_of(4000).base.write("own")));
  drain();
  EXPECT_EQ(gist(*client), "data:own");  // also with a smaller number than the shared message

  // back again: the own playhead ends
  choose(*client, false);
  answer = said(*client);
  EXPECT_EQ(answer.at(0), Json({{"op", "playhead"}, {"own", false}}));
  EXPECT_EQ(answer.at(1)["bytes"], state(foxglove::Playback::playing, 4000, true));
  EXPECT_TRUE(streams.wait_started(3).write(base.write("shared again")));
  drain();
  EXPECT_EQ(gist(*client), "data:shared again");
  control.finish();
  EXPECT_TRUE(playback.own.empty());
}

TEST_F(OwnPlayheads, AClientFollowsIfThereAreTooMany) {
  playback.has_room = false;
  const auto client = join_own();
  const auto first = said(*client);
  EXPECT_EQ(first.at(first.size() - 3)["message"], "there are too many");
  EXPECT_EQ(first.at(first.size() - 2), Json({{"op", "playhead"}, {"own", false}}));
  EXPECT_EQ(first.back()["bytes"], state(foxglove::Playback::playing, 0, false));
}

TEST_F(OwnPlayheads, ReportTheirEndAndTheirNewBeginInALoop) {
  const auto client = join_own(5000);
  said(*client);
  own_of(5000).now.status = foxglove::Playback::ended;
  hub->send_time();
  EXPECT_EQ(said(*client).at(0)["bytes"], state(foxglove::Playback::ended, 5000, false));
  hub->send_time();
  EXPECT_EQ(gist(*client), "time");
  own_of(5000).now = {.status = foxglove::Playback::playing, .time_ns = 1000, .speed = 1};
  own_of(5000).loops = true;
  hub->send_time();
  EXPECT_EQ(said(*client).at(0)["bytes"], state(foxglove::Playback::playing, 1000, true));
}

TEST_F(OwnPlayheads, KeepTheirTimeLineWhenTheSharedOneBeginsAgain) {
  const auto one = join_own(5000), shared = hub->join({.playback = true});
  said(*one);
  said(*shared);
  hub->restart_time();
  EXPECT_EQ(gist(*one), "");
  EXPECT_EQ(said(*shared).at(0)["op"], "serverInfo");
}

TEST_F(OwnPlayheads, EndWithTheirClient) {
  const auto client = join_own(5000);
  subscribe(*client, kBase);
  hub->leave(*client);
  control.finish();
  EXPECT_TRUE(playback.own.empty());
  streams.wait_log("+/14/2/base -1 ");
}

TEST_F(OwnPlayheads, AreNotForALiveServer) {
  make_hub(nullptr);
  const auto client = join_own();
  said(*client);
  choose(*client, true);
  EXPECT_EQ(gist(*client), "status:playhead: this server does not play a recording");
}

TEST_F(OwnPlayheads, HaveNoChannelsThatAreMadeFromSeveralObjects) {
  hub->add_channel(world.channel, [](const memory::ChannelInfo& source) {
    std::vector<Derived> derived(1);
    derived[0].info = tests::channel_info(source.topic + "/scene", Delivery::latest);
    derived[0].needs_others = true;
    return derived;
  });
  const auto client = join_own();
  said(*client);
  std::uint32_t scene = 0;
  const auto other = hub->join({});
  for (const Json& message : said(*other))
    if (message["op"] == "advertise")
      for (const Json& channel : message["channels"])
        if (channel["topic"] == "/truth/world/scene") scene = channel["id"];
  subscribe(*client, scene);
  EXPECT_EQ(
      gist(*client),
      "status:subscribe: /truth/world/scene is of the shared playback only, and this client has a playhead of its "
      "own");
}

}  // namespace
}  // namespace robot::net
