// A thread that writes the images of one camera into memory.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "proto/foresight/camera.pb.h"
#include "robot/core/clock.h"
#include "robot/memory/memory_object.h"
#include "robot/nao/camera/video_capture.h"

namespace robot::nao {

/// A camera with a thread of its own. If the camera is missing, taken by another program or lost, the thread tries
/// again once a second. It reports a problem when the problem changes.
class CameraThread {
 public:
  static constexpr std::uint64_t kSilence_ns = 2'000'000'000;  // after this time without frames a device counts as gone

  /// Callback after each image with its capture time [ns since the epoch], on this thread.
  using OnImage = std::function<void(std::uint64_t capture_ns)>;

  /// `image` and `clock` outlive this.
  CameraThread(std::string name, CameraSettings settings, std::unique_ptr<VideoDevice> device,
               memory::MemoryObject<foresight::Image>& image, const SessionClock& clock, OnImage on_image,
               std::uint64_t try_again_ns = kSecond);
  ~CameraThread();
  CameraThread(const CameraThread&) = delete;
  CameraThread& operator=(const CameraThread&) = delete;

  /// Starts the thread, once. Returns an Error if the system allows no more threads.
  Result<void> start();

 private:
  void run();
  bool rest();
  std::string stream(VideoCapture& capture);
  void write(const VideoCapture& capture, const VideoCapture::Frame& frame);
  void say(const std::string& problem);

  const std::string name_;
  const CameraSettings settings_;
  const std::unique_ptr<VideoDevice> device_;
  memory::MemoryObject<foresight::Image>& image_;
  const SessionClock& clock_;
  const OnImage on_image_;
  const std::uint64_t try_again_ns_;
  std::string said_;
  std::atomic<bool> ends_ = false;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace robot::nao
