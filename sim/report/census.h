// Beliefs and actions of robots compared with the truth over a game.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/match/state.h"

namespace sim::report {

/// A running weighted mean.
class Average {
 public:
  void add(double value, double weight = 1) { sum_ += weight * value, weight_ += weight; }
  /// Returns 0 without values.
  double mean() const { return weight_ == 0 ? 0 : sum_ / weight_; }

 private:
  double sum_ = 0, weight_ = 0;
};

/// The figures of each side's robots while the ball is in play. A robot that decides once for several ticks counts for all
/// of them.
class Census {
 public:
  /// Takes the state before each step.
  void look(const State& state);

  /// Returns the figures of a side by name, in SI units.
  nlohmann::ordered_json of(Side side) const;

 private:
  struct Figures {
    Average ball_error;         // [m] for a ball in view
    Average moving_ball_error;  // [m] the same, for a ball faster than 0.5 m/s
    Average ball_astray;        // share of balls in view that are at least 0.5 m away and 10° off the true ball
    Average pose_error;         // [m]
    Average flipped;            // share of time with the field believed turned around
    Average news_age;           // [s] age of the teammates' last messages
    Average speed;              // [m/s] while walking
    Average shifting;           // share of time between standing and walking
    Average down;               // share of time on the ground
    Average kick_astray;        // [rad] between wanted and true direction of a kicked ball
    Average push_astray;        // [rad] between the direction to a lying ball that is walked into and its motion
  };

  void look_at(const State& state, int robot, Figures& figures) const;
  void look_at_ball(const State& state);

  World before_;  // the world of the last decisions
  Figures figures_[2];
};

}  // namespace sim::report
