#include "robot/truth/tags/picture_camera.h"

#include <linux/videodev2.h>

#include <chrono>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "robot/truth/tags/picture_codec.h"

namespace robot::truth::tags {
namespace {

constexpr int kPatience_ms = 1000;

}  // namespace

PictureCamera::PictureCamera(std::filesystem::path path, PictureSize size, std::unique_ptr<nao::VideoDevice> device,
                             const SessionClock& clock, std::uint64_t try_again_ns)
    : address_("camera:" + path.string()),
      settings_{.device = std::move(path),
                .width = static_cast<std::uint32_t>(size.width),
                .height = static_cast<std::uint32_t>(size.height)},
      device_(std::move(device)),
      clock_(clock),
      try_again_ns_(try_again_ns) {}

Result<std::optional<Picture>> PictureCamera::next() {
  if (!capture_) {
    wait_for_next_try();
    if (Result<void> opened = open(); !opened) return close(opened.error());
  }
  const auto frame = capture_->newest(kPatience_ms);
  if (!frame) return close(frame.error());
  if (!*frame) return close("camera " + settings_.device.string() + " sends no pictures");
  Result<Picture> picture = picture_of(**frame);
  capture_->give_back(**frame);
  if (!picture) return picture.failure(address_);
  return std::optional<Picture>(*std::move(picture));
}

Result<void> PictureCamera::open() {
  std::vector<std::string> warnings;
  std::string problem;
  for (const std::uint32_t format : {V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV}) {
    settings_.format = format;
    Result<nao::VideoCapture> capture = nao::VideoCapture::open(*device_, settings_, warnings);
    if (capture) {
      capture_.emplace(*std::move(capture));
      return {};
    }
    problem = capture.error();
  }
  return Error{problem};
}

void PictureCamera::wait_for_next_try() const {
  const std::uint64_t now_ns = monotonic_ns();
  if (now_ns < next_try_ns_) std::this_thread::sleep_for(std::chrono::nanoseconds(next_try_ns_ - now_ns));
}

/// Closes the camera and returns the problem.
Result<std::optional<Picture>> PictureCamera::close(std::string problem) {
  capture_.reset();
  next_try_ns_ = monotonic_ns() + try_again_ns_;
  return Error{std::move(problem)};
}

Result<Picture> PictureCamera::picture_of(const nao::VideoCapture::Frame& frame) const {
  const PictureSize size{static_cast<int>(settings_.width), static_cast<int>(settings_.height)};
  std::string yuyv;
  if (settings_.format == V4L2_PIX_FMT_YUYV) capture_->copy(frame, yuyv);
  Result<Picture> picture = settings_.format == V4L2_PIX_FMT_YUYV
                                ? picture_of_yuyv(yuyv, size)
                                : decode_jpeg_picture({frame.pixels, frame.bytes}, Damage::accepted);
  if (picture) picture->capture_ns = frame.capture_ns + clock_.epoch_offset_ns();
  return picture;
}

}  // namespace robot::truth::tags
