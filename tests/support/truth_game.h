// A game of robots and a ball for the tests of ground truth, as sensors beside the field would detect it. Deterministic.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <vector>

#include "robot/truth/tracks/own_poses.h"
#include "robot/truth/tracks/sensor.h"

namespace test {

/// Random numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) + 0.5) / 4294967296.;
  }
  double normal();  // mean 0, deviation 1
  Eigen::Vector2d normal2() {
    const double x = normal();
    return {x, normal()};
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }

 private:
  std::mt19937 engine_;
};

/// One thing that moves.
struct Mover {
  Eigen::Vector2d position = Eigen::Vector2d::Zero(), velocity = Eigen::Vector2d::Zero();  // [m, m/s]
};

/// Eight Naos chase each other, points and the ball on 6 m x 4 m. They come as close as 0.3 m; one that has the ball kicks it.
class TruthGame {
 public:
  explicit TruthGame(std::uint32_t seed);
  void step();  // 1/30 s

  const std::vector<Mover>& robots() const { return robots_; }
  const Mover& ball() const { return ball_; }
  double since_kick() const { return since_kick_; }  // [s]
  double time() const { return time_; }              // [s]

  static constexpr double kStep = 1. / 30;  // [s]

 private:
  void choose_target(std::size_t robot);
  std::size_t striker(std::size_t team) const;
  Eigen::Vector2d target_of(std::size_t robot) const;
  void move_robots();
  void keep_apart();
  void move_ball();

  struct Plan {
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
    std::size_t chased = 0;  // a robot, or kPoint
    double until = 0;        // [s]
    double speed = 0.3;      // [m/s]
  };
  Random random_;
  std::vector<Mover> robots_;
  std::vector<Plan> plans_;
  Mover ball_;
  double since_kick_ = 100, time_ = 0;
};

/// A sensor that watches the game.
struct Watcher {
  Eigen::Vector2d place{0, -4};                                 // [m] its mast
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();             // [m] error of its pose
  double robot_noise = 0.02, ball_noise = 0.01;                 // [m]
  double misses = 0.02, false_robots = 0.02;                    // probability, mean count in an image
  bool occlusions = true;                                       // a robot behind another one is hidden, for up to 2 s
  std::vector<double> hidden_for = std::vector<double>(8, 0.);  // [s]

  robot::truth::Detections look(const TruthGame& game, std::uint64_t capture_ns, Random& random);
};

/// The localisation of the robots: it drifts by 0.15 m, and now and then it is on the wrong half for some seconds.
class Localisation {
 public:
  explicit Localisation(std::uint32_t seed) : random_(seed), errors_(8, Eigen::Vector2d::Zero()), flipped_for_(8, 0.) {}
  /// Returns the own poses of all robots after one more step of the game. Robots 0 to 3 are of team 1, the others of 2.
  std::vector<robot::truth::OwnPose> poses(const TruthGame& game, std::uint64_t capture_ns);

 private:
  Random random_;
  std::vector<Eigen::Vector2d> errors_;
  std::vector<double> flipped_for_;  // [s]
};

}  // namespace test
