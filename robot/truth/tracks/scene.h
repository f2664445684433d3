// All tracks at one moment.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/truth/tracks/ball_paths.h"
#include "robot/truth/tracks/fused_truth.h"
#include "robot/truth/tracks/own_poses.h"
#include "robot/truth/tracks/posture.h"
#include "robot/truth/tracks/sightings.h"

namespace robot::truth {

/// Most tracks of robots at a time, with those that are not confirmed yet.
constexpr std::size_t kMostRobots = 32;

struct RobotTrack {
  Sightings sightings;
  Estimate estimate;  // at the scene's time
  Posture posture;
  std::optional<double> heading, heading_deviation;  // [rad] of the newest tag
  std::uint64_t heading_ns = 0;
  std::array<double, kMostPlayers> evidence{};  // logarithm: it is this player / this player is nowhere here
};

struct BallTrack {
  Sightings sightings;
  BallPaths paths;
  std::uint64_t paths_ns = 0;  // their time: of the newest measurement, also of one that shows something else
  Measurement measurement;     // that one
};

/// A player whose own poses or tags are known.
struct KnownPlayer {
  std::uint32_t team = 0, number = 0;
  std::uint32_t robot = 0;  // serial of the robot that it is; 0: not known
};

/// All tracks at one moment. A plain value: a copy is a state to which a tracker can return. Bounded memory.
struct TrackScene {
  std::uint64_t now_ns = 0;                                    // of the newest image; 0: none yet
  double interval = 0;                                         // [s] between the newest two images of its sensor
  std::array<std::uint64_t, kMostSensors> image_ns{};          // newest image of each sensor; 0: none
  std::array<std::uint64_t, kMostSensors> detected_ns{};       // the end of its detection
  std::vector<RobotTrack> robots;                              // at most kMostRobots, the oldest first
  std::optional<BallTrack> ball, new_ball;                     // the new one is not confirmed yet
  std::vector<KnownPlayer> players;                            // in the order of OwnPoses
  std::uint32_t serials = 0, robots_born = 0, balls_born = 0;  // counts
};

/// Returns an empty scene that goes on with the numbers of this one.
TrackScene restarted(const TrackScene& scene);

/// Returns the truth of the scene: all confirmed things that the newest image of a sensor shows, if that image is at most
/// 0.1 s old. They are moved on to the time of the newest image.
FusedTruth truth_of(const TrackScene& scene);

/// Reports whether the newest image of a sensor shows the thing, and that image is at most 0.1 s old.
bool visible(const TrackScene& scene, const Sightings& sightings);

FusedPlace place_of(const Estimate& estimate, std::uint32_t track, std::uint32_t sensors);
FusedRobot report_of(const TrackScene& scene, const RobotTrack& robot);
FusedBall report_of(const TrackScene& scene, const BallTrack& ball);

}  // namespace robot::truth
