// A stand-in for a Video4Linux camera: it delivers on command and can be unplugged.
#pragma once

#include <linux/videodev2.h>

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "robot/nao/camera/video_device.h"

namespace tests {

/// The camera at the other end of the cable. Any thread.
class FakeCamera {
 public:
  explicit FakeCamera(std::uint32_t columns = 640, std::uint32_t rows = 480, std::uint32_t padding = 0)
      : width(columns), height(rows), stride(2 * columns + padding) {}

  /// Puts a picture with this time into the next free buffer. Without a free buffer the oldest waiting picture is dropped.
  void deliver(const std::string& rows, std::uint64_t capture_ns, std::uint32_t flags = 0);
  void plug(bool in);

  const std::uint32_t width, height, stride;
  std::uint32_t format = V4L2_PIX_FMT_YUYV;  // supported format
  int busy = 0;                              // error number of setting the format: EBUSY while another program uses it
  std::vector<std::pair<std::uint32_t, std::int32_t>> controls;  // controls that were set
  std::vector<std::uint32_t> known_controls;

  /// Frames dropped without a free buffer, and number of times it was opened.
  std::uint64_t lost = 0;
  int opened = 0;

 private:
  friend class FakeVideo;
  struct Waiting {
    std::uint32_t buffer;
    std::uint64_t capture_ns;
    std::uint32_t flags;
  };

  std::mutex lock_;
  std::condition_variable changed_;
  bool plugged_ = true, streams_ = false;
  std::array<std::vector<char>, 3> buffers_;
  std::deque<std::uint32_t> free_;
  std::deque<Waiting> waiting_;
};

class FakeVideo final : public robot::nao::VideoDevice {
 public:
  explicit FakeVideo(FakeCamera& camera) : camera_(camera) {}
  ~FakeVideo() override { close(); }

  int open(const std::filesystem::path& path) override;
  void close() override;
  int control(unsigned long request, void* argument) override;
  void* map(std::size_t bytes, std::int64_t offset) override;
  void unmap(void*, std::size_t) override {}
  bool wait(int patience_ms) override;

 private:
  FakeCamera& camera_;
};

}  // namespace tests
