#include "robot/logging/sessions/profile.h"

#include <array>
#include <utility>

#include "proto/foresight/camera.pb.h"
#include "robot/core/clock.h"

namespace robot::logging {
namespace {

constexpr std::array kProfiles{
    Profile{.name = "game",
            .purpose = "a whole half: all objects, both cameras as 320x240 JPEG at 5 Hz",
            .raw_images = false,
            .jpeg = {.width = 320, .quality = 60},
            .images_per_second = 5,
            .mb_per_minute = 10},
    Profile{.name = "vision",
            .purpose = "for work on vision: all objects, both cameras as full-size JPEG at 30 Hz",
            .raw_images = false,
            .jpeg = {.width = 0, .quality = 75},
            .images_per_second = 30,
            .mb_per_minute = 170},
    Profile{.name = "full",
            .purpose = "everything as it is: all objects, raw images of both cameras",
            .raw_images = true,
            .jpeg = {},
            .images_per_second = 30,
            .mb_per_minute = 2220},
};

/// A stream that passes on images at a limited rate, as JPEG.
class ThinnedImages final : public OutProvider {
 public:
  ThinnedImages(const Profile& profile, std::unique_ptr<OutProvider> stream)
      : profile_(profile), stream_(std::move(stream)) {}

  Result<void> open(const memory::ChannelInfo& info) override { return stream_->open(info); }

  bool wants(const memory::Version& version) override { return due(version.capture_ns()); }

  Result<void> write(const memory::VersionPtr& version) override {
    if (!image_.ParseFromArray(version->bytes().data(), static_cast<int>(version->bytes().size())))
      return Error{"camera image: expected a foresight.Image, got " + std::to_string(version->size_bytes()) +
                   " bytes of something else"};
    if (image_.encoding() == foresight::Image::ENCODING_YUYV)
      if (Result<void> encoded = encode(); !encoded) return encoded;
    return stream_->write(memory::with_bytes(*version, ++sequence_, image_.SerializeAsString()));
  }

  Patience patience() const override { return stream_->patience(); }
  std::uint64_t flush_due_ns() const override { return stream_->flush_due_ns(); }
  Result<void> flush() override { return stream_->flush(); }
  Result<void> close() override { return stream_->close(); }
  std::uint64_t buffered() const override { return stream_->buffered(); }
  std::uint64_t lost_afterwards() const override { return stream_->lost_afterwards(); }
  void cancel() override { stream_->cancel(); }

 private:
  /// Returns whether an image is due, for `images_per_second` on average. It does not drift against a camera whose
  /// frames are a little early or late. After a delay of the camera, the images it missed may follow faster.
  bool due(std::uint64_t capture_ns) {
    const auto period_ns = static_cast<std::uint64_t>(1e9f / profile_.images_per_second);
    const bool went_back = capture_ns + period_ns < next_ns_;
    if (capture_ns + period_ns / 8 < next_ns_ && !went_back) return false;
    const bool begins = next_ns_ == 0 || went_back;
    next_ns_ = begins ? capture_ns + period_ns : std::max(next_ns_, capture_ns - 2 * period_ns) + period_ns;
    return true;
  }

  Result<void> encode() {
    const int width = static_cast<int>(image_.width()), height = static_cast<int>(image_.height());
    image::JpegOptions options = profile_.jpeg;
    // if the camera's images are small already, keep their size
    if (options.width >= width) options.width = 0;
    Result<std::string> jpeg = image::encode_jpeg(image_.data(), width, height, options);
    if (!jpeg) return jpeg.failure();
    const bool half = options.width != 0;
    image_.set_encoding(foresight::Image::ENCODING_JPEG);
    image_.set_width(static_cast<std::uint32_t>(half ? width / 2 : width));
    image_.set_height(static_cast<std::uint32_t>(half ? height / 2 : height));
    image_.set_data(std::move(*jpeg));
    return {};
  }

  const Profile profile_;
  const std::unique_ptr<OutProvider> stream_;
  std::uint64_t next_ns_ = 0;  // used only by wants(), in the writer's thread; the logger's thread uses the rest
  foresight::Image image_;
  std::uint64_t sequence_ = 0;
};

}  // namespace

std::span<const Profile> profiles() { return kProfiles; }

Result<Profile> profile_named(std::string_view name) {
  std::string names;
  for (const Profile& profile : kProfiles) {
    if (profile.name == name) return profile;
    names += (names.empty() ? "" : ", ") + std::string(profile.name);
  }
  return Error{"recording profile: expected one of " + names + ", got '" + std::string(name) + "'"};
}

std::unique_ptr<OutProvider> thin_images(const Profile& profile, std::unique_ptr<OutProvider> stream) {
  return std::make_unique<ThinnedImages>(profile, std::move(stream));
}

}  // namespace robot::logging
