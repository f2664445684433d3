#include "robot/lab/import/nblog.h"

#include <google/protobuf/io/coded_stream.h>

#include <array>
#include <bit>
#include <cmath>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/sensors.pb.h"
#include "robot/lab/import/nblog_header.h"

namespace robot::lab {
namespace {

namespace pb = foresight;
using nblog::Expression;

constexpr double kAccelerationPerCount = -0.017 * 9.81;  // [m/s²]
constexpr double kMaxSide = 4096;                        // [px]
constexpr double kMaxMicroseconds = 1e15;                // 30 years; exact in float64

/// The field names of the two protobuf messages, from field 1 on, as in the header.
constexpr std::string_view kInertialFields[] = {"acc_x", "acc_y",   "acc_z",   "gyr_x",  "gyr_y",
                                                "gyr_z", "angle_x", "angle_y", "angle_z"};
constexpr std::string_view kJointFields[] = {
    "head_yaw",      "head_pitch",    "l_shoulder_pitch", "l_shoulder_roll", "l_elbow_yaw", "l_elbow_roll",
    "l_wrist_yaw",   "l_hand",        "r_shoulder_pitch", "r_shoulder_roll", "r_elbow_yaw", "r_elbow_roll",
    "r_wrist_yaw",   "r_hand",        "l_hip_yaw_pitch",  "r_hip_yaw_pitch", "l_hip_roll",  "l_hip_pitch",
    "l_knee_pitch",  "l_ankle_pitch", "l_ankle_roll",     "r_hip_roll",      "r_hip_pitch", "r_knee_pitch",
    "r_ankle_pitch", "r_ankle_roll"};

/// The index in kJointFields for each of our 25 joints.
constexpr std::size_t kJointSources[25] = {0,  1,  2,  3,  4,  5, 6, 14, 16, 17, 18, 19, 20,
                                           21, 22, 23, 24, 25, 8, 9, 10, 11, 12, 7,  13};

/// Returns the big-endian number at byte `offset`, which must lie within `bytes`.
std::uint32_t big_endian(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
  return value;
}

/// Reads the float fields 1 .. `count` of a protobuf message whose schema we do not have. Absent fields are 0.
Result<std::vector<float>> float_fields(std::string_view bytes, std::size_t count) {
  std::vector<float> fields(count, 0);
  google::protobuf::io::CodedInputStream stream(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                                static_cast<int>(bytes.size()));
  while (stream.CurrentPosition() < static_cast<int>(bytes.size())) {
    const std::uint32_t tag = stream.ReadTag(), field = tag >> 3, wire_type = tag & 7;
    std::uint32_t bits = 0;
    if (wire_type != 5 || field < 1 || field > count || !stream.ReadLittleEndian32(&bits))
      return Error{"expected float fields 1 to " + std::to_string(count) + ", got field " + std::to_string(field) +
                   " of wire type " + std::to_string(wire_type)};
    fields[field - 1] = std::bit_cast<float>(bits);
    if (!std::isfinite(fields[field - 1])) return Error{"field " + std::to_string(field) + " is not a number"};
  }
  return fields;
}

class NblogImporter {
 public:
  NblogImporter(std::uint64_t epoch_ns, ImportSink& sink) : epoch_ns_(epoch_ns), sink_(sink, report_) {}

  Result<ImportReport> run(const std::vector<Expression>& blocks, std::string_view payload) {
    for (const Expression& block : blocks) {
      const Expression* type = block.find("type");
      const std::string name = type ? type->atom : "of unknown type";
      const auto bytes = block.number("nbytes");
      if (!bytes || *bytes < 0) return damaged("block " + name + ": its header has no number of bytes");
      if (*bytes > static_cast<double>(payload.size()))
        return damaged("block " + name + ": expected " + block.find("nbytes")->atom + " bytes, the payload has " +
                       std::to_string(payload.size()) + " more");
      const auto size = static_cast<std::size_t>(*bytes);
      const Result<void> read = read_block(name, block, payload.substr(0, size));
      if (!read && sink_failed_) return read.failure();
      if (!read) return damaged("block " + name + ": " + read.error());
      payload.remove_prefix(size);
    }
    if (!payload.empty()) return damaged(std::to_string(payload.size()) + " bytes follow the last block");
    return std::move(report_);
  }

  void note_damage(std::string damage) {
    if (report_.damage.empty()) report_.damage = std::move(damage);
  }

 private:
  Result<void> read_block(const std::string& type, const Expression& block, std::string_view bytes) {
    const auto when = block.number("when");
    if (!when || *when < 0 || *when > kMaxMicroseconds) return Error{"its header has no valid time"};
    capture_ns_ = epoch_ns_ + static_cast<std::uint64_t>(*when) * 1000;
    if (type == "YUVImage") return read_image(block, bytes);
    if (type == "InertialState") return read_inertial(block, bytes);
    if (type == "JointAngles") return read_joints(block, bytes);
    report_.warnings.push_back("a block of type " + type + " is left out");
    return {};
  }

  Result<void> read_image(const Expression& block, std::string_view bytes) {
    const double width = block.number("width").value_or(0), height = block.number("height").value_or(0);
    if (width < 2 || height < 1 || width > kMaxSide || height > kMaxSide || std::fmod(width, 2) != 0)
      return Error{"expected an even width and at most 4096 px"};
    if (2 * width * height != static_cast<double>(bytes.size())) return Error{"expected two bytes for each pixel"};
    const Expression* from = block.find("from");
    const bool bottom = from && from->atom == "camera_BOT";
    if (!bottom && (!from || from->atom != "camera_TOP")) return Error{"expected from camera_TOP or camera_BOT"};

    pb::Image image;
    image.set_encoding(pb::Image::ENCODING_YUYV);
    image.set_width(static_cast<std::uint32_t>(width));
    image.set_height(static_cast<std::uint32_t>(height));
    image.set_data(bytes.data(), bytes.size());
    return send(bottom ? "camera_bottom" : "camera_top", image);
  }

  Result<void> read_inertial(const Expression& block, std::string_view bytes) {
    const auto fields = float_fields(bytes, std::size(kInertialFields));
    if (!fields) return fields.failure();
    compare(block, *fields, kInertialFields);
    pb::Inertial inertial;
    inertial.set_accelerometer_x(static_cast<float>(kAccelerationPerCount * (*fields)[0]));
    inertial.set_accelerometer_y(static_cast<float>(kAccelerationPerCount * (*fields)[1]));
    inertial.set_accelerometer_z(static_cast<float>(kAccelerationPerCount * (*fields)[2]));
    inertial.set_torso_roll((*fields)[6]);
    inertial.set_torso_pitch((*fields)[7]);
    return send("inertial", inertial);
  }

  Result<void> read_joints(const Expression& block, std::string_view bytes) {
    const auto fields = float_fields(bytes, std::size(kJointFields));
    if (!fields) return fields.failure();
    compare(block, *fields, kJointFields);
    pb::Joints joints;
    for (const std::size_t source : kJointSources) joints.add_position((*fields)[source]);
    return send("joints", joints);
  }

  /// Adds a warning for each value that differs between header and payload.
  template <std::size_t Count>
  void compare(const Expression& block, const std::vector<float>& fields, const std::string_view (&names)[Count]) {
    for (std::size_t i = 0; i < Count; ++i) {
      const auto written = block.number(names[i]);
      const double tolerance = 1e-5 + 1e-6 * std::abs(static_cast<double>(fields[i]));
      if (written && std::abs(*written - fields[i]) > tolerance)
        report_.warnings.push_back("the header says " + std::string(names[i]) + " " + std::to_string(*written) +
                                   ", the payload " + std::to_string(fields[i]) + "; the payload is taken");
    }
  }

  Result<void> send(std::string_view object, const google::protobuf::Message& value) {
    Result<void> sent = sink_.message(object, capture_ns_, value);
    sink_failed_ = !sent;
    return sent;
  }

  ImportReport damaged(std::string damage) {
    note_damage(std::move(damage));
    return std::move(report_);
  }

  std::uint64_t epoch_ns_, capture_ns_ = 0;
  ImportReport report_;
  CountingSink sink_;
  bool sink_failed_ = false;
};

}  // namespace

Result<ImportReport> import_nblog(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink) {
  if (file_bytes.size() < 4 || file_bytes.size() - 4 < big_endian(file_bytes, 0))
    return Error{"nblog: the file ends within its header"};
  const std::size_t header_size = big_endian(file_bytes, 0);
  std::string_view header = file_bytes.substr(4, header_size);
  if (const std::size_t end = header.find('\0'); end != std::string_view::npos) header = header.substr(0, end);

  const Result<Expression> parsed = nblog::parse_expression(header);
  if (!parsed) return parsed.failure("nblog: header");
  if (parsed->items.empty() || parsed->items[0].atom != "nblog" || parsed->number("version") != 7)
    return Error{"nblog: expected a header that begins with (nblog and says (version 7)"};
  std::vector<Expression> blocks;
  for (const Expression& item : parsed->items)
    if (!item.items.empty() && item.items[0].atom == "contents")
      blocks.assign(item.items.begin() + 1, item.items.end());

  NblogImporter importer(epoch_ns, sink);
  const std::string_view rest = file_bytes.substr(4 + header_size);
  const std::string_view payload = rest.substr(std::min<std::size_t>(4, rest.size()));
  if (rest.size() < 4)
    importer.note_damage("the file ends after the header");
  else if (big_endian(rest, 0) != payload.size())
    importer.note_damage("expected " + std::to_string(big_endian(rest, 0)) + " bytes of payload, got " +
                         std::to_string(payload.size()));
  return importer.run(blocks, payload);
}

}  // namespace robot::lab
