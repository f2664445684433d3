#include "robot/app/truth/picture_sensor.h"

#include <utility>

#include "robot/truth/tags/picture_source.h"

namespace robot::app {
namespace {

constexpr truth::tags::PictureSize kCameraSize{.width = 1280, .height = 720};
constexpr double kUsualFocal = 0.9;  // times the width: 58 degrees, a webcam

class PictureSensor final : public truth::DepthSource {
 public:
  explicit PictureSensor(std::unique_ptr<truth::tags::PictureSource> pictures) : pictures_(std::move(pictures)) {}

  Result<std::optional<truth::DepthFrame>> next() override {
    auto picture = pictures_->next();
    if (!picture) return picture.failure();
    if (!*picture) return std::optional<truth::DepthFrame>();
    const auto [width, height] = (*picture)->size;
    const double focal = kUsualFocal * width;
    truth::DepthFrame frame{.intrinsics = {.width = width,
                                           .height = height,
                                           .focal_x = focal,
                                           .focal_y = focal,
                                           .centre_x = 0.5 * width,
                                           .centre_y = 0.5 * height,
                                           .baseline = 0}};
    frame.rgb = std::move((*picture)->rgb);
    frame.capture_ns = (*picture)->capture_ns;
    return std::optional(std::move(frame));
  }
  const std::string& address() const override { return pictures_->address(); }
  bool live() const override { return pictures_->live(); }

 private:
  const std::unique_ptr<truth::tags::PictureSource> pictures_;
};

}  // namespace

Result<std::unique_ptr<truth::DepthSource>> open_picture_sensor(const std::string& address, const SessionClock& clock) {
  auto pictures = truth::tags::open_pictures(address, kCameraSize, clock);
  if (!pictures) return pictures.failure();
  return std::unique_ptr<truth::DepthSource>(std::make_unique<PictureSensor>(std::move(*pictures)));
}

}  // namespace robot::app
