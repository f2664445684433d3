#include "tests/support/fake_video.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>

namespace tests {
namespace {

constexpr std::uint64_t kSecond_ns = 1'000'000'000;

}  // namespace

void FakeCamera::deliver(const std::string& rows, std::uint64_t capture_ns, std::uint32_t flags) {
  {
    const std::lock_guard guard(lock_);
    if (!plugged_ || !streams_) return;
    if (free_.empty()) {
      ++lost;
      return;
    }
    const std::uint32_t buffer = free_.front();
    free_.pop_front();
    for (std::uint32_t row = 0; row < height; ++row)
      std::memcpy(buffers_[buffer].data() + row * stride, rows.data() + row * 2 * width, 2 * width);
    waiting_.push_back({buffer, capture_ns, flags});
  }
  changed_.notify_all();
}

void FakeCamera::plug(bool in) {
  {
    const std::lock_guard guard(lock_);
    plugged_ = in;
    if (!in) streams_ = false;
  }
  changed_.notify_all();
}

int FakeVideo::open(const std::filesystem::path&) {
  const std::lock_guard guard(camera_.lock_);
  if (!camera_.plugged_) return ENOENT;
  ++camera_.opened;
  return 0;
}

void FakeVideo::close() {
  const std::lock_guard guard(camera_.lock_);
  camera_.streams_ = false;
  camera_.free_.clear();
  camera_.waiting_.clear();
}

void* FakeVideo::map(std::size_t bytes, std::int64_t offset) {
  const std::lock_guard guard(camera_.lock_);
  auto& buffer = camera_.buffers_[static_cast<std::size_t>(offset)];
  buffer.resize(bytes);
  return buffer.data();
}

bool FakeVideo::wait(int patience_ms) {
  std::unique_lock guard(camera_.lock_);
  return camera_.changed_.wait_for(guard, std::chrono::milliseconds(patience_ms),
                                   [&] { return !camera_.waiting_.empty() || !camera_.plugged_; });
}

int FakeVideo::control(unsigned long request, void* argument) {
  const std::lock_guard guard(camera_.lock_);
  if (!camera_.plugged_) return ENODEV;
  if (request == VIDIOC_S_FMT) {
    if (camera_.busy) return camera_.busy;
    auto& format = *static_cast<v4l2_format*>(argument);
    format.fmt.pix.width = camera_.width;
    format.fmt.pix.height = camera_.height;
    format.fmt.pix.pixelformat = camera_.format;
    format.fmt.pix.bytesperline = camera_.stride;
    return 0;
  }
  if (request == VIDIOC_S_CTRL) {
    const auto& control = *static_cast<v4l2_control*>(argument);
    const auto& known = camera_.known_controls;
    if (std::find(known.begin(), known.end(), control.id) == known.end()) return EINVAL;
    camera_.controls.emplace_back(control.id, control.value);
    return 0;
  }
  if (request == VIDIOC_QUERYBUF) {
    auto& buffer = *static_cast<v4l2_buffer*>(argument);
    buffer.length = camera_.stride * camera_.height;
    buffer.m.offset = buffer.index;
    return 0;
  }
  if (request == VIDIOC_QBUF) {
    camera_.free_.push_back(static_cast<v4l2_buffer*>(argument)->index);
    return 0;
  }
  if (request == VIDIOC_DQBUF) {
    if (camera_.waiting_.empty()) return EAGAIN;
    const FakeCamera::Waiting frame = camera_.waiting_.front();
    camera_.waiting_.pop_front();
    auto& buffer = *static_cast<v4l2_buffer*>(argument);
    buffer.index = frame.buffer;
    buffer.bytesused = camera_.stride * camera_.height;
    buffer.flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC | frame.flags;
    buffer.timestamp.tv_sec = static_cast<time_t>(frame.capture_ns / kSecond_ns);
    buffer.timestamp.tv_usec = static_cast<suseconds_t>(frame.capture_ns % kSecond_ns / 1000);
    return 0;
  }
  if (request == VIDIOC_STREAMON || request == VIDIOC_STREAMOFF) camera_.streams_ = request == VIDIOC_STREAMON;
  return 0;  // VIDIOC_S_PARM, VIDIOC_REQBUFS
}

}  // namespace tests
