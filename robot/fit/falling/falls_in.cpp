#include "robot/fit/falling/falls_in.h"

#include <algorithm>
#include <cmath>

#include "proto/foresight/motion.pb.h"
#include "robot/fit/math/angles.h"
#include "robot/fit/mean_path.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::fit {
namespace {

constexpr double kAround = 0.5;                          // [s] before and after: 30 images
constexpr double kGoesDown = 22. / 30, kIsUp = 8. / 30;  // share of them (sim/statistics/walking.h)
constexpr std::size_t kFewestJudged = 8;                 // images around
constexpr double kUnseen = 0.5;                          // [s] without a place: another stay
constexpr double kSameTime = 1e-6;                       // [s] times are sums of 1/30 s
constexpr double kStep = 0.1;                            // [s] between moments of risk
constexpr double kMeanTime = 0.2;                        // [s] before a moment, over which places are averaged
constexpr double kHalfImage = 1. / 60;                   // [s]
constexpr double kWalkTime = 0.5;                        // [s]
constexpr double kStands = 0.03, kCarried = 0.4;         // [m] in that time; 0.8 m/s as in sim/statistics/walking.h
constexpr double kTurns = 0.08;                          // [rad] in that time
constexpr double kLongestStatusGap = 0.5;                // [s]

/// A time on the ground, or the part of it that was seen.
struct Lie {
  double begin, end;  // [s]
  bool saw_begin, saw_end;
};

/// The state of a robot while its path is read: down, up, or not known yet.
class LieFinder {
 public:
  void look(double at, double down_share) {
    if (down_share >= kGoesDown && !is_down_) go_down(at + kAround - 2 * kAround * down_share);
    if (down_share <= kIsUp) stand_up(at - kAround + 2 * kAround * down_share);
    last_ = at;
  }

  /// The robot is not seen any more.
  void leave() {
    if (is_down_) lies_.push_back({.begin = begin_, .end = last_, .saw_begin = was_up_, .saw_end = false});
    is_down_ = was_up_ = false;
  }

  std::vector<Lie> lies() && { return std::move(lies_); }

 private:
  void go_down(double at) { is_down_ = true, begin_ = at; }

  void stand_up(double at) {
    if (is_down_) lies_.push_back({.begin = begin_, .end = at, .saw_begin = was_up_, .saw_end = true});
    is_down_ = false, was_up_ = true;
  }

  std::vector<Lie> lies_;
  double begin_ = 0, last_ = 0;
  bool is_down_ = false, was_up_ = false;
};

std::vector<Lie> lies_of(const std::vector<lab::PlaceAt>& places) {
  LieFinder finder;
  std::size_t from = 0, to = 0, judged = 0, down = 0;
  const auto count = [&](const lab::PlaceAt& place, int sign) {
    if (!place.fallen) return;
    judged += static_cast<std::size_t>(sign);
    if (*place.fallen) down += static_cast<std::size_t>(sign);
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double at = places[i].at;
    if (i > 0 && at - places[i - 1].at > kUnseen) finder.leave();
    while (to < places.size() && places[to].at <= at + kAround + kSameTime) count(places[to++], 1);
    while (places[from].at < at - kAround - kSameTime) count(places[from++], -1);
    if (judged >= kFewestJudged) finder.look(at, static_cast<double>(down) / static_cast<double>(judged));
  }
  finder.leave();
  return std::move(finder).lies();
}

/// A robot of the truth on a grid of moments that all robots share.
struct OnGrid {
  MeanPath path;
  std::vector<Lie> lies;
  std::vector<std::optional<MeanPath::Mean>> places;  // means of the time just before

  bool is_judged() const {
    return std::ranges::any_of(path.places(), [](const lab::PlaceAt& place) { return place.fallen.has_value(); });
  }
};

/// Returns whether the robot walks at a moment, or nothing if it was not seen for a second before, or was carried.
std::optional<bool> walks_at(const MeanPath& path, double at) {
  const auto now = path.over(at - kMeanTime, at);
  const auto before = path.over(at - kMeanTime - kWalkTime, at - kWalkTime);
  if (!now || !before) return std::nullopt;
  const double way = std::hypot(now->x - before->x, now->y - before->y);
  if (way > kCarried) return std::nullopt;
  const double turn = std::abs(wrapped(now->heading - before->heading));
  return way > kStands || turn > kTurns;  // a turn of NaN does not count
}

/// The distances at which robots touch.
struct Reach {
  double upright = 0.32, lying = 0.41;  // [m] to another robot that is upright, or lies
  double doubt = 0;                     // [m] two errors of a distance
};

bool lies_at(const std::vector<Lie>& lies, double at) {
  const auto next = std::ranges::lower_bound(lies, at, {}, &Lie::end);
  return next != lies.end() && next->begin <= at;
}

/// Returns the room between two robots [m]: negative if they overlap.
double room_between(const MeanPath::Mean& own, const OnGrid& other, const std::optional<MeanPath::Mean>& place,
                    double at, const Reach& reach) {
  if (!place) return INFINITY;
  const double distance = std::hypot(place->x - own.x, place->y - own.y);
  if (distance > reach.lying + reach.doubt) return INFINITY;
  return distance - (lies_at(other.lies, at) ? reach.lying : reach.upright);
}

/// Returns the room to the nearest other robot [m].
double room_at(const std::vector<OnGrid>& robots, std::size_t robot, std::size_t moment, double at,
               const Reach& reach) {
  const auto& own = robots[robot].places[moment];
  double room = INFINITY;
  for (std::size_t k = 0; k < robots.size(); ++k)
    if (k != robot) room = std::min(room, room_between(*own, robots[k], robots[k].places[moment], at, reach));
  return room;
}

/// Reports whether a robot touched another one just before it fell. Afterwards it takes more room, and others give way.
bool touches_before(const std::vector<OnGrid>& robots, std::size_t robot, double fall, const Reach& reach) {
  const double end = fall - kHalfImage;
  const auto own = robots[robot].path.over(end - kMeanTime, end);
  double room = INFINITY;
  for (std::size_t k = 0; own && k < robots.size(); ++k)
    if (k != robot)
      room = std::min(room, room_between(*own, robots[k], robots[k].path.over(end - kMeanTime, end), end, reach));
  return room < reach.doubt;
}

/// Counts the time of risk and the falls of one robot.
FallRisk risk_of(const std::vector<OnGrid>& robots, std::size_t robot, double start, const Reach& reach) {
  const OnGrid& own = robots[robot];
  FallRisk risk;
  for (std::size_t moment = 0; moment < own.places.size(); ++moment) {
    const double at = start + kStep * static_cast<double>(moment);
    if (!own.places[moment] || lies_at(own.lies, at)) continue;
    const auto walks = walks_at(own.path, at);
    if (!walks) continue;
    risk.upright += kStep;
    if (*walks) risk.walking += kStep;
    const double room = room_at(robots, robot, moment, at, reach);
    if (room < reach.doubt) risk.touching += kStep;
    if (room < 0) risk.overlapping += kStep;
  }
  for (const Lie& lie : own.lies) {
    if (!lie.saw_begin) continue;
    risk.falls.push_back({.at = lie.begin,
                          .walking = walks_at(own.path, lie.begin).value_or(false),
                          .touching = touches_before(robots, robot, lie.begin, reach),
                          .down = lie.saw_end ? std::optional(lie.end - lie.begin) : std::nullopt});
  }
  return risk;
}

}  // namespace

std::vector<FallRisk> falls_in(const lab::TruthRecord& truth, const RobotSizes& sizes, std::size_t recording) {
  std::vector<OnGrid> robots;
  double start = INFINITY, end = -INFINITY;
  for (const lab::TrueRobotPath& robot : truth.robots) {
    robots.push_back({.path = MeanPath(robot.path), .lies = {}, .places = {}});
    const auto& places = robots.back().path.places();
    robots.back().lies = lies_of(places);
    if (!places.empty()) start = std::min(start, places.front().at), end = std::max(end, places.back().at);
  }
  if (!(end > start)) return {};
  const auto moments = static_cast<std::size_t>((end - start) / kStep) + 1;
  for (OnGrid& robot : robots)
    for (std::size_t moment = 0; moment < moments; ++moment) {
      const double at = start + kStep * static_cast<double>(moment);
      robot.places.push_back(robot.path.over(at - kMeanTime, at));
    }
  // the error of a distance between two means of seven images
  const Reach reach{.upright = 2 * sizes.upright,
                    .lying = sizes.upright + sizes.lying,
                    .doubt = 2 * truth.ball_deviation * std::sqrt(2. / 7)};
  std::vector<FallRisk> risks;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!robots[i].is_judged()) continue;
    risks.push_back(risk_of(robots, i, start, reach));
    risks.back().recording = recording;
    risks.back().robot = truth.robots[i].name;
  }
  return risks;
}

FallPhases read_fall_phases(const WatchedRobot& robot) {
  using Status = foresight::MotionStatus;
  FallPhases phases;
  Status::Fall phase = Status::FALL_UNSPECIFIED;
  double begin = 0, before = 0, sum = 0, messages = 0;
  bool saw_begin = false;
  const auto add = [&](const Status& status, std::uint64_t capture_ns) {
    const double at = robot.true_seconds(capture_ns), pause = at - before;
    // a robot that falls lies for the models
    const Status::Fall now = status.fall() == Status::FALL_FALLING ? Status::FALL_FALLEN : status.fall();
    const bool continues = pause > 0 && pause < kLongestStatusGap;
    if (continues) sum += pause, messages += 1;
    if (!continues || now != phase) {
      if (continues && phase == Status::FALL_FALLEN && saw_begin) phases.lying.push_back(at - begin);
      if (continues && phase == Status::FALL_GETTING_UP) {
        if (saw_begin) phases.getting_up.push_back(at - begin);
        ++phases.attempts, phases.failures += now == Status::FALL_FALLEN ? 1 : 0;
      }
      saw_begin = continues && phase != Status::FALL_UNSPECIFIED;
      begin = at, phase = now;
    }
    before = at;
  };
  logging::read_each<Status>(robot.session, "/" + robot.session.info.robot + "/motion_status", add);
  phases.interval = messages > 0 ? sum / messages : 0;
  return phases;
}

}  // namespace robot::fit
