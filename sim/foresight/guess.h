// Where ball and robots most likely are, and how sure that is, by what one robot knows.
#pragma once

#include <cmath>

#include "sim/foresight/situation.h"

namespace sim::foresight {

/// Frame: team_field.
struct BallGuess {
  Vec2 position;                 // [m]
  Vec2 velocity;                 // [m/s]
  float deviation = 0;           // [m] along each axis
  float velocity_deviation = 0;  // [m/s]
  float elsewhere = 0;           // [0..1] how likely it is not there at all: somebody kicked it, or the referee put it
  Tick seen = kNever;            // kNever: by nobody
  bool by_own_eyes = false;      // then the own pose's error comes on top
};

/// Beyond the middle of a line. Frame: field or team_field.
inline bool beyond_lines(const field::Field& field, Vec2 point) {
  return std::abs(point.x) > field.length / 2 || std::abs(point.y) > field.width / 2;
}

/// By its own eyes while they are fresh, else by the newest report. Who knows it less surely the longer ago it was, and
/// where it seems to be out.
BallGuess guess_ball(const field::Field& field, const Knowledge& knowledge);

/// Frame: team_field.
struct RobotGuess {
  Pose2 pose;
  float deviation = 0;          // [m] along each axis
  float deviation_heading = 0;  // [rad]
};

/// The robot itself by its localisation, a teammate by what it told, an opponent by when it was seen; of whom nothing
/// is known, by where its side stands while the ball is at `ball`.
RobotGuess guess_robot(const Params& params, const Knowledge& knowledge, Vec2 ball, int robot);

}  // namespace sim::foresight
