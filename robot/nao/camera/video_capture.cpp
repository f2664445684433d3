#include "robot/nao/camera/video_capture.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include "robot/core/clock.h"
#include "robot/nao/guardian/socket_owner.h"

namespace robot::nao {
namespace {

constexpr std::uint32_t kType = V4L2_BUF_TYPE_VIDEO_CAPTURE;

const std::map<std::string, std::uint32_t>& controls() {
  static const std::map<std::string, std::uint32_t> list = {
      {"auto_exposure", V4L2_CID_EXPOSURE_AUTO},
      {"exposure", V4L2_CID_EXPOSURE_ABSOLUTE},
      {"gain", V4L2_CID_GAIN},
      {"brightness", V4L2_CID_BRIGHTNESS},
      {"contrast", V4L2_CID_CONTRAST},
      {"saturation", V4L2_CID_SATURATION},
      {"hue", V4L2_CID_HUE},
      {"sharpness", V4L2_CID_SHARPNESS},
      {"auto_white_balance", V4L2_CID_AUTO_WHITE_BALANCE},
      {"white_balance", V4L2_CID_WHITE_BALANCE_TEMPERATURE},
      {"auto_focus", V4L2_CID_FOCUS_AUTO},
      {"focus", V4L2_CID_FOCUS_ABSOLUTE},
  };
  return list;
}

v4l2_buffer buffer_of(std::uint32_t index) {
  v4l2_buffer buffer{};
  buffer.type = kType;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

std::uint64_t capture_ns_of(const v4l2_buffer& buffer) {
  if ((buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) != V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC) return monotonic_ns();
  return static_cast<std::uint64_t>(buffer.timestamp.tv_sec) * kSecond +
         static_cast<std::uint64_t>(buffer.timestamp.tv_usec) * 1000;
}

std::string four_letters(std::uint32_t format) {
  std::string text;
  for (int i = 0; i < 4; ++i) text += static_cast<char>(format >> (8 * i) & 0x7f);
  return text;
}

}  // namespace

std::optional<std::uint32_t> control_id(const std::string& name) {
  const auto found = controls().find(name);
  if (found == controls().end()) return std::nullopt;
  return found->second;
}

Error VideoCapture::refused(const std::string& what, int error_number) const {
  const std::string device = settings_.device.string();
  if (error_number == EBUSY) {
    const std::string owner = who_has_open(settings_.device);
    return Error{"camera " + device + " belongs to " + (owner.empty() ? "another program" : owner)};
  }
  return Error{"camera " + device + ": expected " + what + ", got " + std::strerror(error_number)};
}

Result<VideoCapture> VideoCapture::open(VideoDevice& device, const CameraSettings& settings,
                                        std::vector<std::string>& warnings) {
  VideoCapture capture(device, settings);
  if (const int error = device.open(settings.device)) return capture.refused("a video device", error);
  if (Result<void> set = capture.set_format(); !set) return set.failure();
  capture.set_controls(warnings);
  if (Result<void> shared = capture.share_buffers(); !shared) return shared.failure();
  int type = static_cast<int>(kType);
  if (const int error = device.control(VIDIOC_STREAMON, &type)) return capture.refused("it to start", error);
  return capture;
}

VideoCapture::VideoCapture(VideoCapture&& other) noexcept
    : device_(std::exchange(other.device_, nullptr)),
      settings_(std::move(other.settings_)),
      stride_(other.stride_),
      buffers_(std::move(other.buffers_)),
      passed_over_(other.passed_over_) {}

VideoCapture::~VideoCapture() {
  if (!device_) return;
  int type = static_cast<int>(kType);
  static_cast<void>(device_->control(VIDIOC_STREAMOFF, &type));
  for (const Buffer& buffer : buffers_) device_->unmap(buffer.memory, buffer.bytes);
  device_->close();
}

Result<void> VideoCapture::set_format() {
  v4l2_format format{};
  format.type = kType;
  format.fmt.pix.width = settings_.width;
  format.fmt.pix.height = settings_.height;
  format.fmt.pix.pixelformat = settings_.format;
  format.fmt.pix.field = V4L2_FIELD_NONE;
  if (const int error = device_->control(VIDIOC_S_FMT, &format)) return refused("it to take a format", error);
  // the driver answers with the nearest format that it supports
  const v4l2_pix_format& got = format.fmt.pix;
  const bool compressed = settings_.format != V4L2_PIX_FMT_YUYV && settings_.format != V4L2_PIX_FMT_Z16;
  if (got.width != settings_.width || got.height != settings_.height || got.pixelformat != settings_.format ||
      (!compressed && got.bytesperline < 2 * settings_.width))
    return Error{"camera " + settings_.device.string() + ": expected " + four_letters(settings_.format) + " " +
                 std::to_string(settings_.width) + "x" + std::to_string(settings_.height) + ", got " +
                 four_letters(got.pixelformat) + " " + std::to_string(got.width) + "x" + std::to_string(got.height)};
  stride_ = compressed ? 0 : got.bytesperline;

  v4l2_streamparm rate{};
  rate.type = kType;
  rate.parm.capture.timeperframe = {1, settings_.rate};
  // a driver without rates uses its own
  static_cast<void>(device_->control(VIDIOC_S_PARM, &rate));
  return {};
}

void VideoCapture::set_controls(std::vector<std::string>& warnings) {
  for (const auto& entry : settings_.controls) {
    const std::optional<std::uint32_t> id = control_id(entry.first);
    v4l2_control control{.id = id.value_or(0), .value = entry.second};
    if (const int error = id ? device_->control(VIDIOC_S_CTRL, &control) : EINVAL)
      warnings.push_back("camera " + settings_.device.string() + ": " + entry.first + " = " +
                         std::to_string(entry.second) + " was not taken: " + std::strerror(error));
  }
}

Result<void> VideoCapture::share_buffers() {
  v4l2_requestbuffers request{};
  request.count = kBuffers;
  request.type = kType;
  request.memory = V4L2_MEMORY_MMAP;
  if (const int error = device_->control(VIDIOC_REQBUFS, &request)) return refused("buffers", error);
  if (request.count == 0) return refused("buffers", ENOMEM);
  for (std::uint32_t index = 0; index < request.count; ++index) {
    v4l2_buffer buffer = buffer_of(index);
    if (const int error = device_->control(VIDIOC_QUERYBUF, &buffer)) return refused("a buffer", error);
    if (buffer.length < stride_ * settings_.height) return refused("a buffer for a whole image", ENOMEM);
    void* memory = device_->map(buffer.length, buffer.m.offset);
    if (!memory) return refused("a buffer to share", errno);
    buffers_.push_back({memory, buffer.length});
    if (const int error = device_->control(VIDIOC_QBUF, &buffer)) return refused("it to take a buffer", error);
  }
  return {};
}

Result<std::optional<VideoCapture::Frame>> VideoCapture::newest(int patience_ms) {
  if (!device_->wait(patience_ms)) return std::optional<Frame>();
  std::optional<Frame> newest;
  while (true) {
    v4l2_buffer buffer = buffer_of(0);
    const int error = device_->control(VIDIOC_DQBUF, &buffer);
    if (error == EAGAIN) return newest;
    if (error) return Error{"camera " + settings_.device.string() + " is gone: " + std::strerror(error)};
    if (buffer.index >= buffers_.size()) return refused("one of our buffers", EPROTO);
    const Frame frame{.pixels = static_cast<const char*>(buffers_[buffer.index].memory),
                      .stride = stride_,
                      .bytes = buffer.bytesused,
                      .capture_ns = capture_ns_of(buffer),
                      .buffer = buffer.index};
    // the frame is damaged or incomplete
    const bool damaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0 || buffer.bytesused == 0 ||
                         buffer.bytesused < stride_ * settings_.height;
    if (damaged) {
      give_back(frame);
      continue;
    }
    if (newest) {
      give_back(*newest);
      ++passed_over_;
    }
    newest = frame;
  }
}

void VideoCapture::give_back(const Frame& frame) {
  v4l2_buffer buffer = buffer_of(frame.buffer);
  // a device that does not take it back is gone; the next call of newest() returns that error
  static_cast<void>(device_->control(VIDIOC_QBUF, &buffer));
}

void VideoCapture::copy(const Frame& frame, std::string& image) const {
  const std::size_t row_bytes = 2 * settings_.width;
  if (!settings_.turned) {
    for (std::uint32_t row = 0; row < settings_.height; ++row)
      image.append(frame.pixels + row * frame.stride, row_bytes);
    return;
  }
  // from the last pixel to the first: two pixels that share a colour swap their places and keep it
  const std::size_t start = image.size();
  image.resize(start + row_bytes * settings_.height);
  char* to = image.data() + start;
  for (std::uint32_t row = settings_.height; row > 0; --row) {
    const char* from = frame.pixels + (row - 1) * frame.stride;
    for (std::size_t at = row_bytes; at > 0; at -= 4) {
      const char* pair = from + at - 4;
      *to++ = pair[2];
      *to++ = pair[1];
      *to++ = pair[0];
      *to++ = pair[3];
    }
  }
}

}  // namespace robot::nao
