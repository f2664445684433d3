// How often robots with one walk fall, measured: by themselves, and when something pushes them.
#pragma once

#include <cmath>

#include "sim/math/vec2.h"

namespace sim::motion {

/// How a robot moves while it may fall by itself.
enum class Manner { standing, slow, ahead, fast, sideways, turning };

/// Returns the manner of a body that walks with this velocity [m/s, robot] over ground and turn rate [rad/s]. The limits are
/// in the middle of the speeds that tables are made of: 0.1, 0.2 and 0.25 m/s, and turning at 0.8 rad/s.
inline Manner manner_of(Vec2 velocity, float turn_rate) {
  const float ahead = std::fabs(velocity.x), aside = std::fabs(velocity.y);
  if (std::fabs(turn_rate) > 0.4f) return Manner::turning;
  if (aside > ahead) return Manner::sideways;
  if (ahead > 0.225f) return Manner::fast;
  return ahead > 0.15f ? Manner::ahead : Manner::slow;
}

/// Falls within a time.
struct FallRates {
  float per_minute[6];    // [1/min] alone, by Manner
  float shoved_standing;  // [1/min] while it touches another robot, if more
  float shoved_walking;   // [1/min] likewise while it walks

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("standing", self.per_minute[0], "1/min", 0.f, 600.f);
    see("slow", self.per_minute[1], "1/min", 0.f, 600.f);
    see("ahead", self.per_minute[2], "1/min", 0.f, 600.f);
    see("fast", self.per_minute[3], "1/min", 0.f, 600.f);
    see("sideways", self.per_minute[4], "1/min", 0.f, 600.f);
    see("turning", self.per_minute[5], "1/min", 0.f, 600.f);
    see("shoved_standing", self.shoved_standing, "1/min", 0.f, 600.f);
    see("shoved_walking", self.shoved_walking, "1/min", 0.f, 600.f);
  }
};

/// The pushes that topple a robot. The logarithm of the odds of a fall rises by `slope` with that of the impulse. A push to the
/// front comes from behind.
struct Toppling {
  float slope;
  float half[8];  // [N s] topples half of the robots; to the front, and each 45° further to the left

  /// Returns the probability [0..1] that a push of this impulse [N s], in any direction [robot], topples the robot.
  float probability(Vec2 impulse) const;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("slope", self.slope, "", 0.5f, 50.f);
    see("front", self.half[0], "N s", 0.1f, 100.f);
    see("front_left", self.half[1], "N s", 0.1f, 100.f);
    see("left", self.half[2], "N s", 0.1f, 100.f);
    see("back_left", self.half[3], "N s", 0.1f, 100.f);
    see("back", self.half[4], "N s", 0.1f, 100.f);
    see("back_right", self.half[5], "N s", 0.1f, 100.f);
    see("right", self.half[6], "N s", 0.1f, 100.f);
    see("front_right", self.half[7], "N s", 0.1f, 100.f);
  }
};

/// The way from the closing velocity of two robots that meet to the impulse that each gets.
struct CollisionModel {
  float mass;    // [kg] of a robot
  float bounce;  // [0..1] share of the closing velocity that they part with
  float soft;    // [0..1] share of the robots whose servos are soft

  /// Returns the impulse [N s] of two robots of this mass that close in with `velocity` [m/s].
  Vec2 impulse(Vec2 velocity) const { return 0.5f * mass * (1 + bounce) * velocity; }

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("mass", self.mass, "kg", 0.5f, 100.f);
    see("bounce", self.bounce, "", 0.f, 1.f);
    see("soft", self.soft, "", 0.f, 1.f);
  }
};

/// The falls of robots whose servos are alike.
struct ServoClass {
  FallRates rates;
  Toppling standing, walking;
};

/// The falls of all robots with one walk.
struct FallTable {
  bool given;  // false: there is none, and the rest does not count
  CollisionModel collisions;
  ServoClass stiff, soft;
};

}  // namespace sim::motion
