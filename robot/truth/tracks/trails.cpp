#include "robot/truth/tracks/trails.h"

#include <limits>

#include "robot/truth/tracks/gates.h"
#include "robot/truth/tracks/motion.h"
#include "robot/truth/tracks/scene.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

/// The filter's state at one measurement.
struct Stop {
  std::size_t moment;  // index in the trail
  Step step;           // from the stop before
  Estimate filtered;
};

/// The rules by which a robot is smoothed. Those of a ball have the same functions.
class RobotRules {
 public:
  explicit RobotRules(const std::vector<Sensor>& sensors) : sensors_(sensors) {}
  Estimate first(const Measurement& measurement) const {
    return first_estimate(measurement, robot_errors(sensors_, measurement.place.position), kRobotSpeed);
  }
  Step step(const Estimate& estimate, double dt) const {
    return robot_step(robot_errors(sensors_, estimate.position()), dt);
  }
  Step step_to(std::size_t, const Estimate& estimate, double dt) const { return step(estimate, dt); }
  bool shows(std::size_t) const { return true; }
  double gate() const { return kGate; }

 private:
  const std::vector<Sensor>& sensors_;
};

class BallRules {
 public:
  BallRules(const std::vector<Sensor>& sensors, std::vector<BallEvent> events)
      : sensors_(sensors), events_(std::move(events)) {}
  Estimate first(const Measurement& measurement) const {
    return first_estimate(measurement, ball_errors(sensors_, measurement.place.position), kKickSpeed);
  }
  Step step(const Estimate& estimate, double dt) const {
    return ball_step(estimate, ball_errors(sensors_, estimate.position()), dt);
  }
  Step step_to(std::size_t stop, const Estimate& estimate, double dt) const {
    return ball_event_step(estimate, ball_errors(sensors_, estimate.position()), dt, events_[stop]);
  }
  bool shows(std::size_t stop) const { return events_[stop] != BallEvent::not_a_ball; }
  double gate() const { return std::numeric_limits<double>::infinity(); }

 private:
  const std::vector<Sensor>& sensors_;
  std::vector<BallEvent> events_;
};

/// Runs the filter over all measurements.
template <class Rules>
std::vector<Stop> filtered(const Trail& trail, const Rules& rules) {
  std::vector<Stop> stops;
  for (std::size_t i = 0; i < trail.moments.size(); ++i) {
    const Moment& moment = trail.moments[i];
    if (!moment.measurement) continue;
    if (stops.empty()) {
      stops.push_back({i, {}, rules.first(*moment.measurement)});
      continue;
    }
    const Estimate& before = stops.back().filtered;
    const double dt = seconds_between(trail.moments[stops.back().moment].capture_ns, moment.capture_ns);
    const Step step = rules.step_to(stops.size(), before, dt);
    Estimate estimate = predicted(before, step);
    if (rules.shows(stops.size())) correct(estimate, *moment.measurement, rules.gate());
    stops.push_back({i, step, estimate});
  }
  return stops;
}

/// Runs back from the last measurement to the first one.
template <class Rules>
std::vector<std::optional<FusedPlace>> smoothed_places(const Trail& trail, const Rules& rules) {
  std::vector<std::optional<FusedPlace>> places(trail.moments.size());
  const std::vector<Stop> stops = filtered(trail, rules);
  Estimate estimate;
  for (std::size_t i = stops.size(); i-- > 0;) {
    const bool last = i + 1 == stops.size();
    estimate = last ? stops[i].filtered : smoothed(stops[i].filtered, stops[i + 1].step, estimate);
    if (!rules.shows(i)) continue;
    places[stops[i].moment] = place_of(estimate, trail.track, 1);

    // the moments until the next measurement
    const std::size_t end = last ? trail.moments.size() : stops[i + 1].moment;
    for (std::size_t between = stops[i].moment + 1; between < end; ++between) {
      const double dt = seconds_between(trail.moments[stops[i].moment].capture_ns, trail.moments[between].capture_ns);
      places[between] = place_of(predicted(estimate, rules.step(estimate, dt)), trail.track, 1);
    }
  }
  return places;
}

/// The beginnings and events of all paths after one measurement.
struct Fork {
  std::array<std::uint8_t, kMostPaths> parents{};
  std::array<BallEvent, kMostPaths> events{};
};

Fork fork_of(const BallPaths& paths) {
  Fork fork;
  for (std::size_t i = 0; i < paths.count(); ++i) {
    fork.parents[i] = paths.paths()[i].parent;
    fork.events[i] = paths.paths()[i].event;
  }
  return fork;
}

}  // namespace

Estimate last_of(const Trail& robot, const std::vector<Sensor>& sensors) {
  return filtered(robot, RobotRules(sensors)).back().filtered;
}

std::vector<std::optional<FusedPlace>> smoothed_robot(const Trail& robot, const std::vector<Sensor>& sensors) {
  return smoothed_places(robot, RobotRules(sensors));
}

std::vector<std::optional<FusedPlace>> smoothed_ball(const Trail& ball, const std::vector<Sensor>& sensors) {
  return smoothed_places(ball, BallRules(sensors, ball_events(ball, sensors)));
}

std::vector<BallEvent> ball_events(const Trail& ball, const std::vector<Sensor>& sensors) {
  // forwards: all paths
  std::optional<BallPaths> paths;
  std::vector<Fork> forks;
  std::uint64_t newest_ns = 0;
  for (const Moment& moment : ball.moments) {
    if (!moment.measurement) continue;
    if (paths)
      paths->advance(*moment.measurement, ball_errors(sensors, paths->paths()[0].estimate.position()),
                     seconds_between(newest_ns, moment.capture_ns));
    else
      paths.emplace(*moment.measurement, ball_errors(sensors, moment.measurement->place.position));
    newest_ns = moment.capture_ns;
    forks.push_back(fork_of(*paths));
  }

  // backwards: the best one of the end
  std::vector<BallEvent> events(forks.size());
  std::size_t path = 0;
  for (std::size_t i = forks.size(); i-- > 0;) {
    events[i] = forks[i].events[path];
    path = forks[i].parents[path];
  }
  return events;
}

}  // namespace robot::truth
