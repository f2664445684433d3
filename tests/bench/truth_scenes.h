// Random scenes for the bench of ground truth.
#pragma once

#include <random>

#include "robot/truth/frame/sensor_pose.h"
#include "robot/truth/synthetic/scene.h"

namespace bench {

/// Scenes that a sensor sees. The sequence is the same on all machines.
class TruthScenes {
 public:
  TruthScenes(const robot::truth::SensorPose& pose, double ball_radius, robot::truth::BallColour colour)
      : pose_(pose), ball_radius_(ball_radius), colour_(colour) {}

  /// Returns a scene with five robots, of which one of 20 lies, a ball off their feet, and a referee at the far touch line.
  robot::truth::Scene next();

  /// Returns a number from `least` to `most`.
  double uniform(double least, double most);
  /// Returns a number of mean 0 and deviation 1, nearly normal.
  double normal();

 private:
  robot::truth::SceneRobot robot();
  robot::truth::SceneBall ball(const robot::truth::Scene& scene);
  bool in_view(double x, double y, double height) const;

  robot::truth::SensorPose pose_;
  double ball_radius_;
  robot::truth::BallColour colour_;
  std::mt19937 random_{1};
};

}  // namespace bench
