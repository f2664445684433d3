// Both cameras of a Nao: writes each image and its camera matrix into memory.
#pragma once

#include <memory>
#include <string>

#include "robot/body/nao/config.h"
#include "robot/body/nao/nao_body.h"
#include "robot/core/clock.h"
#include "robot/memory/memory.h"
#include "robot/nao/camera/camera_thread.h"

namespace robot::body {

/// Fills the camera matrix from the camera's pose, its image size and its projection.
void fill(const nao::Transform& robot_from_camera, const nao::CameraSettings& settings, const Projection& projection,
          foresight::CameraMatrix& matrix);

/// The two cameras, each with a thread of its own.
class NaoCameras {
 public:
  /// Returns a sentence that names the program that has one of the cameras open, or an empty string.
  static std::string taken_by_others(const NaoConfig& config);

  /// All arguments but `config` outlive this. `body` gives the pose of each camera; without a pose an image has no
  /// matrix.
  NaoCameras(const NaoConfig& config, const NaoBody& body, memory::Memory& memory, const SessionClock& clock);

  /// Starts both threads, once. Returns an Error if the system allows no more threads.
  Result<void> start();

 private:
  std::unique_ptr<nao::CameraThread> top_, bottom_;
};

}  // namespace robot::body
