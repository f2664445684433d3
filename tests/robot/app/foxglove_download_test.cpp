#include "robot/app/foxglove_download.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <vector>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/truth.pb.h"
#include "robot/core/clock.h"
#include "robot/logging/mcap/mcap_file.h"
#include "robot/logging/mcap/ordered_reader.h"
#include "robot/logging/mcap/writer.h"
#include "robot/memory/schema.h"
#include "tests/robot/net/scene/decoded.h"
#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

using nlohmann::json;

/// A recording of a pose, the truth and a camera, one message of each per tenth of a second.
class Recording {
 public:
  explicit Recording(int messages) {
    const std::vector<memory::ChannelInfo> infos = {
        {.topic = "/14/2/pose", .schema = memory::schema_of(*foresight::Pose::descriptor())},
        {.topic = "/truth/world", .schema = memory::schema_of(*foresight::GroundTruth::descriptor())},
        {.topic = "/14/2/camera_top", .schema = memory::schema_of(*foresight::Image::descriptor())}};
    auto writer = logging::McapWriter::open(std::make_unique<MemorySink>(bytes_), infos, {.first_channel_id = 5});
    for (int i = 0; i < messages; ++i) {
      foresight::Pose pose;
      pose.set_x(static_cast<float>(i));
      foresight::GroundTruth truth;
      truth.mutable_ball()->set_x(static_cast<float>(i));
      foresight::Image image;
      image.set_encoding(foresight::Image::ENCODING_JPEG);
      image.set_data("a jpeg");
      const std::string parts[] = {pose.SerializeAsString(), truth.SerializeAsString(), image.SerializeAsString()};
      const std::uint64_t capture_ns = kSecond + static_cast<std::uint64_t>(i) * kSecond / 10;
      for (std::size_t channel = 0; channel < std::size(parts); ++channel)
        EXPECT_TRUE(writer->write(channel, {.capture_ns = capture_ns, .bytes = parts[channel]}, capture_ns));
      EXPECT_TRUE(writer->write(0, {.capture_ns = capture_ns, .bytes = "\xff\xff"}, capture_ns));
    }
    EXPECT_TRUE(writer->close());
  }
  std::shared_ptr<const ByteSource> source() const { return std::make_shared<MemorySource>(bytes_); }

 private:
  std::string bytes_;
};

class FoxgloveFile : public testing::Test {
 protected:
  const tests::TemporaryFolder folder;

  std::shared_ptr<const ByteSource> make(const Recording& recording) {
    const auto made = foxglove_file(recording.source(), folder.path(), "spl2012", {});
    EXPECT_TRUE(made) << made.error();
    return made ? *made : nullptr;
  }

  /// Returns the messages of each topic, decoded by the schemas in the file.
  static std::map<std::string, std::vector<json>> read(const std::shared_ptr<const ByteSource>& source) {
    std::map<std::string, std::vector<json>> topics;
    const auto file = *logging::McapFile::open(source);
    logging::OrderedReader reader(file);
    while (true) {
      const auto message = reader.next();
      EXPECT_TRUE(message);
      if (!message || !*message) return topics;
      const auto& channel = file->index().channels.at((*message)->channel_id);
      EXPECT_GT((*message)->channel_id, 7);  // the recording has 5 to 7
      const auto info = logging::channel_info(channel, file->index().schemas);
      topics[info.topic].push_back(tests::decoded(info.schema, (*message)->record.bytes));
    }
  }
};

TEST_F(FoxgloveFile, HoldsWhatOtherViewersDraw) {
  const auto topics = read(make(Recording(10)));
  std::vector<std::string> names;
  for (const auto& [topic, messages] : topics) names.push_back(topic);
  EXPECT_EQ(names, (std::vector<std::string>{"/14/2/camera_top/jpeg", "/14/2/pose/points", "/14/2/pose/scene",
                                             "/14/2/pose/transforms", "/field/points", "/field/scene",
                                             "/truth/world/points", "/truth/world/scene"}));
  for (const char* topic : {"/14/2/pose/scene", "/14/2/pose/transforms", "/truth/world/scene", "/14/2/camera_top/jpeg"})
    EXPECT_EQ(topics.at(topic).size(), 10u) << topic;
  EXPECT_EQ(topics.at("/field/scene").size(), 1u);
  EXPECT_EQ(topics.at("/truth/world/points").size(), 5u);  // 1 s at 5 Hz
  const json& ball = topics.at("/truth/world/scene").at(7)["entities"][0];
  EXPECT_EQ(ball["id"], "ball");
  EXPECT_EQ(ball["spheres"][0]["pose"]["position"]["x"], 7);
  EXPECT_EQ(topics.at("/14/2/pose/transforms").at(3)["transforms"][0]["translation"]["x"], 3);
  // the field of 2012 is 6 m long
  for (const json& entity : topics.at("/field/scene").front()["entities"])
    EXPECT_TRUE(entity["id"] != "lines" || entity["lines"][0]["points"][0]["x"] == -3) << entity;
}

TEST_F(FoxgloveFile, TheSameRecordingGivesTheSameBytes) {
  const Recording recording(5);
  const auto one = make(recording), other = make(recording);
  EXPECT_EQ(*read_bytes(*one, 0, one->size()), *read_bytes(*other, 0, other->size()));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));  // the file has no name
}

TEST_F(FoxgloveFile, EndsWhenTheClientHasLeft) {
  const auto made = foxglove_file(Recording(5).source(), folder.path(), "", [] { return true; });
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error(), "download: the client has left");
}

TEST_F(FoxgloveFile, OfNoRecordingIsAnError) {
  EXPECT_FALSE(foxglove_file(std::make_shared<MemorySource>("no mcap"), folder.path(), "", {}));
  EXPECT_FALSE(foxglove_file(Recording(1).source(), folder.path() / "missing", "", {}));
}

}  // namespace
}  // namespace robot::app
