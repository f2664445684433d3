// How often robots with one walk fall, measured: by themselves, and when something pushes them. And how they get up.
#pragma once

#include <cmath>

#include "sim/math/vec2.h"
#include "sim/world/body.h"

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

/// The side that robots are down on after a fall by themselves. The others lie on the left or the right.
struct FallsAlone {
  float front;  // [0..1] share
  float back;   // [0..1] likewise

  /// Returns how a robot lies, by a number in [0, 1).
  Lying lying(float drawn) const {
    if (drawn < front) return Lying::on_front;
    if (drawn < front + back) return Lying::on_back;
    return drawn < 0.5f * (1 + front + back) ? Lying::on_left : Lying::on_right;
  }

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("front", self.front, "", 0.f, 1.f);
    see("back", self.back, "", 0.f, 1.f);
  }
};

/// Getting up. An attempt that fails takes as long as one that does not, and the robot lies again.
struct GettingUp {
  float lying;                                      // [s] before each attempt
  float back, front, side;                          // [s] an attempt of a robot that is down on it
  float back_failure, front_failure, side_failure;  // [0..1] probability that it fails

  float seconds(Lying down) const { return of(down, back, front, side); }
  float failure(Lying down) const { return of(down, back_failure, front_failure, side_failure); }

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("lying", self.lying, "s", 0.f, 30.f);
    see("back", self.back, "s", 0.f, 60.f);
    see("front", self.front, "s", 0.f, 60.f);
    see("side", self.side, "s", 0.f, 60.f);
    see("back_failure", self.back_failure, "", 0.f, 0.95f);
    see("front_failure", self.front_failure, "", 0.f, 0.95f);
    see("side_failure", self.side_failure, "", 0.f, 0.95f);
  }

 private:
  static float of(Lying down, float on_back, float on_front, float on_side) {
    return down == Lying::on_back ? on_back : down == Lying::on_front ? on_front : on_side;
  }
};

/// The falls of robots whose servos are alike.
struct ServoClass {
  FallRates rates;
  Toppling standing, walking;
  GettingUp getting_up;
};

/// The falls of all robots with one walk.
struct FallTable {
  bool given;  // false: there is none, and the rest does not count
  CollisionModel collisions;
  FallsAlone alone;
  ServoClass stiff, soft;

  /// Returns the time [s] from a fall alone until the robot stands, if its first attempt succeeds: the mean.
  float usual_time() const;
};

/// Returns how a robot lies that was pushed in this direction [robot].
Lying lying_after(Vec2 push);

}  // namespace sim::motion
