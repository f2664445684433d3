#include "robot/net/foxglove/derived_channels.h"

#include <utility>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/runtime.pb.h"
#include "proto/foxglove/CompressedImage.pb.h"
#include "proto/foxglove/Log.pb.h"
#include "proto/foxglove/RawImage.pb.h"
#include "robot/image/image_codec.h"
#include "robot/memory/schema.h"
#include "robot/net/foxglove/rate_limit.h"

namespace robot::net {
namespace {

namespace pb = foresight;

void set_time(google::protobuf::Timestamp& timestamp, std::uint64_t ns) {
  timestamp.set_seconds(static_cast<std::int64_t>(ns / kSecond));
  timestamp.set_nanos(static_cast<std::int32_t>(ns % kSecond));
}

Result<pb::Image> parse_image(const memory::Version& source) {
  pb::Image image;
  if (!image.ParseFromArray(source.bytes().data(), static_cast<int>(source.bytes().size())))
    return Error{"expected a foresight.Image, got " + std::to_string(source.size_bytes()) +
                 " bytes that cannot be parsed as one"};
  constexpr std::uint32_t kMaxSide = 4096;
  if (image.width() > kMaxSide || image.height() > kMaxSide)
    return Error{"expected an image of at most 4096 x 4096 px, got " + std::to_string(image.width()) + " x " +
                 std::to_string(image.height())};
  return image;
}

using Bytes = Result<std::optional<std::string>>;

Bytes to_raw(const memory::Version& source, const std::string& frame_id) {
  auto image = parse_image(source);
  if (!image) return image.failure();
  std::uint32_t width = image->width(), height = image->height();
  std::string pixels = std::move(*image->mutable_data());
  if (image->encoding() == pb::Image::ENCODING_JPEG) {
    auto decoded = image::decode_jpeg(pixels);
    if (!decoded) return decoded.failure();
    width = static_cast<std::uint32_t>(decoded->width);
    height = static_cast<std::uint32_t>(decoded->height);
    pixels = std::move(decoded->yuyv);
  }
  ::foxglove::RawImage raw;
  set_time(*raw.mutable_timestamp(), source.capture_ns());
  raw.set_width(width);
  raw.set_height(height);
  raw.set_encoding("yuyv");
  raw.set_step(2 * width);
  raw.set_data(std::move(pixels));
  raw.set_frame_id(frame_id);
  return std::optional(raw.SerializeAsString());
}

Bytes to_jpeg(const memory::Version& source, const std::string& frame_id, const Parameters& parameters) {
  auto image = parse_image(source);
  if (!image) return image.failure();
  std::string jpeg = std::move(*image->mutable_data());
  if (image->encoding() != pb::Image::ENCODING_JPEG) {
    const int width = static_cast<int>(image->width());
    // the JPEG has the camera's size or half of it, the one that is nearer to the parameter
    const bool half = parameters.integer("jpeg_width") * 4 < width * 3;
    auto encoded = image::encode_jpeg(
        jpeg, width, static_cast<int>(image->height()),
        {.width = half ? width / 2 : 0, .quality = static_cast<int>(parameters.integer("jpeg_quality"))});
    if (!encoded) return encoded.failure();
    jpeg = std::move(*encoded);
  }
  ::foxglove::CompressedImage compressed;
  set_time(*compressed.mutable_timestamp(), source.capture_ns());
  compressed.set_data(std::move(jpeg));
  compressed.set_format("jpeg");
  compressed.set_frame_id(frame_id);
  return std::optional(compressed.SerializeAsString());
}

Bytes to_log(const memory::Version& source) {
  pb::LogText text;
  if (!text.ParseFromArray(source.bytes().data(), static_cast<int>(source.bytes().size())))
    return Error{"expected a foresight.LogText, got " + std::to_string(source.size_bytes()) +
                 " bytes that cannot be parsed as one"};
  ::foxglove::Log log;
  set_time(*log.mutable_timestamp(), source.capture_ns());
  // the levels have the same numbers
  log.set_level(::foxglove::Log::Level_IsValid(text.level()) ? static_cast<::foxglove::Log::Level>(text.level())
                                                             : ::foxglove::Log::UNKNOWN);
  log.set_message(text.text());
  log.set_name(text.source());
  log.set_file(text.file());
  log.set_line(text.line());
  return std::optional(log.SerializeAsString());
}

template <class Message>
memory::ChannelInfo derived_info(const memory::ChannelInfo& source, const char* suffix) {
  return {
      .topic = source.topic + suffix, .schema = memory::schema_of(*Message::descriptor()), .delivery = source.delivery};
}

std::vector<Derived> of_image(const memory::ChannelInfo& source, const Parameters& parameters) {
  const std::string frame_id = camera_frame(source.topic);
  Derived raw{.info = derived_info<::foxglove::RawImage>(source, "/raw"), .make_convert = [frame_id]() -> Convert {
                return [frame_id](const memory::Version& version) { return to_raw(version, frame_id); };
              }};
  Derived jpeg{.info = derived_info<::foxglove::CompressedImage>(source, "/jpeg"),
               .make_convert = [frame_id, &parameters]() -> Convert {
                 return [frame_id, &parameters, limit = RateLimit()](const memory::Version& version) mutable -> Bytes {
                   if (!limit.passes(version.capture_ns(), parameters.number("jpeg_rate_hz")))
                     return std::optional<std::string>();
                   return to_jpeg(version, frame_id, parameters);
                 };
               }};
  return {std::move(raw), std::move(jpeg)};
}

}  // namespace

std::string robot_frame(std::string_view robot) { return "robot " + std::string(robot); }

std::string camera_frame(std::string_view topic) {
  const memory::ObjectName name = memory::object_name(topic);
  const std::string object(name.object);
  return name.robot.empty() ? object : robot_frame(name.robot) + " " + object;
}

void declare_image_parameters(Parameters& parameters) {
  parameters.declare("jpeg_quality", std::int64_t{75}, {.min = 1, .max = 100});
  parameters.declare("jpeg_rate_hz", 15.0, {.min = 0.1, .max = 30});
  parameters.declare("jpeg_width", std::int64_t{640}, {.apply = [](const ParameterValue& value) -> Result<void> {
                       const auto width = std::get<std::int64_t>(value);
                       if (width == 640 || width == 320) return {};
                       return Error{"parameter 'jpeg_width': expected 640 or 320, got " + std::to_string(width)};
                     }});
}

std::vector<Derived> derived_channels(const memory::ChannelInfo& source, const Parameters& parameters) {
  if (source.message_encoding != "protobuf") return {};
  if (source.schema.name == pb::Image::descriptor()->full_name()) return of_image(source, parameters);
  if (source.schema.name != pb::LogText::descriptor()->full_name()) return {};
  std::vector<Derived> derived;
  derived.push_back(
      {.info = derived_info<::foxglove::Log>(source, "/foxglove"), .make_convert = []() -> Convert { return to_log; }});
  return derived;
}

}  // namespace robot::net
