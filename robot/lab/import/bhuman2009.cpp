#include "robot/lab/import/bhuman2009.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "robot/core/clock.h"
#include "robot/lab/import/bhuman2009_messages.h"

namespace robot::lab {
namespace {

using namespace bhuman2009;

struct Message {
  std::uint8_t id;
  std::string_view payload;
};

/// An iterator over the messages. It stops at the end or at the first message that is damaged.
class Messages {
 public:
  explicit Messages(std::string_view file) : file_(file) {}

  std::optional<Message> next() {
    if (offset_ == file_.size()) return std::nullopt;
    const std::string where = "message " + std::to_string(count_) + " at byte " + std::to_string(offset_) + ": ";
    if (file_.size() - offset_ < 4) return stop(where + "the file ends within its head");
    const std::uint32_t head = at<std::uint32_t>(file_, offset_);
    const Message message{static_cast<std::uint8_t>(head), file_.substr(offset_ + 4, head >> 8)};
    if (message.payload.size() < head >> 8)
      return stop(where + "expected " + std::to_string(head >> 8) + " bytes, the file has " +
                  std::to_string(message.payload.size()) + " more");
    const std::size_t expected = expected_size(message.id);
    if (expected != 0 && message.payload.size() != expected)
      return stop(where + "kind " + std::to_string(message.id) + " has " + std::to_string(expected) + " bytes, got " +
                  std::to_string(message.payload.size()));
    offset_ += 4 + message.payload.size();
    ++count_;
    return message;
  }

  std::uint64_t count() const { return count_; }
  const std::string& damage() const { return damage_; }

 private:
  std::optional<Message> stop(std::string damage) {
    damage_ = std::move(damage);
    return std::nullopt;
  }

  std::string_view file_;
  std::size_t offset_ = 8;
  std::uint64_t count_ = 0;
  std::string damage_;
};

/// Returns the median of each of the gyroscope's two axes over the whole recording.
std::array<float, 2> gyroscope_zero(std::string_view file) {
  std::array<std::vector<float>, 2> values;
  Messages messages(file);
  while (const auto message = messages.next())
    for (std::size_t axis = 0; message->id == kSensorData && axis < 2; ++axis)
      if (const float value = at<float>(message->payload, 4 * axis); std::isfinite(value))
        values[axis].push_back(value);

  std::array<float, 2> zero{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (values[axis].empty()) continue;
    const auto middle = values[axis].begin() + static_cast<std::ptrdiff_t>(values[axis].size() / 2);
    std::nth_element(values[axis].begin(), middle, values[axis].end());
    zero[axis] = *middle;
  }
  return zero;
}

/// The messages between process begin and finished. They have one common time.
struct Frame {
  std::optional<std::uint32_t> time_ms;  // of the robot's clock; also the time of messages without one
  std::optional<pb::Image> image;
  std::optional<pb::CameraMatrix> matrix;
  std::optional<std::string_view> coordinates;
  std::optional<pb::Joints> joints;
  std::optional<pb::Inertial> inertial;
  std::optional<pb::Fsr> fsr;
  std::optional<pb::Sonar> sonar;
  std::optional<pb::Battery> battery;
  std::optional<pb::Touch> touch;
  std::optional<pb::Odometry> odometry;
};

class Importer {
 public:
  Importer(std::string_view file, std::uint64_t epoch_ns, ImportSink& sink)
      : messages_(file), gyroscope_zero_(gyroscope_zero(file)), epoch_ns_(epoch_ns), sink_(sink, report_) {}

  Result<ImportReport> run(std::uint32_t promised_bytes, std::uint32_t promised_messages, std::size_t bytes) {
    while (const auto message = messages_.next()) {
      if (message->id != kProcessFinished) {
        read(*message);
      } else if (Result<void> sent = send(); !sent) {
        return sent.failure();
      }
    }
    // the rest of a frame that the damage cut off
    if (Result<void> sent = send(); !sent) return sent.failure();

    if (!messages_.damage().empty()) report_.damage = messages_.damage();
    if (report_.damage.empty() && (promised_bytes != bytes || promised_messages != messages_.count()))
      report_.damage = "the file's head names " + std::to_string(promised_messages) + " messages in " +
                       std::to_string(promised_bytes) + " bytes, found " + std::to_string(messages_.count()) + " in " +
                       std::to_string(bytes);
    warn(unknown_, " messages of unknown kinds are left out");
    warn(impossible_, " inertial readings have a torso angle beyond half a turn; left out");
    warn(doubtful_, " camera matrices are marked as invalid by the robot (not both feet on the ground); kept");
    return std::move(report_);
  }

 private:
  void read(const Message& message) {
    const std::string_view payload = message.payload;
    switch (message.id) {
      case kProcessBegin: break;
      case kImage: read_image(payload); break;
      case kJointData: read_joints(payload); break;
      case kSensorData: read_sensors(payload); break;
      case kKeyStates: frame_.touch = touch_of(payload); break;
      case kOdometry: check(frame_.odometry = odometry_of(payload), "odometry"); break;
      case kCameraMatrix:
        check(frame_.matrix = matrix_of(payload), "camera matrix");
        doubtful_ += at<std::uint32_t>(payload, 96) == 0;
        break;
      case kImageCoordinates: frame_.coordinates = payload; break;
      default: ++unknown_;
    }
  }

  void read_image(std::string_view payload) {
    Result<TimedImage> timed = image_of(payload);
    if (!timed) return damaged("image", timed.error());
    frame_.time_ms = timed->time_ms;
    frame_.image = std::move(timed->image);
  }

  void read_joints(std::string_view payload) {
    frame_.time_ms = at<std::uint32_t>(payload, 176);
    if (!frame_.joints) frame_.joints.emplace();
    if (!read_positions(payload, *frame_.joints)) damaged("joint data", "an angle is not a number");
  }

  void read_sensors(std::string_view payload) {
    frame_.time_ms = at<std::uint32_t>(payload, 142);
    const std::optional<Sensors> sensors = sensors_of(payload);
    if (!sensors) return damaged("sensor data", "a value is not a number");
    if (!frame_.joints) frame_.joints.emplace();
    read_motors(payload, *frame_.joints);
    frame_.inertial = inertial_of(*sensors, gyroscope_zero_);
    impossible_ += !frame_.inertial;
    frame_.fsr = fsr_of(*sensors);
    frame_.sonar = sonar_of(*sensors, payload);
    frame_.battery.emplace().set_charge((*sensors)[6]);
  }

  template <class T>
  void check(const std::optional<T>& value, std::string_view what) {
    if (!value) damaged(what, "a value is not a number");
  }

  /// Notes one bad message. The structure of the file is intact, so reading continues.
  void damaged(std::string_view what, const std::string& why) {
    if (report_.damage.empty())
      report_.damage = "message " + std::to_string(messages_.count() - 1) + " (" + std::string(what) + "): " + why;
  }

  Result<void> send() {
    if (frame_.matrix) set_projection(frame_.coordinates, *frame_.matrix);
    Result<void> sent;
    const auto send_one = [&](std::string_view object, const auto& value) {
      if (sent && value && frame_.time_ms)
        sent = sink_.message(object, epoch_ns_ + *frame_.time_ms * kMillisecond, *value);
    };
    send_one("camera_bottom", frame_.image);
    send_one("camera_bottom_matrix", frame_.matrix);
    send_one("joints", frame_.joints);
    send_one("inertial", frame_.inertial);
    send_one("fsr", frame_.fsr);
    send_one("sonar", frame_.sonar);
    send_one("battery", frame_.battery);
    send_one("touch", frame_.touch);
    send_one("odometry", frame_.odometry);
    frame_ = {};
    return sent;
  }

  void warn(std::uint64_t count, const char* what) {
    if (count > 0) report_.warnings.push_back(std::to_string(count) + what);
  }

  Messages messages_;
  std::array<float, 2> gyroscope_zero_;
  std::uint64_t epoch_ns_;
  ImportReport report_;
  CountingSink sink_;
  Frame frame_;
  std::uint64_t unknown_ = 0, doubtful_ = 0, impossible_ = 0;
};

}  // namespace

Result<ImportReport> import_bhuman2009(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink) {
  if (file_bytes.size() < 8)
    return Error{"B-Human log of 2009: expected a head of 8 bytes, the file has " + std::to_string(file_bytes.size())};
  return Importer(file_bytes, epoch_ns, sink)
      .run(at<std::uint32_t>(file_bytes, 0), at<std::uint32_t>(file_bytes, 4), file_bytes.size() - 8);
}

}  // namespace robot::lab
