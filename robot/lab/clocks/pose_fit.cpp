#include "robot/lab/clocks/pose_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "robot/lab/clocks/lag_profile.h"

namespace robot::lab {
namespace {

constexpr double kStretch = 30;     // [s] during which the frames do not turn
constexpr double kStep = 0.5;       // [s] between two lags; a robot walks a decimetre in that time
constexpr double kInterval = 1;     // [s] between the poses of the search
constexpr double kMostPoses = 600;  // of the search
constexpr double kFar = 1;          // [m] further away is not worse
constexpr std::size_t kLeastPlaces = 15;

PoseBelief turned(const PoseBelief& pose) {
  return {.at = pose.at,
          .x = -pose.x,
          .y = -pose.y,
          .heading = std::remainder(pose.heading + std::numbers::pi, 2 * std::numbers::pi)};
}

/// The distances of the poses to the path at one lag.
class PoseFit {
 public:
  PoseFit(const std::vector<PoseBelief>& poses, const Path& path, double lag) {
    for (const PoseBelief& pose : poses) {
      const auto place = place_at(path, pose.at - lag);
      if (!place) continue;
      const PoseBelief other = turned(pose);
      Stretch& stretch = stretches_[number_of(pose.at)];
      stretch.straight += std::min(kFar, std::hypot(place->x - pose.x, place->y - pose.y));
      stretch.turned += std::min(kFar, std::hypot(place->x - other.x, place->y - other.y));
      ++places_;
    }
  }

  std::size_t places() const { return places_; }

  /// Returns the mean distance [m] when each stretch is turned as it fits best.
  double error() const {
    double sum = 0;
    for (const auto& [number, stretch] : stretches_) sum += std::min(stretch.straight, stretch.turned);
    return sum / static_cast<double>(places_);
  }

  /// Returns the pose in the frame of the path. Where the path has no place, the stretch before decides. There is a place.
  PoseBelief in_field(const PoseBelief& pose) const {
    auto stretch = stretches_.upper_bound(number_of(pose.at));
    if (stretch != stretches_.begin()) --stretch;
    return stretch->second.turned < stretch->second.straight ? turned(pose) : pose;
  }

 private:
  struct Stretch {
    double straight = 0, turned = 0;  // [m] sums of distances
  };

  static std::int64_t number_of(double at) { return static_cast<std::int64_t>(std::floor(at / kStretch)); }

  std::map<std::int64_t, Stretch> stretches_;  // by number: those with a place
  std::size_t places_ = 0;
};

std::vector<PoseBelief> few_of(const std::vector<PoseBelief>& poses) {
  const double interval = std::max(kInterval, (poses.back().at - poses.front().at) / kMostPoses);
  std::vector<PoseBelief> few;
  for (const PoseBelief& pose : poses)
    if (few.empty() || pose.at - few.back().at >= interval) few.push_back(pose);
  return few;
}

}  // namespace

FieldPoses fit_poses(const std::vector<PoseBelief>& poses, const Path& path, const LagRange& range) {
  FieldPoses best;
  if (poses.empty()) return best;
  const std::vector<PoseBelief> few = few_of(poses);
  const Lags lags = Lags::around(range.middle, std::min(range.reach, kLongestReach), kStep);
  std::vector<PoseFit> fits;
  std::size_t most = 0;
  for (std::size_t i = 0; i < lags.count; ++i) {
    fits.emplace_back(few, path, lags.at(i));
    most = std::max(most, fits.back().places());
  }
  // a few poses of a robot that stands fit at many lags
  const PoseFit* chosen = nullptr;
  for (std::size_t i = 0; i < lags.count; ++i) {
    if (fits[i].places() < std::max(kLeastPlaces, most / 2) || fits[i].error() >= best.error) continue;
    best.error = fits[i].error(), best.lag = lags.at(i);
    chosen = &fits[i];
  }
  if (!chosen) return best;
  for (const PoseBelief& pose : poses) best.poses.push_back(chosen->in_field(pose));
  return best;
}

const PoseBelief* pose_at(const std::vector<PoseBelief>& poses, double at) {
  constexpr double kOldest = 0.1;  // [s]
  const auto after = std::ranges::upper_bound(poses, at, {}, &PoseBelief::at);
  if (after == poses.begin() || at - (after - 1)->at > kOldest) return nullptr;
  return &*(after - 1);
}

}  // namespace robot::lab
