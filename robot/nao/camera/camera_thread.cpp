#include "robot/nao/camera/camera_thread.h"

#include <chrono>
#include <utility>
#include <vector>

#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::nao {
namespace {

constexpr int kPatience_ms = 100;

}  // namespace

CameraThread::CameraThread(std::string name, CameraSettings settings, std::unique_ptr<VideoDevice> device,
                           memory::MemoryObject<foresight::Image>& image, const SessionClock& clock, OnImage on_image,
                           std::uint64_t try_again_ns)
    : name_(std::move(name)),
      settings_(std::move(settings)),
      device_(std::move(device)),
      image_(image),
      clock_(clock),
      on_image_(std::move(on_image)),
      try_again_ns_(try_again_ns) {}

Result<void> CameraThread::start() {
  return start_thread(thread_, name_, [this] { run(); });
}

CameraThread::~CameraThread() {
  ends_ = true;
  if (thread_.joinable()) thread_.join();
}

void CameraThread::run() {
  name_thread(name_);
  while (!ends_) {
    std::vector<std::string> warnings;
    const Result<void> streamed = attempt("camera " + settings_.device.string(), [&] {
      Result<VideoCapture> capture = VideoCapture::open(*device_, settings_, warnings);
      if (!capture) return say(capture.error());
      for (const std::string& warning : warnings) report(Level::warning, "camera", warning);
      say(stream(*capture));
    });
    if (!streamed) say(streamed.error());
    if (!rest()) return;
  }
}

/// Waits until the next try. Returns false if the thread must end.
bool CameraThread::rest() {
  const std::uint64_t end_ns = monotonic_ns() + try_again_ns_;
  while (!ends_ && monotonic_ns() < end_ns) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return !ends_;
}

/// Streams until an error or the end of the thread. Returns the error's sentence, or "" at the end of the thread.
std::string CameraThread::stream(VideoCapture& capture) {
  std::uint64_t last_ns = monotonic_ns();
  while (!ends_) {
    const auto frame = capture.newest(kPatience_ms);
    if (!frame) return frame.error();
    if (*frame) {
      last_ns = monotonic_ns();
      say("");
      write(capture, **frame);
      capture.give_back(**frame);
    } else if (monotonic_ns() - last_ns > kSilence_ns) {
      return "camera " + settings_.device.string() + " is gone: it sends no frames";
    }
  }
  return "";
}

void CameraThread::write(const VideoCapture& capture, const VideoCapture::Frame& frame) {
  const std::uint64_t capture_ns = frame.capture_ns + clock_.epoch_offset_ns();
  auto image = image_.draft();
  image->set_encoding(foresight::Image::ENCODING_YUYV);
  image->set_width(settings_.width);
  image->set_height(settings_.height);
  capture.copy(frame, *image->mutable_data());
  image_.write(std::move(image), capture_ns);
  on_image_(capture_ns);
}

void CameraThread::say(const std::string& problem) {
  if (problem == said_) return;
  const bool back = problem.empty() && !said_.empty() && !ends_;
  said_ = problem;
  if (back) report(Level::info, "camera", "camera " + settings_.device.string() + " is back");
  if (!problem.empty()) report(Level::warning, "camera", problem);
}

}  // namespace robot::nao
