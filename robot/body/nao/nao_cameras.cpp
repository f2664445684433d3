#include "robot/body/nao/nao_cameras.h"

#include <utility>

#include "robot/nao/guardian/socket_owner.h"

namespace robot::body {

void fill(const nao::Transform& robot_from_camera, const nao::CameraSettings& settings, const Projection& projection,
          foresight::CameraMatrix& matrix) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      matrix.add_rotation(static_cast<float>(robot_from_camera.linear()(row, column)));
  matrix.set_x(static_cast<float>(robot_from_camera.translation().x()));
  matrix.set_y(static_cast<float>(robot_from_camera.translation().y()));
  matrix.set_z(static_cast<float>(robot_from_camera.translation().z()));
  matrix.set_width(settings.width);
  matrix.set_height(settings.height);
  matrix.set_focal_x(static_cast<float>(projection.focal_x));
  matrix.set_focal_y(static_cast<float>(projection.focal_y));
  matrix.set_centre_x(static_cast<float>(projection.centre_x));
  matrix.set_centre_y(static_cast<float>(projection.centre_y));
}

std::string NaoCameras::taken_by_others(const NaoConfig& config) {
  for (const nao::CameraSettings* camera : {&config.top, &config.bottom})
    if (const std::string owner = nao::who_has_open(camera->device); !owner.empty())
      return "camera " + camera->device.string() + " belongs to " + owner;
  return "";
}

NaoCameras::NaoCameras(const NaoConfig& config, const NaoBody& body, memory::Memory& memory,
                       const SessionClock& clock) {
  const auto open = [&](nao::Camera camera, const nao::CameraSettings& settings, const Projection& projection,
                        memory::MemoryObject<foresight::Image>& image,
                        memory::MemoryObject<foresight::CameraMatrix>& object) {
    return std::make_unique<nao::CameraThread>(
        camera == nao::Camera::top ? "camera top" : "camera bottom", settings,
        std::make_unique<nao::KernelVideoDevice>(), image, clock,
        [&body, &object, camera, settings, projection](std::uint64_t capture_ns) {
          const auto robot_from_camera = body.robot_from_camera(camera, capture_ns);
          if (!robot_from_camera) return;
          auto matrix = object.draft();
          fill(*robot_from_camera, settings, projection, *matrix);
          object.write(std::move(matrix), capture_ns);
        });
  };
  top_ = open(nao::Camera::top, config.top, config.top_projection, memory.camera_top, memory.camera_top_matrix);
  bottom_ = open(nao::Camera::bottom, config.bottom, config.bottom_projection, memory.camera_bottom,
                 memory.camera_bottom_matrix);
}

Result<void> NaoCameras::start() {
  if (Result<void> started = top_->start(); !started) return started;
  return bottom_->start();
}

}  // namespace robot::body
