// One image of one sensor changes the scene.
#pragma once

#include "robot/truth/tracks/assignment.h"
#include "robot/truth/tracks/own_poses.h"
#include "robot/truth/tracks/scene.h"

namespace robot::truth {

/// The filter of all things. Keeps only working memory, so its result depends on nothing but the arguments.
class Fusion {
 public:
  explicit Fusion(std::vector<Sensor> sensors) : sensors_(std::move(sensors)) {}

  const std::vector<Sensor>& sensors() const { return sensors_; }

  /// Takes an image into the scene. Its detections are usable (usable.h), its sensor exists, and it is not older than the
  /// scene. Adds the players of its tags to `poses`.
  void advance(TrackScene& scene, const SensorImage& image, OwnPoses& poses);

 private:
  enum class Rank { in_view, hidden, unconfirmed };
  static Rank rank_of(const TrackScene& scene, const RobotTrack& robot);

  void match(TrackScene& scene, const SensorImage& image, const OwnPoses& poses, Rank rank);
  void fill_costs(const TrackScene& scene, const SensorImage& image, const OwnPoses& poses);
  void leave_out_seen(const TrackScene& scene, const SensorImage& image);
  void add_robots(TrackScene& scene, const SensorImage& image, const OwnPoses& poses) const;

  std::vector<Sensor> sensors_;
  CostTable costs_;
  Assignment assignment_;
  std::vector<std::size_t> candidates_;  // indices of the robots to be matched
  std::vector<char> taken_;              // by detection: it is of a robot, or beside a robot that was seen
};

}  // namespace robot::truth
