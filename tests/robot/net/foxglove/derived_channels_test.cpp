#include "robot/net/foxglove/derived_channels.h"

#include <gtest/gtest.h>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/runtime.pb.h"
#include "proto/foxglove/CompressedImage.pb.h"
#include "proto/foxglove/Log.pb.h"
#include "proto/foxglove/RawImage.pb.h"
#include "robot/image/image_codec.h"
#include "robot/memory/schema.h"
#include "tests/robot/net/net_support.h"

namespace robot::net {
namespace {

template <class Message>
memory::ChannelInfo info_of(std::string topic) {
  return {.topic = std::move(topic), .schema = memory::schema_of(*Message::descriptor())};
}

class DerivedChannelsTest : public testing::Test {
 protected:
  Parameters parameters;
  ManualClock clock{1};
  memory::RawChannel channel{info_of<foresight::Image>("/14/2/camera_top"), clock};

  void SetUp() override { declare_image_parameters(parameters); }

  memory::VersionPtr version(const google::protobuf::Message& message, std::uint64_t capture_ns) {
    EXPECT_TRUE(channel.write_bytes(message.SerializeAsString(), capture_ns));
    return channel.newest();
  }
  static foresight::Image yuyv(std::uint32_t width, std::uint32_t height) {
    foresight::Image image;
    image.set_encoding(foresight::Image::ENCODING_YUYV);
    image.set_width(width);
    image.set_height(height);
    image.set_data(std::string(2 * width * height, '\x80'));
    return image;
  }
  Convert converter(std::size_t which) { return derived_channels(channel.info(), parameters).at(which).make_convert(); }
};

TEST_F(DerivedChannelsTest, BelongToImagesAndLogTextsOnly) {
  const auto topics = [&](const memory::ChannelInfo& info) {
    std::string list;
    for (const Derived& derived : derived_channels(info, parameters))
      list += derived.info.topic + " " + derived.info.schema.name + " ";
    return list;
  };
  EXPECT_EQ(topics(channel.info()),
            "/14/2/camera_top/raw foxglove.RawImage /14/2/camera_top/jpeg foxglove.CompressedImage ");
  EXPECT_EQ(topics(info_of<foresight::LogText>("/14/2/log")), "/14/2/log/foxglove foxglove.Log ");
  EXPECT_EQ(topics(info_of<foresight::CameraMatrix>("/14/2/camera_top_matrix")), "");
}

TEST_F(DerivedChannelsTest, RawImagesHoldThePixels) {
  const auto bytes = converter(0)(*version(yuyv(8, 4), 3 * kSecond + 7));
  ASSERT_TRUE(bytes && *bytes);
  ::foxglove::RawImage raw;
  ASSERT_TRUE(raw.ParseFromString(**bytes));
  EXPECT_EQ(raw.timestamp().seconds(), 3);
  EXPECT_EQ(raw.timestamp().nanos(), 7);
  EXPECT_EQ(raw.width(), 8u);
  EXPECT_EQ(raw.height(), 4u);
  EXPECT_EQ(raw.step(), 16u);
  EXPECT_EQ(raw.encoding(), "yuyv");
  EXPECT_EQ(raw.data(), yuyv(8, 4).data());
  EXPECT_EQ(raw.frame_id(), "robot 14/2 camera_top");
}

TEST_F(DerivedChannelsTest, JpegsFollowTheParameters) {
  const Convert convert = converter(1);
  const auto width = [&](std::uint64_t capture_ns) {
    const auto bytes = convert(*version(yuyv(640, 480), capture_ns));
    ::foxglove::CompressedImage image;
    EXPECT_TRUE(bytes && *bytes && image.ParseFromString(**bytes));
    EXPECT_EQ(image.format(), "jpeg");
    const auto pixels = image::decode_jpeg(image.data());
    return pixels ? pixels->width : -1;
  };
  EXPECT_EQ(width(1 * kSecond), 640);
  EXPECT_TRUE(parameters.set("jpeg_width", std::int64_t{320}));
  EXPECT_EQ(width(2 * kSecond), 320);
  EXPECT_FALSE(parameters.set("jpeg_width", std::int64_t{500}));
}

TEST_F(DerivedChannelsTest, JpegsComeAtTheirRate) {
  EXPECT_TRUE(parameters.set("jpeg_rate_hz", 10.0));
  const Convert convert = converter(1);
  int made = 0;
  // 30 Hz with some jitter, for 3 s
  for (std::uint64_t i = 0; i < 90; ++i) {
    const auto bytes = convert(*version(yuyv(16, 8), kSecond + i * kSecond / 30 + (i % 3) * kMillisecond));
    made += bytes && *bytes ? 1 : 0;
  }
  EXPECT_EQ(made, 30);
  // a time line that begins anew is no reason to wait
  const auto again = convert(*version(yuyv(16, 8), kSecond / 2));
  EXPECT_TRUE(again && *again);
}

TEST_F(DerivedChannelsTest, ARecordedJpegPassesAsItIs) {
  foresight::Image image;
  image.set_encoding(foresight::Image::ENCODING_JPEG);
  image.set_data("a jpeg");
  const auto bytes = converter(1)(*version(image, kSecond));
  ::foxglove::CompressedImage compressed;
  ASSERT_TRUE(bytes && *bytes && compressed.ParseFromString(**bytes));
  EXPECT_EQ(compressed.data(), "a jpeg");
  EXPECT_FALSE(converter(0)(*version(image, kSecond)));  // it has no pixels
}

TEST_F(DerivedChannelsTest, BytesThatAreNoImageAreAnError) {
  foresight::Image cut = yuyv(8, 4);
  cut.mutable_data()->resize(5);
  EXPECT_FALSE(converter(1)(*version(cut, kSecond)));
  cut.set_width(1'000'000);
  EXPECT_FALSE(converter(1)(*version(cut, kSecond)));
  EXPECT_TRUE(channel.write_bytes("\xff\xff", kSecond));
  EXPECT_FALSE(converter(0)(*channel.newest()));
}

TEST_F(DerivedChannelsTest, LogTextsKeepTheirLevel) {
  foresight::LogText text;
  text.set_level(foresight::LogText::LEVEL_WARNING);
  text.set_text("the disk is nearly full");
  text.set_source("logging");
  const auto derived = derived_channels(info_of<foresight::LogText>("/14/2/log"), parameters);
  const auto bytes = derived.at(0).make_convert()(*version(text, kSecond));
  ::foxglove::Log log;
  ASSERT_TRUE(bytes && *bytes && log.ParseFromString(**bytes));
  EXPECT_EQ(log.level(), ::foxglove::Log::WARNING);
  EXPECT_EQ(log.message(), "the disk is nearly full");
  EXPECT_EQ(log.name(), "logging");
}

}  // namespace
}  // namespace robot::net
