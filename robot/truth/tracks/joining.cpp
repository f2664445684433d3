#include "robot/truth/tracks/joining.h"

#include <algorithm>

#include "robot/truth/tracks/motion.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kLongestGap = 15;  // [s]
constexpr double kNearGate = 9;     // squared Mahalanobis distance: 99 % of the right ones
constexpr double kFastest = 0.5;    // [m/s] faster than any walk over seconds
constexpr double kNearby = 0.3;     // [m]
constexpr std::size_t kSeveral = static_cast<std::size_t>(-1), kNone = static_cast<std::size_t>(-2);

/// A trail's end and beginning.
struct Ends {
  Estimate last;
  std::uint64_t last_ns;
  std::uint64_t first_ns;
  Measurement first;
};

Ends ends_of(const Trail& trail, const std::vector<Sensor>& sensors) {
  const auto last = std::find_if(trail.moments.rbegin(), trail.moments.rend(),
                                 [](const Moment& moment) { return moment.measurement.has_value(); });
  return {last_of(trail, sensors), last->capture_ns, trail.moments.front().capture_ns,
          *trail.moments.front().measurement};
}

bool contradict(const RobotTrail& a, const RobotTrail& b) {
  return a.several_players || b.several_players || (a.player && b.player && *a.player != *b.player);
}

bool can_walk(const Ends& from, const Ends& to, const std::vector<Sensor>& sensors) {
  const double dt = seconds_between(from.last_ns, to.first_ns);
  if (dt <= 0 || dt > kLongestGap) return false;
  const Eigen::Vector2d way = to.first.place.position - from.last.position();
  if (way.norm() > kNearby + kFastest * dt) return false;
  const Step step = robot_step(robot_errors(sensors, from.last.position()), dt);
  return innovation(predicted(from.last, step), to.first).distance_squared <= kNearGate;
}

/// Notes one more partner: the first one, or that there are several.
void note(std::size_t& partner, std::size_t other) { partner = partner == kNone ? other : kSeveral; }

void append(RobotTrail& trail, RobotTrail& later) {
  std::move(later.trail.moments.begin(), later.trail.moments.end(), std::back_inserter(trail.trail.moments));
  if (!trail.player) trail.player = later.player;
  later.trail.moments.clear();
}

}  // namespace

void join_broken(std::vector<RobotTrail>& trails, const std::vector<Sensor>& sensors) {
  std::vector<Ends> ends;
  for (const RobotTrail& trail : trails) ends.push_back(ends_of(trail.trail, sensors));

  std::vector<std::size_t> after(trails.size(), kNone), before(trails.size(), kNone);
  for (std::size_t a = 0; a < trails.size(); ++a)
    for (std::size_t b = 0; b < trails.size(); ++b)
      if (!contradict(trails[a], trails[b]) && can_walk(ends[a], ends[b], sensors)) {
        note(after[a], b);
        note(before[b], a);
      }

  // the last one first, so that a trail that is appended has its own later parts already
  for (std::size_t a = trails.size(); a-- > 0;)
    if (after[a] < trails.size() && before[after[a]] == a && !contradict(trails[a], trails[after[a]]))
      append(trails[a], trails[after[a]]);
  const auto empty = [](const RobotTrail& trail) { return trail.trail.moments.empty(); };
  trails.erase(std::remove_if(trails.begin(), trails.end(), empty), trails.end());
}

}  // namespace robot::truth
