#include "robot/memory/memory.h"

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <gtest/gtest.h>

#include <set>

namespace robot::memory {
namespace {

TEST(ObjectName, LeavesOutTheRobotOfATopic) {
  const auto is = [](std::string_view topic, std::string_view robot, std::string_view object) {
    const ObjectName name = object_name(topic);
    EXPECT_EQ(name.robot, robot) << topic;
    EXPECT_EQ(name.object, object) << topic;
  };
  is("/14/2/ball", "14/2", "ball");
  is("/14/2/camera_top/jpeg", "14/2", "camera_top/jpeg");
  is("/truth/world", "", "truth/world");
  is("/14/ball", "", "14/ball");
  is("/14/x/ball", "", "14/x/ball");
  is("/2d/1/ball", "", "2d/1/ball");
  is("odometry", "", "odometry");
  is("", "", "");
}

struct WholeMemory : ::testing::Test {
  ManualClock clock{1};
  std::shared_ptr<Memory> memory = std::make_shared<Memory>("14/2", clock);
  Channels channels;
};

TEST_F(WholeMemory, ListsEachObjectOnceUnderItsTopic) {
  ASSERT_TRUE(list(memory, channels));
  std::set<std::string> topics;
  for (const auto& channel : channels.all()) topics.insert(channel->info().topic);
  EXPECT_EQ(topics.size(), channels.all().size());
  EXPECT_TRUE(topics.contains("/14/2/ball"));
  EXPECT_TRUE(topics.contains("/14/2/camera_top"));
  EXPECT_TRUE(topics.contains("/truth/world"));
}

TEST_F(WholeMemory, ShowsTheSameValueTypedAndAsBytes) {
  ASSERT_TRUE(list(memory, channels));
  pb::Ball ball;
  ball.set_x(2);
  memory->ball.write(ball, 3);
  EXPECT_EQ(channels.find("/14/2/ball")->newest()->bytes(), ball.SerializeAsString());
}

TEST_F(WholeMemory, RefusesASecondMemoryOfTheSameRobot) {
  ASSERT_TRUE(list(memory, channels));
  const Result<void> again = list(std::make_shared<Memory>("14/2", clock), channels);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error(), "channel /14/2/camera_top: the topic is taken by another channel");
}

TEST_F(WholeMemory, IsKeptAliveByItsChannels) {
  ASSERT_TRUE(list(memory, channels));
  memory.reset();
  EXPECT_EQ(channels.find("/14/2/ball")->newest(), nullptr);
}

TEST_F(WholeMemory, CallsAWatcherOnceForEachChannel) {
  ASSERT_TRUE(list(memory, channels));
  std::multiset<std::string> heard;
  channels.watch([&](const std::shared_ptr<Channel>& channel) { heard.insert(channel->info().topic); });
  const std::size_t before = heard.size();
  ASSERT_TRUE(channels.add(std::make_shared<RawChannel>(ChannelInfo{.topic = "/14/2/vortex"}, clock)));
  EXPECT_EQ(before, channels.all().size() - 1);
  EXPECT_EQ(heard.size(), channels.all().size());
  EXPECT_EQ(heard.count("/14/2/vortex"), 1u);
}

TEST_F(WholeMemory, DoesNotCallARemovedWatcher) {
  std::size_t heard = 0;
  const auto watcher = channels.watch([&](const std::shared_ptr<Channel>&) { ++heard; });
  channels.unwatch(watcher);
  ASSERT_TRUE(channels.add(std::make_shared<RawChannel>(ChannelInfo{.topic = "/14/2/vortex"}, clock)));
  EXPECT_EQ(heard, 0u);
}

// a viewer that knows none of our messages reads them this way
TEST_F(WholeMemory, SchemasSufficeToReadTheBytes) {
  memory->visit([&](std::string_view name, auto& object, Delivery) {
    const Schema& schema = object.info().schema;
    google::protobuf::FileDescriptorSet files;
    ASSERT_TRUE(files.ParseFromString(schema.bytes)) << name;
    google::protobuf::DescriptorPool pool;
    for (const auto& file : files.file()) ASSERT_NE(pool.BuildFile(file), nullptr) << name << " " << file.name();
    EXPECT_NE(pool.FindMessageTypeByName(schema.name), nullptr) << name;
  });
}

}  // namespace
}  // namespace robot::memory
