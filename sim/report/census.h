// What robots believe and do, beside what is so: how far apart these are over a game.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/match/state.h"

namespace sim::report {

/// A mean that grows, each value with its weight.
class Average {
 public:
  void add(double value, double weight = 1) { sum_ += weight * value, weight_ += weight; }
  /// 0 of nothing.
  double mean() const { return weight_ == 0 ? 0 : sum_ / weight_; }

 private:
  double sum_ = 0, weight_ = 0;
};

/// Of one side's robots while the ball is in play. A robot that decides once for several ticks counts for so many.
class Census {
 public:
  /// Is shown the state before each step.
  void look(const State& state);

  /// The figures of a side by name, SI units.
  nlohmann::ordered_json of(Side side) const;

 private:
  struct Figures {
    Average ball_error;         // [m] of a ball in view
    Average moving_ball_error;  // [m] likewise, of one faster than 0.5 m/s
    Average ball_astray;        // share of what is taken for the ball in view, 0.5 m off or more, 10° beside it
    Average pose_error;         // [m]
    Average flipped;            // share of time in which the field is believed turned round
    Average news_age;           // [s] of what the mates told last
    Average speed;              // [m/s] while walking
    Average shifting;           // share of time between standing and walking
    Average down;               // share of time on the ground
    Average kick_astray;        // [rad] between where a kicked ball should go and does
    Average push_astray;        // [rad] between where a lying ball that is walked into lies from the robot and goes
  };

  void look_at(const State& state, int robot, Figures& figures) const;
  void look_at_ball(const State& state);

  World before_;  // the world that the last decisions were made in
  Figures figures_[2];
};

}  // namespace sim::report
