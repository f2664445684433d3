// Skills of a robot that has the ball or goes to it.
#pragma once

#include <cstdint>

#include "sim/agent/skills.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// The target of the ball.
enum class Aim : std::uint8_t {
  goal,     // the middle of the opponents' goal
  opening,  // the middle of the widest gap in it; the wider it is, the less exactly
  ahead,    // straight towards the opponents' goal line
  away,     // from the own goal
  mate,     // the free teammate nearest to the goal, ahead of it; without one, ahead
  cross,    // the penalty mark before the goal
};
inline constexpr const char* kAims[] = {"goal", "opening", "ahead", "away", "mate", "cross", nullptr};  // by Aim

// parameters that several skills have
inline constexpr Range kAimRange{"", 0, 5, false, kAims};
inline constexpr Range kToleranceRange{"rad", 0.01f, 3};
inline constexpr Range kKickRange{"m", 0, 12};
inline constexpr Range kCareRange{"", 0.2f, 2};
inline constexpr Range kFramesRange{"decisions", 1, 30};

struct WalkToBall {
  Aim aim = Aim::opening;
  float tolerance = 0.2f;  // [rad]
  float distance = 0.3f;   // [m]
  float gain = 1;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("aim", self.aim, kAimRange, "where the ball shall go");
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("distance", self.distance, Range{"m", 0.15f, 3}, "from the ball");
    see("gain", self.gain, kGainRange, "share of the greatest speed");
  }
};
/// Goes to `distance` behind the ball as seen from the aim, round the ball without touching it.
motion::Command walk_to_ball(const View& view, Mind& mind, const WalkToBall& with);

struct Align {
  Aim aim = Aim::opening;
  float tolerance = 0.05f;  // [rad]
  float range = 3;          // [m]

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("aim", self.aim, kAimRange, "where the ball shall go");
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("range", self.range, kKickRange, "the quickest kick that carries this far, otherwise the longest");
  }
};
/// Goes to the place from which a kick sends the ball to the aim.
motion::Command align(const View& view, Mind& mind, const Align& with);

struct Kick {
  Aim aim = Aim::opening;
  float tolerance = 0.2f;  // [rad]
  float range = 3;         // [m]
  float care = 1;
  float frames = 1;  // [decisions]

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("aim", self.aim, kAimRange, "where the ball shall go");
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("range", self.range, kKickRange, "the quickest kick that carries this far, otherwise the longest");
    see("care", self.care, kCareRange, "factor on the gate of the kick in which the ball must lie");
    see("frames", self.frames, kFramesRange, "decisions in a row in which the ball must lie there");
  }
};
/// Aligns with the leg nearer to the ball. Kicks once the ball lies in the gate and the robot faces the aim.
/// The robot goes no farther round the ball than the tolerance requires.
motion::Command kick(const View& view, Mind& mind, const Kick& with);

struct Dribble {
  Aim aim = Aim::opening;
  float tolerance = 0.3f;  // [rad]
  float gain = 1;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("aim", self.aim, kAimRange, "where the ball shall go");
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("gain", self.gain, kGainRange, "share of the greatest speed");
  }
};
/// Goes behind the ball, then walks on through it.
motion::Command dribble(const View& view, Mind& mind, const Dribble& with);

struct Pass {
  float tolerance = 0.15f;  // [rad]
  float lead = 0.4f;        // [m]
  float care = 1;
  float frames = 1;  // [decisions]

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("lead", self.lead, Range{"m", -1, 3}, "in front of the teammate");
    see("care", self.care, kCareRange, "factor on the gate of the kick in which the ball must lie");
    see("frames", self.frames, kFramesRange, "decisions in a row in which the ball must lie there");
  }
};
/// Kicks to the best free teammate, or straight ahead when there is none.
motion::Command pass(const View& view, Mind& mind, const Pass& with);

}  // namespace sim::agent
