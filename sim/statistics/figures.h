// The figures by which real and simulated games are compared.
#pragma once

#include <limits>

#include "sim/statistics/window.h"

namespace sim::statistics {

/// The figures of one window. NaN: not measured, because the window has nothing to measure it by.
struct Figures {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double kicks = kNone, fast_kicks = kNone, fast_kick_share = kNone;
  double roll_median = kNone, roll_90 = kNone;
  double ball_fast = kNone, ball_speed = kNone, ball_still = kNone;
  double displacement_10 = kNone, displacement_30 = kNone;
  double nearest = kNone, second = kNone, third = kNone;
  double nobody_1m = kNone, both_60cm = kNone, both_1m = kNone;
  double mates = kNone, close = kNone, extent_x = kNone, extent_y = kNone;
  double middle = kNone;
  double standing = kNone, walking_median = kNone, walking_99 = kNone, walked = kNone;
  double falls = kNone, down = kNone;

  /// Calls see(key, value, unit, about) for each figure, in the order of reports.
  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("kicks", self.kicks, "1/min", "kicks above 0.5 m/s");
    see("fast_kicks", self.fast_kicks, "1/min", "kicks above 1 m/s");
    see("fast_kick_share", self.fast_kick_share, "", "share of kicks above 1 m/s");
    see("roll_median", self.roll_median, "m", "roll of a kick, median");
    see("roll_90", self.roll_90, "m", "roll of a kick, 90 %");
    see("ball_fast", self.ball_fast, "", "ball faster than 0.5 m/s, share of time");
    see("ball_speed", self.ball_speed, "m/s", "mean speed of the ball");
    see("ball_still", self.ball_still, "", "ball still for more than 10 s, share of time");
    see("displacement_10", self.displacement_10, "m", "displacement of the ball after 10 s");
    see("displacement_30", self.displacement_30, "m", "displacement of the ball after 30 s");
    see("nearest", self.nearest, "m", "distance of the nearest robot to the ball");
    see("second", self.second, "m", "distance of the second robot to the ball");
    see("third", self.third, "m", "distance of the third robot to the ball");
    see("nobody_1m", self.nobody_1m, "", "nobody within 1 m of the ball");
    see("both_60cm", self.both_60cm, "", "both sides within 0.6 m of the ball");
    see("both_1m", self.both_1m, "", "both sides within 1 m of the ball");
    see("mates", self.mates, "m", "mean distance between team mates");
    see("close", self.close, "", "another robot within 0.5 m, share of robots");
    see("extent_x", self.extent_x, "m", "extent of the field players in x");
    see("extent_y", self.extent_y, "m", "extent of the field players in y");
    see("middle", self.middle, "", "ball within 1.5 m of the middle line");
    see("standing", self.standing, "", "robots standing, share");
    see("walking_median", self.walking_median, "m/s", "walking speed, median");
    see("walking_99", self.walking_99, "m/s", "walking speed, 99 %");
    see("walked", self.walked, "m/min", "walked by a robot");
    see("falls", self.falls, "1/min", "falls of a robot");
    see("down", self.down, "", "share of robots on the ground");
  }
};

/// Measures a window. A mirrored field and swapped sides give the same figures.
Figures measure(const Window& window);

}  // namespace sim::statistics
