// Rebounds and pushes: touches that say how a ball leaves a robot or a goal post.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/fit/rebounds/touches.h"

namespace robot::fit {

/// A rebound off a thing that stands, along the line from its middle to the ball.
struct Rebound {
  std::size_t recording = 0;
  double at = 0;                               // [s]
  double in = 0, out = 0;                      // [m/s] normal speed before and after
  double across = 0;                           // [m/s] speed across the line, before
  double in_deviation = 0, out_deviation = 0;  // [m/s]
  double gap = 0;                              // [m] from the middle of the thing to that of the ball
  double gap_deviation = 0;                    // [m]
};

/// A push: a robot walks into the ball. The ball's direction turns from the one that a smooth foot would give it.
struct Push {
  std::size_t recording = 0;
  double at = 0;                // [s]
  double own = 0;               // [m/s] the robot's speed towards the ball
  double in = 0;                // [m/s] of the ball before it, towards the robot
  double speed = 0;             // [m/s] of the ball after it
  double turn = 0;              // [rad] from the direction of a smooth foot to that of the ball
  double deviation = 0;         // [rad] of the turn, by the errors of the velocities
  double lever = 1;             // error of the turn by an error of the line from the robot to the ball
  double least = -1, most = 1;  // [rad] turns beyond these are bent back: the foot follows the ball
  double gap = 0;               // [m] between the middles
};

/// The sizes and factors by which touches are sorted.
struct ContactFacts {
  double robot_reach = 0.15;  // [m] between the middles of a robot and a ball that touch
  double ball_radius = 0.05;  // [m]
  double robot_restitution = 0.4;
};

/// Returns the scatter [m] of the distances at which things touched the ball: one standard deviation, 0 for fewer than two.
double gap_scatter(std::vector<double> gaps);

/// Returns the rebounds off robots that stand. The ball comes in at 0.4 m/s or more and within 50° of the line. It touches the
/// robot where `facts` expect it, within 0.1 m, and where most others do. No other robot is within 0.35 m.
std::vector<Rebound> robot_rebounds(const std::vector<Touch>& touches, const ContactFacts& facts);

/// Returns the pushes by robots that walk at 0.1 m/s or more towards the ball and meet it at 0.2 m/s or more. Their restitution is
/// that of `facts`. A ball that is faster or slower by more than 0.15 m/s than after such a push was kicked or held.
std::vector<Push> pushes(const std::vector<Touch>& touches, const ContactFacts& facts);

/// The goals of a field.
struct Goals {
  const char* field;
  double length, width, post_radius;  // [m] between the goal lines, between the middles of the posts
};

/// The rebounds off the posts of the field that explains most of them.
struct PostRebounds {
  Goals goals{};
  std::vector<Rebound> rebounds;
};

/// Returns the rebounds off goal posts, far from robots. The truth does not contain the field: of the known ones, that with most
/// rebounds off its posts counts.
PostRebounds post_rebounds(const std::vector<Touch>& touches, const ContactFacts& facts);

}  // namespace robot::fit
