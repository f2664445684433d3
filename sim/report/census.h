// Errors of the robots' beliefs and actions over a game, measured against the true state.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/match/state.h"

namespace sim::report {

/// A weighted mean of values that are added one by one.
class Average {
 public:
  void add(double value, double weight = 1) { sum_ += weight * value, weight_ += weight; }
  /// Returns the mean, or 0 without values.
  double mean() const { return weight_ == 0 ? 0 : sum_ / weight_; }

 private:
  double sum_ = 0, weight_ = 0;
};

/// Figures of each side's robots while the ball is in play. A decision that holds for several ticks has this number as
/// its weight.
class Census {
 public:
  /// Adds a state. Call it before each step.
  void look(const State& state);

  /// Returns the figures of a side by name, in SI units.
  nlohmann::ordered_json of(Side side) const;

 private:
  struct Figures {
    Average ball_error;         // [m] error of the position of a ball in view
    Average moving_ball_error;  // [m] likewise, of one faster than 0.5 m/s
    Average ball_astray;        // share of images with the ball 0.5 m away or more that place it more than 10° off
    Average pose_error;         // [m]
    Average flipped;            // share of time in which the robot believes the field turned by 180°
    Average news_age;           // [s] age of the mates' last packets
    Average speed;              // [m/s] while walking
    Average shifting;           // share of time between standing and walking
    Average down;               // share of time on the ground
    Average kick_astray;        // [rad] between the intended and the true direction of a kicked ball
    Average push_astray;        // [rad] between the bearing of a lying ball and its way when a walk pushes it
  };

  void look_at(const State& state, int robot, Figures& figures) const;
  void look_at_ball(const State& state);

  World before_;  // the world of the last decisions
  Figures figures_[2];
};

}  // namespace sim::report
