#include "robot/truth/calibration/check_clicks.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>

#include "robot/core/text.h"
#include "robot/truth/calibration/advice.h"

namespace robot::truth {
namespace {

constexpr double kLeastSpread = 0.15;   // [m] deviation of the landmarks from a line
constexpr std::size_t kMostNamed = 40;  // letters of a wrong name that a sentence repeats

/// Returns the half of the picture with fewer clicks.
const char* emptier_half(const std::vector<Click>& clicks, const Projection& camera) {
  const auto left = std::count_if(clicks.begin(), clicks.end(),
                                  [&](const Click& click) { return click.x < camera.intrinsics.width / 2.; });
  const bool left_is_emptier = 2 * left <= static_cast<std::ptrdiff_t>(clicks.size());
  return half_of(left_is_emptier ? 0 : camera.intrinsics.width, camera);
}

Result<void> check_click(const std::vector<Landmark>& landmarks, const Click& click, const Projection& camera) {
  const std::string name = printable(click.landmark, kMostNamed);
  if (!find_landmark(landmarks, click.landmark))
    return Error{formatted("clicks: the field has no landmark '%s'", name.c_str())};
  const Intrinsics& picture = camera.intrinsics;
  if (!(click.x >= 0 && click.x <= picture.width && click.y >= 0 && click.y <= picture.height))
    return Error{formatted("clicks: '%s' must be in the picture of %d x %d px, got (%g, %g)", name.c_str(),
                           picture.width, picture.height, click.x, click.y)};
  if (!camera.ray({click.x, click.y}))
    return Error{
        formatted("clicks: '%s' is at (%g, %g), where the lens shows nothing", name.c_str(), click.x, click.y)};
  return {};
}

/// Returns the deviation [m] of the clicked landmarks from the line that fits them best.
double spread_of(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const Click& click : clicks) {
    const Eigen::Vector2d place = find_landmark(landmarks, click.landmark)->position.head<2>();
    sum += place;
    squares += place * place.transpose();
  }
  const auto count = static_cast<double>(clicks.size());
  const Eigen::Matrix2d covariance = squares / count - sum * sum.transpose() / (count * count);
  return std::sqrt(std::max(0., Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues()[0]));
}

}  // namespace

Result<void> check_clicks(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks,
                          const Projection& camera, const CalibrationOptions& options) {
  if (!(options.click_deviation > 0) || !(options.depth_scale_deviation >= 0))
    return Error{"calibration: the deviations of clicks and of the depth scale must be positive"};
  std::set<std::string> names;
  for (const Click& click : clicks) {
    if (auto checked = check_click(landmarks, click, camera); !checked) return checked;
    if (!names.insert(click.landmark).second)
      return Error{formatted("clicks: '%s' is clicked twice", click.landmark.c_str())};
  }
  if (clicks.size() < kFewestLandmarks)
    return Error{formatted("expected clicks of at least %zu landmarks, got %zu: click a landmark in the %s",
                           kFewestLandmarks, clicks.size(), emptier_half(clicks, camera))};
  if (const double spread = spread_of(landmarks, clicks); spread < kLeastSpread)
    return Error{
        formatted("all clicked landmarks are within %.2f m of one line: click a landmark away from this line", spread)};
  return {};
}

}  // namespace robot::truth
