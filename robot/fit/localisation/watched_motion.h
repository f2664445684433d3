// One robot's motion as it believes it, beside the truth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"

namespace robot::fit {

/// The believed path at one moment.
struct OdometryAt {
  double at = 0;                     // [s, clock of the truth]
  double x = 0, y = 0, heading = 0;  // [m, rad; odometry]
};

/// The believed pose at one moment.
struct PoseAt {
  double at = 0;                     // [s, clock of the truth]
  double x = 0, y = 0, heading = 0;  // [m, rad; team_field]
  double deviation = NAN;            // [m] the greater one of both axes; NaN: not reported
  double deviation_heading = NAN;    // [rad]
};

/// The body at one moment.
struct StatusAt {
  double at = 0;  // [s, clock of the truth]
  enum class Body : unsigned char { upright, fallen, getting_up } body = Body::upright;
  double speed = 0;      // [m/s] by odometry
  double turn_rate = 0;  // [rad/s] its size
};

/// The game at one moment.
struct GameAt {
  double at = 0;                     // [s, clock of the truth]
  bool penalised = false;            // this robot
  bool moves = true;                 // ready, set or playing: nobody carries a robot that is not penalised
  bool plays = true;                 // playing
  int half = 0;                      // 0: not known
  std::optional<bool> attacks_plus;  // this side, towards +x of `field`
};

/// The direction of the upper camera at one moment.
struct HeadAt {
  double at = 0;          // [s, clock of the truth]
  double yaw = 0;         // [rad, robot] > 0 left
  double upper_edge = 0;  // [rad] of the image, below the horizon; < 0: above it
};

/// The truth at one moment.
struct TrueMoment {
  double at = 0;
  double x = 0, y = 0, heading = 0;  // [m, rad; field]; the heading is not NaN
  bool fallen = false;
  bool crowded = false;  // another robot is within 0.6 m and may push it
  double noise = 1;      // [0..1] share of the truth's variance in it: an interpolated one has less
};

struct WatchedMotion {
  std::string name;
  std::vector<OdometryAt> odometry;  // all in the order of the times
  std::vector<PoseAt> poses;
  std::vector<StatusAt> status;
  std::vector<GameAt> games;
  std::vector<HeadAt> heads;      // by camera_top_matrix
  std::vector<TrueMoment> truth;  // only moments with a heading
  double place_deviation = 0.02;  // [m] of the truth, each axis
  double clock_deviation = 0;     // [s]
  std::size_t damaged = 0;        // messages with numbers that are not finite or absurd
  bool is_simulated = false;      // its poses come from a simulator
};

/// The topics that a fit needs.
struct WatchedTopics {
  bool odometry = false, poses = false, heads = false;
};

/// Reads the motion of a robot. Numbers that are not finite, and absurd ones, are left out and counted.
WatchedMotion read_motion(const WatchedRobot& robot, const WatchedTopics& topics);

/// Returns the truth of a robot, without the moments that have no heading.
std::vector<TrueMoment> true_moments(const lab::Path& own, const lab::TruthRecord& record);

/// The truth at moments in order of their times: interpolated within pauses of up to a quarter of a second.
class TruthReader {
 public:
  explicit TruthReader(const std::vector<TrueMoment>& truth) : truth_(truth) {}

  /// Returns the truth at a moment [s], not before that of the last call, or nothing within a longer pause.
  std::optional<TrueMoment> at(double seconds);

 private:
  const std::vector<TrueMoment>& truth_;
  std::size_t next_ = 0;
};

/// Returns the last one of `items` at or before a moment, or null. `index` is that of the last call, at first 0.
template <class Item>
const Item* latest(const std::vector<Item>& items, double at, std::size_t& index) {
  while (index < items.size() && items[index].at <= at) ++index;
  return index == 0 ? nullptr : &items[index - 1];
}

}  // namespace robot::fit
