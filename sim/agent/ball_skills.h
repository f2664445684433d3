// Skills of a robot that has the ball or goes to it. On the way to the own set play its head scans the way.
#pragma once

#include <cstdint>

#include "sim/agent/kick_choice.h"
#include "sim/agent/skills.h"
#include "sim/agent/target.h"
#include "sim/motion/command.h"

namespace sim::agent {

// parameters that several skills have
inline constexpr Range kToleranceRange{"rad", 0.01f, 3};
inline constexpr Range kReachRange{"m", 0, 12};
inline constexpr Range kCareRange{"", 0.2f, 2};
inline constexpr Range kFramesRange{"decisions", 1, 30};

/// Lists the arguments that may stand for the aim.
template <class AnyWhere, class See>
constexpr void see_target(AnyWhere& to, See&& see) {
  see("direction", to.direction, kDirectionRange, kDirectionAbout);
  see("target_x", to.x, kTargetX, kTargetAbout);
  see("target_y", to.y, kTargetY, kTargetAbout);
}

struct WalkToBall {
  Where to;
  float tolerance = 0.2f;  // [rad]
  float distance = 0.3f;   // [m]
  float gain = 1;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("aim", self.to.aim, kAimRange, "where the ball shall go");
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("distance", self.distance, Range{"m", 0.15f, 3}, "from the ball");
    see("gain", self.gain, kGainRange, "share of the greatest speed");
    see_target(self.to, see);
  }
};
/// Goes to `distance` behind the ball as seen from the aim, round the ball without touching it.
motion::Command walk_to_ball(const View& view, Mind& mind, const WalkToBall& with);

struct Align {
  Where to;
  float tolerance = 0.05f;  // [rad]
  float range = 3;          // [m]
  KickChoice kick = KickChoice::front;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("aim", self.to.aim, kAimRange, "where the ball shall go");
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("range", self.range, kReachRange, "the kick carries this far, or it is the longest");
    see("kick", self.kick, kKickRange, kKickAbout);
    see_target(self.to, see);
  }
};
/// Goes to the place from which a kick sends the ball to the aim.
motion::Command align(const View& view, Mind& mind, const Align& with);

struct Kick {
  Where to;
  float tolerance = 0.2f;  // [rad]
  float range = 3;         // [m]
  float care = 1;
  float frames = 1;  // [decisions]
  KickChoice kick = KickChoice::front;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("aim", self.to.aim, kAimRange, "where the ball shall go");
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("range", self.range, kReachRange, "the kick carries this far, or it is the longest");
    see("care", self.care, kCareRange, "factor on the gate of the kick in which the ball must lie");
    see("frames", self.frames, kFramesRange, "decisions in a row in which the ball must lie there");
    see("kick", self.kick, kKickRange, kKickAbout);
    see_target(self.to, see);
  }
};
/// Aligns for the chosen kick. Kicks once the ball lies in its gate and would go to the aim.
/// The robot goes no farther round the ball than the tolerance requires.
motion::Command kick(const View& view, Mind& mind, const Kick& with);

/// The opponents round which the ball is driven.
enum class Past : std::uint8_t { nobody, nearest };
inline constexpr const char* kPasts[] = {"nobody", "nearest", nullptr};  // by Past
inline constexpr Range kPastRange{.unit = "", .least = 0, .most = 1, .names = kPasts, .example = R"("nearest")"};

struct Dribble {
  Where to;
  float tolerance = 0.3f;  // [rad]
  float gain = 1;
  Past past = Past::nobody;
  float room = 0.4f;  // [m] half a robot, the ball and some space

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("aim", self.to.aim, kAimRange, "where the ball shall go");
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("gain", self.gain, kGainRange, "share of the greatest speed");
    see("past", self.past, kPastRange, "nearest: drives the ball round the nearest opponent in the way");
    see("room", self.room, Range{"m", 0.2f, 1.5f}, "from the middle of that opponent to the way of the ball");
    see_target(self.to, see);
  }
};
/// Goes behind the ball, then walks on through it. With Past::nearest the way of the ball misses the nearest opponent in
/// front of it by `room`.
motion::Command dribble(const View& view, Mind& mind, const Dribble& with);

struct Pass {
  Where to{.aim = Aim::mate};
  float tolerance = 0.15f;  // [rad]
  float lead = 0.4f;        // [m]
  float care = 1;
  float frames = 1;  // [decisions]
  KickChoice kick = KickChoice::front;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("tolerance", self.tolerance, kToleranceRange, "angle by which the direction of the ball may miss the aim");
    see("lead", self.lead, Range{"m", -1, 3}, "in front of the teammate");
    see("care", self.care, kCareRange, "factor on the gate of the kick in which the ball must lie");
    see("frames", self.frames, kFramesRange, "decisions in a row in which the ball must lie there");
    see("kick", self.kick, kKickRange, kKickAbout);
    see_target(self.to, see);
  }
};
/// Kicks to the best free teammate, or straight ahead when there is none; or to the given point or in the given
/// direction. The kick carries as far as the target is, 1 m in a direction.
motion::Command pass(const View& view, Mind& mind, const Pass& with);

}  // namespace sim::agent
