// Skills of a robot that does not have the ball.
#pragma once

#include "sim/agent/skills.h"
#include "sim/motion/command.h"

namespace sim::agent {

struct Position {
  float base = 0;  // share of the half field's length
  float follow_x = 0.5f;
  float x = 0;  // [m]
  float follow_y = 0.5f;
  float y = 0;            // [m]
  float spread = 1.2f;    // [m]
  float aside = 0;        // [m]
  float distance = 0.8f;  // [m]
  float gain = 1;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("base", self.base, Range{"", -1, 1}, "share of the half field, -1 at the own goal");
    see("follow_x", self.follow_x, Range{"", 0, 1}, "share of the ball's x");
    see("x", self.x, Range{"m", -8, 8}, "added to x");
    see("follow_y", self.follow_y, Range{"", -1, 1}, "share of the ball's y");
    see("y", self.y, lateral_range("m", 4), "added to y, to the left");
    see("spread", self.spread, Range{"m", 0, 5}, "between the lanes of robots of the same role");
    see("aside", self.aside, Range{"m", 0, 4}, "added to y, to the side of the ball on which the robot is");
    see("distance", self.distance, Range{"m", 0, 4}, "least distance from the ball");
    see("gain", self.gain, kGainRange, "share of the greatest speed");
  }
};
/// Returns the place of the ball [m, team_field]: believed, last remembered, or the middle.
Vec2 supposed_ball(const View& view);

/// x = base·half length + follow_x·ball x + x, y = follow_y·ball y + y + spread·lane ± aside, kept inside the field and
/// away from the ball; faces the ball. It stays there until the place is Habits.walk_again off.
motion::Command position(const View& view, Mind& mind, const Position& with);

struct Block {
  float share = 0.5f;
  float distance = 0.6f;  // [m]
  float from_goal = 0;    // [m]
  float spread = 0.8f;    // [m]
  float gain = 1;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("share", self.share, Range{"", 0.05f, 0.95f}, "of the way from the goal to the ball");
    see("distance", self.distance, Range{"m", 0, 4}, "least distance from the ball");
    see("from_goal", self.from_goal, Range{"m", 0, 4}, "least distance from the own goal");
    see("spread", self.spread, Range{"m", 0, 5}, "between the lanes of robots of the same role");
    see("gain", self.gain, kGainRange, "share of the greatest speed");
  }
};
/// Stands on the line from the own goal to the ball, until it is Habits.walk_again off. Several robots stand side by
/// side across it, closer together in front of the goal.
motion::Command block(const View& view, Mind& mind, const Block& with);

struct KeepGoal {
  float radius = 0.5f;        // [m]
  float step = 0.25f;         // [m]
  float squat_time = 0.8f;    // [s]
  float squat_reach = 0.32f;  // [m]

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("radius", self.radius, Range{"m", 0.1f, 3}, "of the arc round the goal's middle");
    see("step", self.step, Range{"m", 0.03f, 1}, "off its place before a keeper that stood there moves");
    see("squat_time", self.squat_time, Range{"s", 0, 3}, "before a ball passes, to squat; 0: never");
    see("squat_reach", self.squat_reach, Range{"m", 0, 1},
        "squats when the ball passes within this distance of the feet");
  }
};
/// Stands on the arc between ball and goal and faces the ball. Steps sideways to a ball that rolls towards the goal.
/// Squats when that ball passes within `squat_time` and `squat_reach`.
motion::Command keep_goal(const View& view, Mind& mind, const KeepGoal& with);

/// Goes to the robot's place for the kick-off: inside the own half, and outside the circle unless it kicks off.
motion::Command get_ready(const View& view);
/// Returns that place [m, team_field].
Vec2 ready_place(const View& view);

}  // namespace sim::agent
