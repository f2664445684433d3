// Robots around the ball, and the room between robots.
#pragma once

#include "sim/statistics/window.h"

namespace sim::statistics {

/// Robots near the ball, over all frames with a ball.
struct NearBall {
  double nearest, second, third;  // [m] median distance of the nearest robots
  double nobody_1m;               // share of time without a robot within 1 m
  double both_60cm, both_1m;      // share of time with robots of both sides this near
};
NearBall near_ball(const Window& window, const Path& smooth);

/// The room between robots, over every tenth frame.
struct Room {
  double mates;               // [m] mean distance between the robots of a side, if at least three are seen
  double close;               // share of robots with another one within 0.5 m
  double extent_x, extent_y;  // [m] mean extent of a side's field players, if at least three are seen
};
Room room_between(const Window& window);

}  // namespace sim::statistics
