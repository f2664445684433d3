#include "robot/logging/mcap/topic_streams.h"

#include <gtest/gtest.h>

namespace robot::logging {
namespace {

/// An index with a channel for each number of messages. All have one topic.
McapIndex index_of(const std::vector<mcap::Channel>& channels, const mcap::Numbers<std::uint16_t>& messages) {
  McapIndex index;
  index.schemas[1] = {1, "a.Old", "protobuf", "x"};
  index.schemas[2] = {2, "a.New", "protobuf", "xyz"};
  index.schemas[3] = {3, "a.Old", "protobuf", "x"};
  for (const mcap::Channel& channel : channels) index.channels[channel.id] = channel;
  index.statistics.channel_messages = messages;
  return index;
}

TEST(TopicStreams, JoinChannelsThatAreReadAlike) {
  const auto streams = topic_streams(
      index_of({{1, 1, "/a", "protobuf", {}}, {2, 3, "/a", "protobuf", {{"from", "x"}}}, {3, 0, "/b", "json", {}}},
               {{1, 5}, {2, 6}}));
  ASSERT_EQ(streams.size(), 2u);
  EXPECT_EQ(streams[0].channels, (std::set<std::uint16_t>{1, 2}));
  EXPECT_EQ(streams[0].messages, 11u);
  EXPECT_EQ(streams[0].note, "");
  EXPECT_EQ(streams[1].info.topic, "/b");
}

TEST(TopicStreams, OfDifferentChannelsHaveThoseWithTheMostMessagesAndNameTheOthers) {
  const auto streams =
      topic_streams(index_of({{1, 1, "/a", "protobuf", {}}, {2, 2, "/a", "protobuf", {}}, {3, 0, "/a", "json", {}}},
                             {{1, 5}, {2, 60}, {3, 7}}));
  ASSERT_EQ(streams.size(), 1u);
  EXPECT_EQ(streams[0].channels, std::set<std::uint16_t>{2});
  EXPECT_EQ(streams[0].messages, 60u);
  EXPECT_EQ(streams[0].left_out, 12u);
  EXPECT_EQ(streams[0].note,
            "/a: 5 messages of channel 1 left out: expected protobuf of schema \"a.New\" (protobuf, 3 bytes) as in "
            "channel 2, got protobuf of schema \"a.Old\" (protobuf, 1 bytes); /a: 7 messages of channel 3 left out: "
            "expected protobuf of schema \"a.New\" (protobuf, 3 bytes) as in channel 2, got json without a schema");
}

TEST(TopicStreams, OfChannelsWithEquallyManyMessagesHaveTheFirst) {
  const auto streams =
      topic_streams(index_of({{4, 1, "/a", "protobuf", {}}, {9, 2, "/a", "protobuf", {}}}, {{4, 5}, {9, 5}}));
  EXPECT_EQ(streams.at(0).channels, std::set<std::uint16_t>{4});
}

}  // namespace
}  // namespace robot::logging
