#include "robot/lab/clocks/truth_record.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "proto/foresight/truth.pb.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::lab {
namespace {

using foresight::GroundTruth;

bool is_finite(float x, float y) { return std::isfinite(x) && std::isfinite(y); }

/// Orders the places by their times. Of several at one time the first stays.
void order(Path& path) {
  std::ranges::stable_sort(path, {}, &PlaceAt::at);
  const auto is_same = [](const PlaceAt& a, const PlaceAt& b) { return a.at == b.at; };
  path.erase(std::unique(path.begin(), path.end(), is_same), path.end());
}

/// The robots that have neither a number nor a track, joined by continuity.
class Unnamed {
 public:
  /// Returns the name of the robot at a place. Robots of one image have different names.
  std::string name_of(const PlaceAt& place) {
    constexpr double kLongestStep = 0.5, kLongestPause = 1;  // [m], [s]
    Last* nearest = nullptr;
    double least = kLongestStep;
    for (Last& last : lasts_) {
      const double far = std::hypot(place.x - last.place.x, place.y - last.place.y), pause = place.at - last.place.at;
      if (pause > 0 && pause <= kLongestPause && far < least) least = far, nearest = &last;
    }
    if (!nearest) {
      std::erase_if(lasts_, [&](const Last& last) { return place.at - last.place.at > kLongestPause; });
      lasts_.push_back({.number = ++count_, .place = {}});
      nearest = &lasts_.back();
    }
    nearest->place = place;
    return "robot " + std::to_string(nearest->number);
  }

 private:
  struct Last {
    int number;
    PlaceAt place;
  };
  std::vector<Last> lasts_;
  int count_ = 0;
};

/// The record while messages are added.
class TruthRecorder {
 public:
  explicit TruthRecorder(std::uint64_t epoch_ns) { record_.epoch_ns = epoch_ns; }

  void add(const GroundTruth& truth, std::uint64_t capture_ns) {
    const double at = static_cast<double>(static_cast<std::int64_t>(capture_ns - record_.epoch_ns)) * 1e-9;
    const bool seen = truth.has_ball() && is_finite(truth.ball().x(), truth.ball().y());
    record_.sightings.push_back({.at = at, .seen = seen});
    if (seen) add_ball(truth.ball(), at);
    for (const GroundTruth::TrueRobot& robot : truth.robots())
      if (is_finite(robot.x(), robot.y()))
        add_robot(robot, {.at = at,
                          .x = robot.x(),
                          .y = robot.y(),
                          .heading = robot.has_heading() ? static_cast<double>(robot.heading()) : NAN,
                          .fallen = robot.has_fallen() ? std::optional(robot.fallen()) : std::nullopt});
  }

  TruthRecord finished() && {
    order(record_.ball);
    for (auto& [name, path] : paths_) {
      order(path);
      record_.robots.push_back({.name = name, .path = std::move(path)});
    }
    if (!deviations_.empty()) {
      record_.ball_deviation = median_of(std::move(deviations_));
    }
    return std::move(record_);
  }

 private:
  void add_ball(const GroundTruth::TrueBall& ball, double at) {
    record_.ball.push_back({.at = at, .x = ball.x(), .y = ball.y()});
    const double variance = ball.has_covariance() ? std::max(ball.covariance().xx(), ball.covariance().yy()) : 0;
    if (variance > 0 && std::isfinite(variance)) deviations_.push_back(std::sqrt(variance));
  }

  void add_robot(const GroundTruth::TrueRobot& robot, const PlaceAt& place) {
    paths_[name_of(robot, place)].push_back(place);
  }

  std::string name_of(const GroundTruth::TrueRobot& robot, const PlaceAt& place) {
    if (robot.has_team() && robot.has_player())
      return std::to_string(robot.team()) + "/" + std::to_string(robot.player());
    if (robot.has_track()) return "track " + std::to_string(robot.track());
    return unnamed_.name_of(place);
  }

  TruthRecord record_;
  std::map<std::string, Path> paths_;
  std::vector<double> deviations_;  // [m] reported for the ball
  Unnamed unnamed_;
};

}  // namespace

TruthRecord read_truth(const logging::Session& session) {
  TruthRecorder recorder(session.start_ns);
  logging::read_each<GroundTruth>(
      session, memory::kTruthTopic,
      [&](const GroundTruth& truth, std::uint64_t capture_ns) { recorder.add(truth, capture_ns); });
  return std::move(recorder).finished();
}

std::optional<PlaceAt> place_at(const Path& path, double at) {
  const auto next = std::ranges::lower_bound(path, at, {}, &PlaceAt::at);
  if (next == path.end()) return std::nullopt;
  if (next->at == at) return *next;
  if (next == path.begin()) return std::nullopt;
  const PlaceAt &before = *(next - 1), &after = *next;
  if (after.at - before.at > SmoothCurve::kLongestGap) return std::nullopt;
  const double part = (at - before.at) / (after.at - before.at);
  return PlaceAt{.at = at,
                 .x = before.x + part * (after.x - before.x),
                 .y = before.y + part * (after.y - before.y),
                 .heading = part < 0.5 ? before.heading : after.heading,
                 .fallen = part < 0.5 ? before.fallen : after.fallen};
}

SmoothCurve curve_of(const Path& path, double PlaceAt::*coordinate) {
  Series series;
  series.reserve(path.size());
  for (const PlaceAt& place : path) series.push_back({.at = place.at, .value = place.*coordinate});
  return SmoothCurve(tidied(std::move(series)));
}

Series distances_between(const Path& one, const Path& other) {
  Series distances;
  for (const PlaceAt& place : one)
    if (const auto there = place_at(other, place.at))
      distances.push_back({.at = place.at, .value = std::hypot(there->x - place.x, there->y - place.y)});
  return distances;
}

}  // namespace robot::lab
