#include "robot/app/truth/calibrate_sensor.h"

#include "robot/app/truth/calibrations.h"
#include "robot/app/truth/opened_sources.h"
#include "robot/core/text.h"

namespace robot::app {
namespace {

constexpr std::uint64_t kLongestWaitNs = 10 * kSecond;
constexpr double kCm = 100;  // [cm/m]

std::string line_of(const char* what, const truth::ExpectedError& error) {
  if (error.grid.empty()) return formatted("%s not on the seen field\n", what);
  return formatted("%s mean %.1f cm, p95 %.1f cm over the seen field\n", what, kCm * error.mean, kCm * error.p95);
}

}  // namespace

Result<truth::Calibration> calibrate_sensor(const TruthOptions& options, const std::filesystem::path& clicks) {
  const auto clicked = truth::read_clicks(clicks);
  if (!clicked) return clicked.failure("--clicks");
  auto calibrations = Calibrations::open(options.calibration, options.rules);
  if (!calibrations) return calibrations.failure("--calibration");
  auto sources = OpenedSources::open(options, options.sources);
  if (!sources) return sources.failure();
  const std::string& address = options.sources.front();
  const auto image = sources->first_image(kLongestWaitNs);
  if (!image) return image.failure("--source");
  auto calibration = calibrate_by(*clicked, *image, {.field = sources->field(), .ball_radius = sources->ball_radius()});
  if (!calibration) return calibration.failure(clicks.string());
  if (options.calibration.empty() || !calibration->refused.empty()) return calibration;
  if (const auto saved = calibrations->save(address, image->intrinsics, *calibration); !saved)
    return saved.failure("--calibration");
  return calibration;
}

std::string to_text(const truth::Calibration& calibration) {
  std::string text = "landmark                         residual\n";
  for (const truth::ClickResidual& one : calibration.residuals)
    text += formatted("%-31s %6.2f px%s\n", one.click.landmark.c_str(), one.pixels,
                      one.outlier ? "   does not count: too far for a careful click" : "");
  const Eigen::Vector3d at = calibration.pose.field_from_sensor.translation();
  text += formatted("sensor       at %.3f, %.3f, %.3f m\n", at.x(), at.y(), at.z());
  text += formatted("depth scale  %.4f ± %.4f\n", calibration.pose.depth_scale, calibration.scale_deviation);
  text += formatted("left out     mean %.1f cm, worst %.1f cm: %s\n", kCm * calibration.left_out.mean,
                    kCm * calibration.left_out.worst, calibration.left_out.landmark.c_str());
  return text + line_of("robots      ", calibration.robots) + line_of("ball        ", calibration.ball);
}

}  // namespace robot::app
