#include "robot/fit/localisation/drift.h"

#include "robot/fit/math/angles.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace robot::fit {
namespace {

constexpr double kLongestDriftPause = 0.25;  // [s] between two messages
constexpr double kDriftJump = 0.25,
                 kFastestWalk = 1.5;  // [m] beyond [m/s]: it was carried, or the truth took another robot for it
constexpr double kTurnCounts = 0.5;   // [m/rad]
constexpr double kStillWindow = 0.02, kStanding = 2;  // [m] at most in [s]: it stands
constexpr double kLongestWindow = 30;                 // [s] of a window
constexpr double kMeans = 0.33;                       // [s] at each end
constexpr double kLookAround = 0.25;                  // [s] to either side, for speeds by the truth
constexpr double kSlowWalk = 0.08, kSlowTurn = 0.2;   // [m/s], [rad/s] slower by the truth alone is its error

/// The odometry beside the truth at one moment, all since the begin of its part.
struct DriftMoment {
  double at = 0;
  double drift_x = 0, drift_y = 0, drift_turn = 0;  // believed minus true
  double x = 0, y = 0, heading = 0;                 // true
  double way = 0, turned = 0;                       // walked so far
};

/// The moments between two breaks.
using DriftPart = std::vector<DriftMoment>;

/// The speeds of the robot: by motion_status, else by the truth.
class DriftSpeeds {
 public:
  explicit DriftSpeeds(const WatchedMotion& motion)
      : motion_(motion), before_(motion.truth), after_(motion.truth), by_status_(!motion.status.empty()) {}

  /// Returns [m/s] and [rad/s], or nothing where they are not known.
  std::optional<std::pair<double, double>> at(double seconds) {
    if (by_status_) {
      const StatusAt* status = latest(motion_.status, seconds, index_);
      if (!status || seconds - status->at > kLongestDriftPause) return std::nullopt;
      return std::pair{status->speed, status->turn_rate};
    }
    const auto from = before_.at(seconds - kLookAround), to = after_.at(seconds + kLookAround);
    if (!from || !to) return std::nullopt;
    const double error = std::sqrt(2.) * motion_.place_deviation;
    const double square = std::pow(to->x - from->x, 2) + std::pow(to->y - from->y, 2) - 2 * error * error;
    const double speed = std::sqrt(std::max(0., square)) / (2 * kLookAround);
    const double turn_rate = std::abs(wrapped(to->heading - from->heading)) / (2 * kLookAround);
    return std::pair{speed < kSlowWalk ? 0 : speed, turn_rate < kSlowTurn ? 0 : turn_rate};
  }

 private:
  const WatchedMotion& motion_;
  TruthReader before_, after_;
  const bool by_status_;
  std::size_t index_ = 0;
};

/// Says whether the robot walks on its own feet at a moment.
class OwnWalk {
 public:
  OwnWalk(const WatchedMotion& motion, DriftLosses& losses) : motion_(motion), losses_(losses) {}

  bool at(const TrueMoment& truth) {
    const StatusAt* status = latest(motion_.status, truth.at, status_);
    const GameAt* game = latest(motion_.games, truth.at, game_);
    if (truth.fallen || (status && status->body != StatusAt::Body::upright)) return ++losses_.lying, false;
    if (game && (game->penalised || !game->moves)) return ++losses_.carried, false;
    if (truth.crowded) return ++losses_.crowded, false;
    return true;
  }

 private:
  const WatchedMotion& motion_;
  DriftLosses& losses_;
  std::size_t status_ = 0, game_ = 0;
};

/// Builds the parts.
class DriftBuilder {
 public:
  void end() {
    if (part_.size() > 1) parts_.push_back(std::move(part_));
    part_.clear();
  }

  void add(const OdometryAt& odometry, const TrueMoment& truth, const std::pair<double, double>& speeds) {
    if (!part_.empty() && jumps(odometry, truth)) end();
    const double apart = truth.heading - odometry.heading;
    if (part_.empty()) {
      part_.push_back({.at = truth.at, .x = truth.x, .y = truth.y, .heading = truth.heading});
      apart_ = smooth_ = apart;
    } else {
      part_.push_back(next(odometry, truth, speeds));
    }
    odometry_ = odometry, truth_ = truth;
  }

  std::vector<DriftPart> parts() && { return std::move(parts_); }

 private:
  bool jumps(const OdometryAt& odometry, const TrueMoment& truth) const {
    const double dt = truth.at - truth_.at, most = kDriftJump + kFastestWalk * dt;
    return dt > kLongestDriftPause || std::hypot(truth.x - truth_.x, truth.y - truth_.y) > most ||
           std::hypot(odometry.x - odometry_.x, odometry.y - odometry_.y) > most;
  }

  DriftMoment next(const OdometryAt& odometry, const TrueMoment& truth, const std::pair<double, double>& speeds) {
    const DriftMoment& last = part_.back();
    const double dt = truth.at - truth_.at;
    // a step is turned by the mean angle between the frames, so that the scatter of true headings does not shorten the way
    const double x = odometry.x - odometry_.x, y = odometry.y - odometry_.y;
    const double c = std::cos(smooth_), s = std::sin(smooth_);
    const double turn = wrapped(odometry.heading - odometry_.heading);
    const double true_turn = wrapped(truth.heading - truth_.heading);
    apart_ += true_turn - turn;
    smooth_ += 0.2 * (apart_ - smooth_);
    return {.at = truth.at,
            .drift_x = last.drift_x + c * x - s * y - (truth.x - truth_.x),
            .drift_y = last.drift_y + s * x + c * y - (truth.y - truth_.y),
            .drift_turn = last.drift_turn + turn - true_turn,
            .x = truth.x,
            .y = truth.y,
            .heading = last.heading + true_turn,
            .way = last.way + speeds.first * dt,
            .turned = last.turned + speeds.second * dt};
  }

  std::vector<DriftPart> parts_;
  DriftPart part_;
  OdometryAt odometry_;
  TrueMoment truth_;
  double apart_ = 0, smooth_ = 0;  // [rad] from the odometry's frame to the field
};

std::vector<DriftPart> drift_parts_of(const WatchedMotion& motion, DriftLosses& losses) {
  TruthReader truth(motion.truth);
  DriftSpeeds speeds(motion);
  OwnWalk walks(motion, losses);
  DriftBuilder builder;
  for (const OdometryAt& odometry : motion.odometry) {
    const auto there = truth.at(odometry.at);
    const auto speed = speeds.at(odometry.at);
    if (!there || !speed) {
      ++losses.unseen;
      builder.end();
    } else if (!walks.at(*there)) {
      builder.end();
    } else {
      builder.add(odometry, *there, *speed);
    }
  }
  builder.end();
  return std::move(builder).parts();
}

/// The mean of the moments around one of them.
struct DriftEnd {
  DriftMoment mean;
  double way = 0, turned = 0;  // within it
};

/// Cuts a part into windows.
class DriftCutter {
 public:
  DriftCutter(const DriftPart& part, std::size_t recording, std::vector<DriftWindow>& windows)
      : part_(part), recording_(recording), windows_(windows) {
    const double step = (part.back().at - part.front().at) / static_cast<double>(part.size() - 1);
    reach_ = static_cast<std::size_t>(std::lround(kMeans / 2 / std::max(step, 1e-3)));
  }

  /// Cuts windows of `lengths` in turn, beginning with `next`.
  void cut(const std::vector<double>& lengths, std::size_t& next) {
    std::size_t begin = reach_;
    for (std::size_t i = begin; i + reach_ < part_.size(); ++i) {
      const DriftMoment &from = part_[begin], &to = part_[i];
      const double size = to.way - from.way + kTurnCounts * (to.turned - from.turned);
      const bool stands = size < kStillWindow && to.at - from.at >= kStanding;
      if (size < lengths[next % lengths.size()] && !stands) {
        if (to.at - from.at > kLongestWindow) begin = i;
        continue;
      }
      windows_.push_back(between(begin, i));
      if (!stands) ++next;
      begin = i;
    }
  }

 private:
  DriftEnd end_at(std::size_t index) const {
    DriftEnd end;
    const auto count = static_cast<double>(2 * reach_ + 1);
    const DriftMoment& middle = part_[index];
    for (std::size_t i = index - reach_; i <= index + reach_; ++i) {
      const DriftMoment& one = part_[i];
      end.mean.drift_x += (one.drift_x - middle.drift_x) / count;
      end.mean.drift_y += (one.drift_y - middle.drift_y) / count;
      end.mean.drift_turn += (one.drift_turn - middle.drift_turn) / count;
      end.mean.x += (one.x - middle.x) / count;
      end.mean.y += (one.y - middle.y) / count;
      end.mean.heading += (one.heading - middle.heading) / count;
    }
    end.mean.drift_x += middle.drift_x, end.mean.drift_y += middle.drift_y;
    end.mean.drift_turn += middle.drift_turn;
    end.mean.x += middle.x, end.mean.y += middle.y, end.mean.heading += middle.heading;
    end.way = part_[index + reach_].way - part_[index - reach_].way;
    end.turned = part_[index + reach_].turned - part_[index - reach_].turned;
    return end;
  }

  DriftWindow between(std::size_t begin, std::size_t last) const {
    const DriftEnd from = end_at(begin), to = end_at(last);
    const DriftMoment &a = from.mean, &b = to.mean;
    const double way = part_[last].way - part_[begin].way, turned = part_[last].turned - part_[begin].turned;
    return {.recording = recording_,
            .at = part_[begin].at,
            .duration = part_[last].at - part_[begin].at,
            .way = way,
            .turned = turned,
            // the mean of a random walk over a length L at either end takes away L/6 of its growth
            .grown_way = std::max(0., way - (from.way + to.way) / 6),
            .grown_turned = std::max(0., turned - (from.turned + to.turned) / 6),
            .true_x = b.x - a.x,
            .true_y = b.y - a.y,
            .true_turn = b.heading - a.heading,
            .error_x = b.drift_x - a.drift_x,
            .error_y = b.drift_y - a.drift_y,
            .error_turn = b.drift_turn - a.drift_turn};
  }

  const DriftPart& part_;
  const std::size_t recording_;
  std::vector<DriftWindow>& windows_;
  std::size_t reach_ = 0;
};

}  // namespace

void add_drift(const WatchedMotion& motion, Drift& drift) {
  const std::size_t recording = drift.recordings.size();
  drift.recordings.push_back(motion.name);
  drift.losses.damaged += motion.damaged;
  const std::vector<DriftPart> parts = drift_parts_of(motion, drift.losses);
  std::size_t next = 0;
  const std::vector<double> lengths{std::begin(kDriftLengths), std::end(kDriftLengths)};
  for (const DriftPart& part : parts) DriftCutter(part, recording, drift.windows).cut(lengths, next);
  for (const double length : kGrowthLengths)
    for (const DriftPart& part : parts) DriftCutter(part, recording, drift.growth).cut({length}, next = 0);
}

}  // namespace robot::fit
