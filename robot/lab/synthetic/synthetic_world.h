// The ground truth of the synthetic recording, as functions of the time since its start [s].
//
// Robot 14/2 walks a circle in its own half. 14/3 takes the kick-off and passes back, 14/2 shoots at kKick and scores;
// the referee puts the ball back to the centre. Other robots stand on the field. Frame `field`, which is also
// team_field of team 14. After kEnd nothing moves.
#pragma once

#include <optional>
#include <vector>

namespace robot::lab::synthetic {

inline float narrow(double value) { return static_cast<float>(value); }

inline constexpr double kReady = 1.5, kSet = 6, kPlaying = 7.5;  // [s] when the game changes to these states
inline constexpr double kKick = 11.5;                            // [s] 14/2 shoots
inline constexpr double kGoal = 15.5;                            // [s] the goal counts: ready again
inline constexpr double kTakenAway = 16.5, kPutBack = 17.5;      // [s] the ball, by the referee
inline constexpr double kSetAgain = 19.5, kEnd = 20;             // [s]

inline constexpr double kFieldLength = 9, kFieldWidth = 6;  // [m] of the rules since 2013, lines in the middle
inline constexpr double kBallRadius = 0.05;                 // [m]
inline constexpr double kGoalWidth = 1.5, kGoalHeight = 0.8, kPostRadius = 0.05;  // [m]

struct Point {
  double x = 0, y = 0;
};

/// Converts `p` to the frame with this origin and heading.
Point relative(Point p, Point origin, double heading);

/// Wraps an angle to (-π, π].
double normalised(double angle);

/// The pose and the motion of robot 14/2.
struct Walker {
  Point position;
  double heading = 0;    // [rad]
  double speed = 0;      // [m/s] forward
  double turn_rate = 0;  // [rad/s]
  double distance = 0;   // [m] walked so far
};
Walker walker_at(double t);

/// The true ball.
struct RollingBall {
  Point position, velocity;
  double rolled = 0;  // [m] since the last placement
};
/// Returns the ball, or nothing while the referee holds it.
std::optional<RollingBall> ball_at(double t);

/// A robot other than 14/2.
struct OtherRobot {
  int team = 0, player = 0;
  Point position;
  double heading = 0;
};
std::vector<OtherRobot> others_at(double t);

}  // namespace robot::lab::synthetic
