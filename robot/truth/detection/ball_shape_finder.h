// A ball of any colour in the depths of an image.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/truth/detection/ball_agreement.h"
#include "robot/truth/detection/ball_plane.h"
#include "robot/truth/detection/ground_grid.h"
#include "robot/truth/frame/detections.h"

namespace robot::truth {

/// A search for low things of a ball's size. The depths then decide whether a thing is a ball, and where.
/// Balls within 0.2 m of a standing robot or 0.4 m of a lying one are not found: its feet and hands look like balls.
class BallShapeFinder {
 public:
  BallShapeFinder(const SensorPose& pose, double ball_radius);

  /// Forgets the last image.
  void clear();

  /// Adds a pixel that shows something higher than the carpet and not higher than a ball.
  void add(int row, int column) { ++tiles_[tile(row / kTile, column / kTile)]; }

  /// Returns the most convincing ball among the pixels. The grid shows where people are.
  std::optional<SeenBall> find(const Sight& sight, const DepthFrame& frame, const GroundGrid& grid,
                               const std::vector<SeenRobot>& robots);

 private:
  /// Pixels are counted in tiles, which a ball at 5 m still fills.
  static constexpr int kTile = 4;  // [px]

  struct Candidate {
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    double filled = 0;  // low things per area of a ball's image
  };
  struct Match {
    Eigen::Vector2d pixel;
    BallAgreement agreement;
  };

  std::size_t tile(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  void collect(const Sight& sight, const GroundGrid& grid, const std::vector<SeenRobot>& robots);
  std::optional<Candidate> candidate_at(int row, int column) const;
  int count_around(int row, int column, int reach) const;
  void add(const Candidate& candidate);
  BallAgreement agreement(const Sight& sight, const DepthFrame& frame, const Eigen::Vector2d& pixel) const;
  std::optional<Match> best_match(const Sight& sight, const DepthFrame& frame, const Candidate& candidate) const;

  BallPlane plane_;
  int columns_, rows_;
  std::vector<std::uint16_t> tiles_;
  std::vector<Candidate> candidates_;
};

}  // namespace robot::truth
