#include "robot/fit/ball_noise/ball_places.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "robot/fit/ball_noise/true_path.h"
#include "robot/fit/math/angles.h"

namespace robot::fit {
namespace {

constexpr double kLongestStatus = 0.5;       // [s] that a report of the motion counts
constexpr double kPassPause = 0.5;           // [s]
constexpr double kPassLength = 2;            // [s]
constexpr double kMostSeenDistance = 30;     // [m] no field is longer
constexpr double kLeastTrueDistance = 0.05;  // [m]
constexpr double kRealTime = 0.001;          // [s] by which a report of the motion may be later than the image

/// The ball of one game's truth.
struct TrueBall {
  TruePath path;
  double scatter;  // [m]
  TruthError error;
};

TrueBall true_ball_of(const lab::TruthRecord& truth) {
  const double scatter = scatter_of_places(truth.ball);
  return {.path = TruePath(truth.ball, kBallCurve),
          .scatter = scatter,
          .error = truth_error(truth.ball_deviation, scatter, scatter)};
}

/// A report of the motion by the clock of the truth.
struct GaitAt {
  double at;  // [s]
  Gait gait;
};

std::vector<GaitAt> gaits_of(const SeenBalls& seen) {
  std::vector<GaitAt> gaits;
  for (const GaitReport& report : seen.gaits)
    gaits.push_back({.at = seen.robot->true_seconds(report.capture_ns), .gait = report.gait});
  std::ranges::stable_sort(gaits, {}, &GaitAt::at);
  return gaits;
}

Gait gait_at(const std::vector<GaitAt>& gaits, double at) {
  const auto next = std::ranges::upper_bound(gaits, at + kRealTime, {}, &GaitAt::at);
  if (next == gaits.begin() || at - (next - 1)->at > kLongestStatus) return Gait::unknown;
  return (next - 1)->gait;
}

/// Returns the places at which the robot stands, by index.
std::vector<bool> standing(const lab::Path& path, const std::vector<GaitAt>& gaits) {
  std::vector<bool> stands(path.size(), true);
  if (!gaits.empty())
    for (std::size_t i = 0; i < path.size(); ++i) stands[i] = gait_at(gaits, path[i].at) == Gait::standing;
  return stands;
}

/// One robot beside the truth of its game.
class BallPlacer {
 public:
  BallPlacer(const SeenBalls& seen, const TrueBall& ball, std::size_t recording)
      : seen_(seen),
        robot_(*seen.robot),
        ball_(ball),
        own_(robot_.path, kRobotCurve),
        own_error_(truth_error(robot_.game->record.ball_deviation, scatter_of_places(robot_.path), ball.scatter)),
        gaits_(gaits_of(seen)),
        heading_scatter_(scatter_of_headings(robot_.path, standing(robot_.path, gaits_))),
        recording_(recording) {}

  BallRecording recording() const {
    const bool by_ball =
        robot_.clock_by.find("ball") != std::string::npos || robot_.clock_by.find("gesture") != std::string::npos;
    return {.name = robot_.name,
            .clock = robot_.clock.deviation > 0 ? robot_.session.folder.string() : "",
            .clock_by_ball = by_ball,
            .heading_scatter = heading_scatter_,
            .writing = seen_.writing,
            .has_gait = !gaits_.empty()};
  }

  /// Returns the ball beside its true place, or nothing if the truth does not have it.
  std::optional<BallPlace> placed(const SeenBall& ball) const {
    BallPlace place{.recording = recording_,
                    .at = robot_.true_seconds(ball.capture_ns),
                    .seen_distance = ball.distance,
                    .seen_bearing = ball.bearing};
    if (!beside_truth(ball.capture_ns, place)) return std::nullopt;
    place.gait = gait_at(gaits_, place.at);
    return place;
  }

 private:
  bool beside_truth(std::uint64_t capture_ns, BallPlace& place) const {
    const auto ball = ball_.path.at(place.at), own = own_.at(place.at);
    if (!ball || !own) return false;
    // a kick or a rebound within the window: the curve does not go through the places
    if (ball->scatter > 1.6 * ball_.error.scatter + 0.005) return false;
    const double to_x = ball->x - own->x, to_y = ball->y - own->y;
    place.distance = std::hypot(to_x, to_y);
    if (place.distance < kLeastTrueDistance) return false;
    const double ux = to_x / place.distance, uy = to_y / place.distance;
    place.bearing = wrapped(std::atan2(to_y, to_x) - own->heading);
    place.away = ball->speed_x * ux + ball->speed_y * uy;
    place.across = ball->speed_y * ux - ball->speed_x * uy;
    place.acceleration = ball->bend;
    place.distance_rate = place.away - own->speed_x * ux - own->speed_y * uy;
    place.bearing_rate = (place.across - own->speed_y * ux + own->speed_x * uy) / place.distance - own->turn_rate;
    place.deviation = std::sqrt(ball_.error.variance(*ball) + own_error_.variance(*own));
    place.heading_deviation = heading_scatter_ * std::sqrt(own->share);
    place.speed_deviation = ball_.error.scatter * ball->rate_deviation;
    place.clock_deviation = robot_.clock.deviation_at(robot_.own_seconds(capture_ns));
    return true;
  }

  const SeenBalls& seen_;
  const WatchedRobot& robot_;
  const TrueBall& ball_;
  const TruePath own_;
  const TruthError own_error_;
  const std::vector<GaitAt> gaits_;
  const double heading_scatter_;
  const std::size_t recording_;
};

bool is_possible(const SeenBall& ball) {
  return ball.distance > 0 && ball.distance < kMostSeenDistance && std::isfinite(ball.bearing);
}

void order_places(std::vector<BallPlace>& places) {
  std::ranges::stable_sort(places, [](const BallPlace& one, const BallPlace& other) {
    return std::tie(one.recording, one.at) < std::tie(other.recording, other.at);
  });
}

/// Joins successive passes of a recording so that little more than `most` are left.
std::vector<Group> joined_groups(const std::vector<BallPlace>& places, const std::vector<Group>& groups,
                                 std::size_t most) {
  const std::size_t joins = (groups.size() + most - 1) / most;
  if (joins <= 1) return groups;
  std::vector<Group> wider;
  std::size_t joined = 0;
  for (const Group& group : groups) {
    const bool is_other =
        wider.empty() || joined == joins || places[wider.back().front()].recording != places[group.front()].recording;
    if (is_other) wider.emplace_back(), joined = 0;
    wider.back().insert(wider.back().end(), group.begin(), group.end());
    ++joined;
  }
  return wider;
}

}  // namespace

BallPlaces beside_truth(const std::vector<SeenBalls>& robots) {
  BallPlaces found;
  std::map<const TrueGame*, TrueBall> balls;
  for (const SeenBalls& seen : robots) {
    if (seen.percepts.empty() && seen.beliefs.empty()) continue;
    const TrueGame* const game = seen.robot->game.get();
    if (!balls.contains(game)) balls.emplace(game, true_ball_of(game->record));
    const BallPlacer placer(seen, balls.at(game), found.recordings.size());
    found.recordings.push_back(placer.recording());
    for (const SeenBall& ball : seen.percepts) {
      const bool possible = is_possible(ball);
      const auto place = possible ? placer.placed(ball) : std::nullopt;
      found.damaged += !possible;
      found.without_truth += possible && !place;
      found.headless += place && std::isnan(place->bearing);
      if (place) found.percepts.push_back(*place);
    }
    for (const SeenBall& ball : seen.beliefs) {
      if (!is_possible(ball))
        ++found.damaged;
      else if (const auto place = placer.placed(ball))
        found.beliefs.push_back(*place);
    }
  }
  order_places(found.percepts);
  order_places(found.beliefs);
  return found;
}

BallPlaces read_ball_places(const Evidence& evidence) {
  std::vector<SeenBalls> robots;
  for (const WatchedRobot& robot : evidence.robots) robots.push_back(read_seen_balls(robot));
  return beside_truth(robots);
}

std::vector<Group> passes_of(const std::vector<BallPlace>& places, const std::vector<std::size_t>& chosen,
                             std::size_t most) {
  std::vector<Group> passes;
  double begun = 0;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const BallPlace& place = places[chosen[k]];
    const BallPlace* const before = k > 0 ? &places[chosen[k - 1]] : nullptr;
    const bool goes_on = before && place.recording == before->recording && place.at < before->at + kPassPause &&
                         place.at < begun + kPassLength;
    if (!goes_on) {
      passes.emplace_back();
      begun = place.at;
    }
    passes.back().push_back(chosen[k]);
  }
  return joined_groups(places, passes, most);
}

}  // namespace robot::fit
