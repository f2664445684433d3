// A colour camera of the kernel as a source of pictures.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "robot/nao/camera/video_capture.h"
#include "robot/nao/camera/video_device.h"
#include "robot/truth/tags/picture_source.h"

namespace robot::truth::tags {

/// A camera that streams MJPEG, or YUYV if it has no MJPEG: USB 2 carries 1280x720 pictures uncompressed at 10 a second only.
/// If the camera is missing, taken by another program or lost, next() opens it again once a second.
class PictureCamera final : public PictureSource {
 public:
  /// `clock` outlives this.
  PictureCamera(std::filesystem::path path, PictureSize size, std::unique_ptr<nao::VideoDevice> device,
                const SessionClock& clock, std::uint64_t try_again_ns = kSecond);

  Result<std::optional<Picture>> next() override;
  const std::string& address() const override { return address_; }
  bool live() const override { return true; }

 private:
  Result<void> open();
  void wait_for_next_try() const;
  Result<std::optional<Picture>> close(std::string problem);
  Result<Picture> picture_of(const nao::VideoCapture::Frame& frame) const;

  std::string address_;
  nao::CameraSettings settings_;
  std::unique_ptr<nao::VideoDevice> device_;
  const SessionClock& clock_;
  std::uint64_t try_again_ns_;
  std::uint64_t next_try_ns_ = 0;             // [ns, monotonic]
  std::optional<nao::VideoCapture> capture_;  // last: it uses the device
};

}  // namespace robot::truth::tags
