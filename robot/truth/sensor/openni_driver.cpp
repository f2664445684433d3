#include "robot/truth/sensor/openni_driver.h"

#include <OniCAPI.h>
#include <OniCProperties.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/text.h"
#include "robot/truth/sensor/device_clock.h"
#include "robot/truth/sensor/image.h"
#include "robot/truth/sensor/kinect.h"

namespace robot::truth {
namespace {

constexpr double kOpenniTicksPerSecond = 1e6;
constexpr int kOpenniTickBits = 64;
constexpr std::uint64_t kSameMoment_us = 34'000;  // one image of 30 a second

/// Starts OpenNI once for this process. It stays: its end would take all sensors from all threads.
bool start_openni() {
  static const bool started = oniInitialize(ONI_API_VERSION) == ONI_STATUS_OK;
  return started;
}

/// Returns OpenNI's sentence for its last error.
std::string openni_reason() { return printable(trimmed(oniGetExtendedError()), 200); }

/// Returns OpenNI's address of the sensor with this number.
Result<std::string> openni_address(std::size_t number) {
  OniDeviceInfo* devices = nullptr;
  int count = 0;
  if (oniGetDeviceList(&devices, &count) != ONI_STATUS_OK) return Error{"OpenNI lists no sensors"};
  const std::string address = number < static_cast<std::size_t>(count) ? devices[number].uri : "";
  oniReleaseDeviceList(devices);
  if (!address.empty()) return address;
  return Error{formatted("expected a sensor with the number %zu, found %d (from 0 on)", number, count)};
}

struct CloseOpenni {
  void operator()(_OniDevice* device) const { oniDeviceClose(device); }
  void operator()(_OniStream* stream) const {
    oniStreamStop(stream);
    oniStreamDestroy(stream);
  }
  void operator()(OniFrame* frame) const { oniFrameRelease(frame); }
};

using OpenniDevice = std::unique_ptr<_OniDevice, CloseOpenni>;
using OpenniStream = std::unique_ptr<_OniStream, CloseOpenni>;
using OpenniFrame = std::unique_ptr<OniFrame, CloseOpenni>;

/// Asks for 640x480 px, 30 times a second, not mirrored, in this format. A sensor without this mode keeps its own.
void prefer_mode(const OpenniStream& stream, OniPixelFormat format) {
  const OniVideoMode mode{format, 640, 480, 30};
  const OniBool mirrored = FALSE;
  oniStreamSetProperty(stream.get(), ONI_STREAM_PROPERTY_VIDEO_MODE, &mode, sizeof mode);
  oniStreamSetProperty(stream.get(), ONI_STREAM_PROPERTY_MIRRORING, &mirrored, sizeof mirrored);
}

OpenniStream start_stream(const OpenniDevice& device, OniSensorType sensor, OniPixelFormat format) {
  OniStreamHandle handle = nullptr;
  if (oniDeviceCreateStream(device.get(), sensor, &handle) != ONI_STATUS_OK) return nullptr;
  OpenniStream stream(handle);
  prefer_mode(stream, format);
  if (oniStreamStart(handle) != ONI_STATUS_OK) return nullptr;
  return stream;
}

/// Waits for an image of the stream, at most `patience_ms`. Returns nullptr if none came.
Result<OpenniFrame> read_frame(const OpenniStream& stream, int patience_ms) {
  OniStreamHandle handle = stream.get();
  int ready = 0;
  const OniStatus waited = oniWaitForAnyStream(&handle, 1, &ready, patience_ms);
  if (waited == ONI_STATUS_TIME_OUT) return OpenniFrame();
  OniFrame* frame = nullptr;
  if (waited == ONI_STATUS_OK && oniStreamReadFrame(handle, &frame) == ONI_STATUS_OK) return OpenniFrame(frame);
  return Error{"the sensor is gone: " + openni_reason()};
}

/// Returns the rows of a frame without padding, or an empty text if the frame is smaller than it says.
std::string rows_of(const OniFrame& frame, std::size_t pixel_bytes) {
  const std::size_t row_bytes = static_cast<std::size_t>(frame.width) * pixel_bytes;
  const auto height = static_cast<std::size_t>(frame.height), stride = static_cast<std::size_t>(frame.stride);
  if (stride < row_bytes || static_cast<std::size_t>(frame.dataSize) < stride * height) return {};
  std::string rows;
  for (std::size_t row = 0; row < height; ++row)
    rows.append(static_cast<const char*>(frame.data) + row * stride, row_bytes);
  return rows;
}

class OpenniDriver final : public SensorDriver {
 public:
  explicit OpenniDriver(std::string which) : which_(std::move(which)) {}

  Result<void> open() override;
  void close() override;
  Result<std::optional<DepthFrame>> newest(int patience_ms) override;

 private:
  Result<void> open_device();
  Result<DepthFrame> converted(const OniFrame& got) const;
  Intrinsics intrinsics_of(const OniFrame& frame) const;
  std::vector<std::uint8_t> colours_of(const OniFrame& depth) const;

  std::string which_;
  OpenniDevice device_;
  OpenniStream depth_;
  OpenniStream colour_;  // nullptr: the sensor does not register its depth to colours
  DeviceClock clock_{kOpenniTicksPerSecond, kOpenniTickBits};
  SessionClock epoch_;
};

Result<void> OpenniDriver::open() {
  Result<void> opened = open_device();
  if (!opened) close();
  return opened;
}

Result<void> OpenniDriver::open_device() {
  if (!start_openni()) return Error{"OpenNI does not start: " + openni_reason()};
  // a number, or an address of OpenNI
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(which_.data(), which_.data() + which_.size(), number);
  const bool numbered = error == std::errc() && end == which_.data() + which_.size();
  const Result<std::string> address = numbered ? openni_address(number) : Result<std::string>(which_);
  if (!address) return address.failure();

  OniDeviceHandle device = nullptr;
  if (oniDeviceOpen(address->c_str(), &device) != ONI_STATUS_OK)
    return Error{"the sensor does not open: " + openni_reason()};
  device_.reset(device);
  depth_ = start_stream(device_, ONI_SENSOR_DEPTH, ONI_PIXEL_FORMAT_DEPTH_1_MM);
  if (!depth_) return Error{"the sensor starts no depth images: " + openni_reason()};

  // without registration the colours would belong to other pixels
  const OniImageRegistrationMode registered = ONI_IMAGE_REGISTRATION_DEPTH_TO_COLOR;
  if (oniDeviceSetProperty(device, ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION, &registered, sizeof registered) ==
      ONI_STATUS_OK)
    colour_ = start_stream(device_, ONI_SENSOR_COLOR, ONI_PIXEL_FORMAT_RGB888);
  return {};
}

void OpenniDriver::close() {
  colour_.reset();
  depth_.reset();
  device_.reset();
  clock_ = DeviceClock(kOpenniTicksPerSecond, kOpenniTickBits);
}

Result<std::optional<DepthFrame>> OpenniDriver::newest(int patience_ms) {
  const Result<OpenniFrame> got = read_frame(depth_, patience_ms);
  if (!got) return got.failure();
  if (!*got) return std::optional<DepthFrame>();
  const std::uint64_t arrival_ns = epoch_.now_ns();
  Result<DepthFrame> frame = converted(**got);
  if (!frame) return frame.failure();
  frame->rgb = colours_of(**got);
  frame->capture_ns = clock_.capture_ns((*got)->timestamp, arrival_ns);
  return std::optional(*std::move(frame));
}

/// Returns the depths of a frame, without colours and time.
Result<DepthFrame> OpenniDriver::converted(const OniFrame& got) const {
  const OniPixelFormat format = got.videoMode.pixelFormat;
  if (format != ONI_PIXEL_FORMAT_DEPTH_1_MM && format != ONI_PIXEL_FORMAT_DEPTH_100_UM)
    return Error{formatted("expected depths of 1 mm or 0.1 mm, got OpenNI's pixel format %d", format)};
  const auto width = static_cast<std::uint64_t>(got.width), height = static_cast<std::uint64_t>(got.height);
  if (const Result<void> checked = check_size(width, height); !checked) return checked.failure();
  const std::string rows = rows_of(got, sizeof(std::uint16_t));
  if (rows.empty()) return Error{"expected a whole image, got a part of one"};

  DepthFrame frame;
  frame.intrinsics = intrinsics_of(got);
  frame.unit = format == ONI_PIXEL_FORMAT_DEPTH_1_MM ? 0.001 : 0.0001;
  frame.depth.resize(rows.size() / sizeof(std::uint16_t));
  std::memcpy(frame.depth.data(), rows.data(), rows.size());
  return frame;
}

/// Returns the pinhole by the reported field of view, or the Kinect's if the sensor reports none.
Intrinsics OpenniDriver::intrinsics_of(const OniFrame& frame) const {
  Intrinsics intrinsics = kinect_intrinsics(frame.width, frame.height);
  const auto focal_of = [&](int property, int pixels, double otherwise) {
    float view = 0;  // [rad]
    int bytes = sizeof view;
    const bool known = oniStreamGetProperty(depth_.get(), property, &view, &bytes) == ONI_STATUS_OK;
    return known && view > 0.1f && view < 3 ? pixels / (2 * std::tan(static_cast<double>(view) / 2)) : otherwise;
  };
  intrinsics.focal_x = focal_of(ONI_STREAM_PROPERTY_HORIZONTAL_FOV, frame.width, intrinsics.focal_x);
  intrinsics.focal_y = focal_of(ONI_STREAM_PROPERTY_VERTICAL_FOV, frame.height, intrinsics.focal_y);
  return intrinsics;
}

/// Returns the colours of the same moment, or none.
std::vector<std::uint8_t> OpenniDriver::colours_of(const OniFrame& depth) const {
  if (!colour_) return {};
  const Result<OpenniFrame> got = read_frame(colour_, 0);
  if (!got || !*got) return {};
  const OniFrame& colour = **got;
  if (colour.width != depth.width || colour.height != depth.height) return {};
  if (colour.videoMode.pixelFormat != ONI_PIXEL_FORMAT_RGB888) return {};
  const std::uint64_t first = std::min(colour.timestamp, depth.timestamp);
  if (std::max(colour.timestamp, depth.timestamp) - first > kSameMoment_us) return {};
  const std::string rows = rows_of(colour, 3);
  return {rows.begin(), rows.end()};
}

}  // namespace

std::unique_ptr<SensorDriver> openni_driver(std::string which) {
  return std::make_unique<OpenniDriver>(std::move(which));
}

}  // namespace robot::truth
