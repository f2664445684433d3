// Errors and counts of detections on synthetic images, for the benches of ground truth.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "robot/truth/frame/detections.h"
#include "robot/truth/frame/sensor_pose.h"
#include "robot/truth/synthetic/renderer.h"
#include "robot/truth/synthetic/scene.h"

namespace bench {

/// Errors and counts of the things of one kind.
struct TruthTally {
  int there = 0, found = 0, wrong = 0;
  std::vector<double> errors;   // [m] within 5 m
  std::vector<double> squares;  // normalised; 2 on average when the covariances are honest

  void add(const robot::truth::Place& place, const Eigen::Vector2d& truth, bool near);

  nlohmann::json figures(int frames) const;
};

/// The score of a detector over a series of images.
struct TruthScore {
  TruthTally standing, lying, ball;
  std::vector<double> milliseconds;

  void add_robots(const robot::truth::Scene& scene, const robot::truth::SensorPose& pose,
                  std::vector<robot::truth::SeenRobot> seen);
  void add_ball(const robot::truth::SceneBall& truth, bool visible, const robot::truth::SensorPose& pose,
                const std::optional<robot::truth::SeenBall>& seen);

  nlohmann::json figures(int frames) const;
};

/// Reports whether at least 70 % of the ball's image is not hidden, in the renderer's last image.
bool visible(const robot::truth::Renderer& renderer, const robot::truth::SceneBall& ball);

}  // namespace bench
