// Both cameras of a Nao into memory, each image with where its camera was.
#pragma once

#include <memory>
#include <string>

#include "robot/body/nao/config.h"
#include "robot/body/nao/nao_body.h"
#include "robot/core/clock.h"
#include "robot/memory/memory.h"
#include "robot/nao/camera/camera_thread.h"

namespace robot::body {

/// Where `robot_from_camera` puts a camera that projects like that, as a message.
void fill(const nao::Transform& robot_from_camera, const nao::CameraSettings& settings, const Projection& projection,
          foresight::CameraMatrix& matrix);

/// Two threads, one for each camera.
class NaoCameras {
 public:
  /// The program that has one of the cameras open, in a sentence; empty if none has.
  static std::string taken_by_others(const NaoConfig& config);

  /// All given ones outlive this. `body` tells where the cameras are; without its word there is an image, but no matrix.
  NaoCameras(const NaoConfig& config, const NaoBody& body, memory::Memory& memory, const SessionClock& clock);

 private:
  std::unique_ptr<nao::CameraThread> top_, bottom_;
};

}  // namespace robot::body
