#include "robot/truth/calibration/calibrate.h"

#include <algorithm>
#include <cmath>

#include "robot/truth/calibration/check_clicks.h"
#include "robot/truth/calibration/fit.h"
#include "robot/truth/calibration/refusal.h"
#include "robot/truth/calibration/start.h"

namespace robot::truth {
namespace {

constexpr double kOutlier = 4;           // deviations: a careful click is farther off once in 3000
constexpr double kFreeFocal = 0.2;       // deviation of a free focal length, as a share of it
constexpr double kFreeDistortion = 0.3;  // deviation of a free k1

/// The clicks of one calibration, and all else that its fits have in common.
class Fitting {
 public:
  Fitting(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks, const Projection& camera,
          const std::optional<Ground>& ground, const CalibrationOptions& options)
      : ground_(ground),
        prior_{.camera = camera,
               .depth_scale_deviation = options.depth_scale_deviation,
               .focal_deviation = options.focal_free ? kFreeFocal : 0,
               .k1_deviation = options.k1_free ? kFreeDistortion : 0},
        click_deviation_(options.click_deviation) {
    for (const Click& click : clicks) {
      const Landmark* landmark = find_landmark(landmarks, click.landmark);
      sightings_.push_back({landmark->position, {click.x, click.y}, options.click_deviation});
      hidden_.push_back(landmark->deviation);
    }
    outlier_.assign(clicks.size(), false);
  }

  const std::vector<Sighting>& sightings() const { return sightings_; }
  bool is_outlier(std::size_t i) const { return outlier_[i]; }

  /// Returns the fit to all clicks that agree with each other.
  Result<Fit> fit() {
    const auto start = start_view(sightings_, prior_.camera, ground_);
    if (!start) return start.failure();
    weigh(*start);
    Fit fit = fit_view(*start, sightings_, ground_, prior_, Loss::cauchy);
    // a click that the first choice left out may fit the second time
    constexpr int kChoices = 2;
    for (int choice = 0; choice < kChoices; ++choice) {
      choose(fit.view);
      fit = fit_view(fit.view, chosen_without(sightings_.size()), ground_, prior_, Loss::squares);
    }
    return fit;
  }

  /// Returns the distance [m] on the carpet by which a fit without click `i` misses its landmark.
  double error_without(std::size_t i, const Fit& whole) const {
    const Fit fit = fit_view(whole.view, chosen_without(i), ground_, prior_, Loss::squares);
    const Sighting& sighting = sightings_[i];
    const auto place = fit.view.point_at_height(sighting.pixel, sighting.place.z());
    return place ? (*place - sighting.place).norm() : (fit.view.seen(sighting.place)).norm();
  }

 private:
  /// Gives the clicks of hidden places their greater deviation, which depends on the distance.
  void weigh(const View& view) {
    for (std::size_t i = 0; i < sightings_.size(); ++i) {
      const double depth = std::max(0.1, view.seen(sightings_[i].place).z());
      sightings_[i].deviation = std::hypot(click_deviation_, hidden_[i] * prior_.camera.intrinsics.focal_x / depth);
    }
  }
  void choose(const View& view) {
    for (std::size_t i = 0; i < sightings_.size(); ++i)
      outlier_[i] = !(miss_of(view, sightings_[i]) < kOutlier * sightings_[i].deviation);
  }
  std::vector<Sighting> chosen_without(std::size_t left_out) const {
    std::vector<Sighting> chosen;
    for (std::size_t i = 0; i < sightings_.size(); ++i)
      if (i != left_out && !outlier_[i]) chosen.push_back(sightings_[i]);
    return chosen;
  }

  const std::optional<Ground>& ground_;
  Prior prior_;
  double click_deviation_;  // [px]
  std::vector<Sighting> sightings_;
  std::vector<double> hidden_;  // [m] deviations of the landmarks
  std::vector<bool> outlier_;
};

LeftOutCheck left_out_check(const Fitting& fitting, const Fit& fit, const std::vector<Click>& clicks) {
  LeftOutCheck check;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < clicks.size(); ++i) {
    if (fitting.is_outlier(i)) continue;
    const double error = fitting.error_without(i, fit);
    if (error >= check.worst) check.worst = error, check.landmark = clicks[i].landmark;
    sum += error, ++count;
  }
  if (count > 0) check.mean = sum / count;
  return check;
}

/// Returns the farthest coordinates of the landmarks: the corners of the field.
Eigen::Vector2d reach_of(const std::vector<Landmark>& landmarks) {
  Eigen::Vector2d reach = Eigen::Vector2d::Zero();
  for (const Landmark& landmark : landmarks) reach = reach.cwiseMax(landmark.position.head<2>().cwiseAbs());
  return reach;
}

}  // namespace

Result<Calibration> calibrate(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks,
                              const Projection& camera, const std::optional<Ground>& ground,
                              const CalibrationOptions& options) {
  if (const auto checked = check_clicks(landmarks, clicks, camera, options); !checked) return checked.failure();
  Fitting fitting(landmarks, clicks, camera, ground, options);
  const auto fit = fitting.fit();
  if (!fit) return fit.failure();

  const Eigen::Vector2d reach = reach_of(landmarks);
  const MeasuredBy of_robots = ground ? MeasuredBy::depth : MeasuredBy::bearing;
  Calibration calibration{
      .pose = fit->view.pose(fit->covariance),
      .lens = fit->view.camera.lens,
      .scale_deviation = std::sqrt(fit->covariance(6, 6)),
      .left_out = left_out_check(fitting, *fit, clicks),
      .robots = expected_error(fit->view, fit->covariance, reach, of_robots, options.robot_height),
      .ball = expected_error(fit->view, fit->covariance, reach, MeasuredBy::bearing, options.ball_radius)};
  for (std::size_t i = 0; i < clicks.size(); ++i)
    calibration.residuals.push_back({clicks[i], miss_of(fit->view, fitting.sightings()[i]), fitting.is_outlier(i)});
  calibration.refused = refusal_of(calibration, *fit, landmarks, fitting.sightings(), options);
  return calibration;
}

Result<Calibration> calibrate(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks,
                              const DepthFrame& frame, const CalibrationOptions& options, const Lens& lens) {
  const Projection camera{frame.intrinsics, lens};
  if (frame.depth.empty()) return calibrate(landmarks, clicks, camera, std::nullopt, options);
  if (const auto checked = check_clicks(landmarks, clicks, camera, options); !checked) return checked.failure();

  std::vector<Eigen::Vector2d> pixels;
  for (const Click& click : clicks) pixels.emplace_back(click.x, click.y);
  const auto ground = find_ground(frame, lens, pixels);
  if (!ground) return ground.failure();
  return calibrate(landmarks, clicks, camera, *ground, options);
}

}  // namespace robot::truth
