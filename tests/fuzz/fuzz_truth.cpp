// Any bytes as a file or message of ground truth. The first byte chooses the reader.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "robot/app/truth/sensor_messages.h"
#include "robot/truth/calibration/calibration_file.h"
#include "robot/truth/calibration/calibration_json.h"
#include "robot/truth/tags/tag_plan.h"
#include "robot/truth/tracks/tracker.h"
#include "sim/field/field.h"

namespace {

using namespace robot;

/// Reads calibrations. A file that was read must be printed and read back.
void read_calibrations(std::string_view bytes) {
  const auto file = truth::parse_calibrations(bytes);
  if (file && !truth::parse_calibrations(truth::print_calibrations(*file))) __builtin_trap();
}

/// Reads clicks and calibrates by them. A good calibration is a pose that can be saved.
void calibrate(std::string_view bytes) {
  static const auto landmarks = truth::landmarks_of(sim::field::Field{});
  const auto clicks = truth::parse_clicks(bytes);
  if (!clicks) return;
  const auto found = truth::calibrate(landmarks, *clicks, truth::Projection{}, {});
  if (!found || !found->refused.empty()) return;
  truth::CalibrationFile file;
  if (!truth::put_calibration(file, "freenect:0", "spl2012", {}, *found)) __builtin_trap();
  if (!truth::parse_calibrations(truth::print_calibrations(file))) __builtin_trap();
}

/// Reads a recorded message of a sensor, as smoothing does, and tracks what it saw.
void read_sensor(std::string_view bytes) {
  foresight::TruthSensor message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return;
  const auto pose = app::pose_of(message);
  if (!pose) return;
  truth::Tracker tracker({{.pose = *pose}});
  for (const std::uint64_t ns : {1'000'000'000u, 1'033'000'000u})
    tracker.add({.sensor = 0, .detections = app::detections_of(message, ns)}).operator bool();
  static_cast<void>(tracker.truth());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 4) {
    case 0: read_calibrations(bytes); break;
    case 1: calibrate(bytes); break;
    case 2: truth::tags::parse_tag_plan(bytes).operator bool(); break;
    default: read_sensor(bytes);
  }
  return 0;
}
