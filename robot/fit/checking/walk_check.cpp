#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "robot/core/text.h"
#include "robot/fit/checking/checks.h"
#include "robot/fit/walking/drive_track.h"
#include "robot/fit/walking/mean_walk.h"

namespace robot::fit {
namespace {

using sim::motion::Walk;

constexpr std::size_t kPaceNodes = 5;  // between which the replay is linear
constexpr double kRobotSeconds = 2;    // [s] of a robot that counts
constexpr std::size_t kFewestStretches = 5, kFewestFastest = 3;
constexpr double kLeastShare = 0.5;     // of the greatest speed: it walks ahead, or turns
constexpr double kReplayError = 0.01;   // of a speed: the phase of the steps is not known
constexpr double kCheckTick = 1. / 30;  // [s]

/// The ways to walk that are compared.
enum Going : std::size_t { kAhead, kBack, kAside, kTurning, kGoings };
struct GoingName {
  const char* name;
  const char* unit;
};
constexpr std::array<GoingName, kGoings> kGoingNames{{{"walk: speed ahead", "m/s"},
                                                      {"walk: speed back", "m/s"},
                                                      {"walk: speed to a side", "m/s"},
                                                      {"walk: turn rate", "rad/s"}}};

/// The motion of one robot in all its stretches of one going.
struct RobotWay {
  double time = 0, seen = 0;                   // [s], [m or rad]
  std::array<double, kPaceNodes> predicted{};  // for each pace
  double late = 0;                             // more way [m or rad] if the clock errs by one standard deviation
  double variance = 0;                         // by luck and the error of the truth
  std::size_t stretches = 0;
};
using RobotWays = std::array<RobotWay, kGoings>;

/// Returns the walk with the effects that are switched off.
Walk effective(const sim::Models& models) {
  Walk walk = models.motion.walk;
  const sim::Effects& effects = models.effects;
  if (!effects.walk_spread) walk.spread = 0;
  if (!effects.walk_noise) walk.speed_noise = walk.turn_noise = 0;
  if (!effects.walk_delay) walk.start_delay = walk.stop_delay = 0;
  if (!effects.walk_acceleration) walk.turn_cost = 0, walk.acceleration = 20, walk.turn_acceleration = 60;
  return walk;
}

Walk paced(Walk walk, double pace) {
  const auto factor = static_cast<float>(pace);
  walk.forward *= factor, walk.backward *= factor, walk.sideward *= factor;
  return walk;
}

double pace_of_node(const Walk& walk, std::size_t node) {
  return 1 - walk.spread * static_cast<double>(node) / (kPaceNodes - 1);
}

/// Returns the going of a predicted motion between two blocks.
std::optional<Going> going_of(const BlockStep& step, const Walk& walk) {
  const double ahead = step.ahead / kBlockDuration, left = step.left / kBlockDuration;
  const double turn = step.turn / kBlockDuration;
  if (std::abs(left) < 0.5 * std::abs(ahead)) {
    if (ahead > kLeastShare * walk.forward) return kAhead;
    if (-ahead > kLeastShare * walk.backward) return kBack;
  }
  if (std::abs(ahead) < 0.5 * std::abs(left) && std::abs(left) > kLeastShare * walk.sideward) return kAside;
  if (std::abs(turn) > kLeastShare * walk.turn_rate && std::hypot(ahead, left) < 0.2 * walk.forward) return kTurning;
  return std::nullopt;
}

/// Returns the part of a motion that a going compares, with the sign of `like`.
double along(const BlockStep& step, Going going, const BlockStep& like) {
  switch (going) {
    case kAhead: return step.ahead;
    case kBack: return -step.ahead;
    case kAside: return std::copysign(1, like.left) * step.left;
    default: return std::copysign(1, like.turn) * step.turn;
  }
}

BlockStep less(const BlockStep& a, const BlockStep& b) { return {a.ahead - b.ahead, a.left - b.left, a.turn - b.turn}; }

/// Adds the stretches of one drive to the ways of its robot.
class StretchReader {
 public:
  StretchReader(const Drives& drives, const Drive& drive, const Walk& walk)
      : drives_(drives), drive_(drive), walk_(walk), track_(drive) {
    for (std::size_t node = 0; node < kPaceNodes; ++node) {
      const std::vector<WalkRates> rates = mean_walk(paced(walk, pace_of_node(walk, node)), drive.commands);
      paths_[node] = track_.predicted(rates, 0);
      if (node == kPaceNodes / 2) late_ = track_.predicted(rates, drives.clock_deviation[drive.robot]);
    }
  }

  void read(RobotWays& ways) {
    std::optional<Going> before;
    for (std::size_t i = 0; i + 1 < track_.blocks(); ++i) {
      const bool seen = track_.places_in(i) >= 2 && track_.places_in(i + 1) >= 2;
      const std::optional<Going> going = seen ? going_of(predicted(paths_[0], i), walk_) : std::nullopt;
      if (going) add(*going, i, going == before, ways[*going]);
      before = going;
    }
  }

 private:
  BlockStep predicted(const std::vector<BlockMean>& path, std::size_t block) const {
    return less(seen_between(track_, block, block + 1), missed_between(track_, path, block, block + 1));
  }

  void add(Going going, std::size_t block, bool continues, RobotWay& way) {
    const BlockStep like = predicted(paths_[0], block);
    way.time += kBlockDuration;
    way.seen += along(seen_between(track_, block, block + 1), going, like);
    for (std::size_t node = 0; node < kPaceNodes; ++node)
      way.predicted[node] += along(predicted(paths_[node], block), going, like);
    way.late += along(less(predicted(late_, block), predicted(paths_[kPaceNodes / 2], block)), going, like);
    way.variance += luck(going, block);
    if (continues) return;
    // the errors of the truth at both ends of a stretch
    const double one = going == kTurning ? drives_.heading_deviation : drives_.place_deviation;
    way.variance += 2 * one * one / static_cast<double>(track_.places_in(block));
    ++way.stretches;
  }

  /// Returns the variance of a motion by the luck of the steps.
  double luck(Going going, std::size_t block) const {
    const Walk walk = paced(walk_, pace_of_node(walk_, kPaceNodes / 2));
    const sim::motion::Command& command = drive_.commands[track_.middle_of(block)];
    if (!asks_to_walk(command)) return 0;
    const WalkRates variance = mean_gait(walk, command).variance;
    const double one = going == kTurning ? variance.turn : going == kAside ? variance.y : variance.x;
    return one * kBlockDuration * walk.step_duration;
  }

  const Drives& drives_;
  const Drive& drive_;
  const Walk& walk_;
  DriveTrack track_;
  std::array<std::vector<BlockMean>, kPaceNodes> paths_;
  std::vector<BlockMean> late_;
};

/// Returns the way for a node between two: 0 .. kPaceNodes - 1.
double predicted_at(const RobotWay& way, double node) {
  const auto below = static_cast<std::size_t>(std::min(node, kPaceNodes - 1.001));
  const double share = node - static_cast<double>(below);
  return way.predicted[below] + share * (way.predicted[below + 1] - way.predicted[below]);
}

/// The speeds of the robots that count, of one going.
struct Speeds {
  double sum = 0, most = 0, robots = 0;

  void add(double speed) { sum += speed, most = std::max(most, speed), robots += 1; }
  double mean() const { return sum / robots; }
};

/// Draws one recording of all robots.
std::array<Speeds, kGoings> drawn_speeds(const std::vector<RobotWays>& robots, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, kPaceNodes - 1);
  std::array<Speeds, kGoings> speeds;
  std::array<double, kGoings> factors{};
  for (double& factor : factors) factor = 1 + kReplayError * normal(random);
  for (const RobotWays& ways : robots) {
    const double node = uniform(random), late = normal(random);
    for (std::size_t going = 0; going < kGoings; ++going) {
      const RobotWay& way = ways[going];
      const double luck = std::sqrt(way.variance) * normal(random);
      if (way.time < kRobotSeconds) continue;
      speeds[going].add((factors[going] * predicted_at(way, node) + late * way.late + luck) / way.time);
    }
  }
  return speeds;
}

std::vector<RobotWays> ways_of(const Drives& drives, const Walk& walk) {
  std::vector<RobotWays> robots(drives.robots.size());
  for (const Drive& drive : drives.drives) StretchReader(drives, drive, walk).read(robots[drive.robot]);
  return robots;
}

}  // namespace

std::vector<Statistic> check_walk(const Drives& drives, const sim::Models& models, std::vector<std::string>& missing) {
  const std::vector<RobotWays> robots = ways_of(drives, effective(models));
  std::vector<Statistic> means(kGoings + 1);  // the last one: the fastest robot
  std::array<Speeds, kGoings> recorded;
  for (std::size_t going = 0; going < kGoings; ++going) {
    Statistic& mean = means[going];
    mean.name = kGoingNames[going].name, mean.unit = kGoingNames[going].unit, mean.kind = "stretches";
    for (const RobotWays& ways : robots) {
      const RobotWay& way = ways[going];
      if (way.time < kRobotSeconds) continue;
      recorded[going].add(way.seen / way.time);
      mean.events += way.stretches;
    }
    mean.recorded = recorded[going].mean();
  }
  means[kGoings] = means[kAhead];
  means[kGoings].name += " of the fastest robot";
  means[kGoings].recorded = recorded[kAhead].most;
  if (recorded[kAhead].robots < kFewestFastest) means[kGoings].events = 0;

  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < kCheckSamples; ++i) {
    const std::array<Speeds, kGoings> speeds = drawn_speeds(robots, random);
    for (std::size_t going = 0; going < kGoings; ++going) means[going].simulated.push_back(speeds[going].mean());
    means[kGoings].simulated.push_back(speeds[kAhead].most);
  }
  for (const Statistic& mean : means)
    if (mean.events < kFewestStretches)
      missing.push_back(formatted("%s: expected at least %zu stretches of robots that do so for %.0f s, got %zu",
                                  mean.name.c_str(), kFewestStretches, kRobotSeconds, mean.events));
  std::erase_if(means, [](const Statistic& mean) { return mean.events < kFewestStretches; });
  return means;
}

}  // namespace robot::fit
