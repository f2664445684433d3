// Skills of whoever has not got the ball.
#pragma once

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

struct Position {
  float base;  // share of the half field's length
  float follow_x;
  float x;  // [m]
  float follow_y;
  float y;         // [m] lateral
  float spread;    // [m]
  float distance;  // [m]
  float gain;
};
/// x = base·half length + follow_x·ball x + x, y = follow_y·ball y + y + spread·lane, kept inside the field and away
/// from the ball; faces the ball.
motion::Command position(const View& view, const Position& with);

struct Block {
  float share;
  float distance;  // [m]
  float spread;    // [m]
  float gain;
};
/// On the line from the own goal to the ball; several stand beside each other across it.
motion::Command block(const View& view, const Block& with);

struct KeepGoal {
  float radius;       // [m]
  float step;         // [m]
  float squat_time;   // [s]
  float squat_reach;  // [m]
};
/// On the arc between ball and goal, facing the ball; where the ball rolls past, to where it will pass, and squats to block
/// it there when it passes within `squat_time` and `squat_reach`.
motion::Command keep_goal(const View& view, const KeepGoal& with);

/// The robot's place for the kick-off: inside the own half, and outside the circle unless it kicks off.
motion::Command get_ready(const View& view);
/// [m, team_field] that place.
Vec2 ready_place(const View& view);

}  // namespace sim::agent
