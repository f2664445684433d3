// The settings of a strategy beside its tree: roles, habits of head and legs, places at a kick-off,
// names of kicks.
#pragma once

#include "sim/field/rules.h"
#include "sim/math/vec2.h"
#include "sim/motion/model.h"

namespace sim::agent {

/// The rule for who chases the ball and who stays back.
struct Roles {
  float hysteresis = 1.f;   // [s] lead that another robot needs to take over the ball
  float stale = 12.f;       // [s] a teammate silent for longer is ignored
  float defenders = 0.5f;   // [0..1] share of defenders among those without ball and goal, rounded
  float order_keep = 0.6f;  // [m] distance farther back that another robot needs to become the defender

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("hysteresis", self.hysteresis, "s", 0.f, 20.f);
    see("stale", self.stale, "s", 0.5f, 120.f);
    see("defenders", self.defenders, "", 0.f, 1.f);
    see("order_keep", self.order_keep, "m", 0.f, 5.f);
  }
};

/// Habits that all skills share.
struct Habits {
  float trust_eyes = 2.f;        // [s] the own sight of the ball beats reports for this time
  float forget_ball = 12.f;      // [s] a ball that nobody saw for longer is unknown
  float look_at_ball = 1.2f;     // [s] the head follows the ball ...
  float look_away = 0.7f;        // [s] ... and then looks for marks
  float look_angle = 0.7f;       // [rad] yaw of that look; HULKs' scan has 1.3, their glance 0.25
  float keep_clear = 0.9f;       // [m] from the ball of the opponents' kick; the rules ask for 0.75
  float avoid_radius = 0.45f;    // [m] from a robot in the way
  float walk_tolerance = 0.12f;  // [m] near enough to a place to stand there
  float walk_again = 0.5f;       // [m] off its place before a robot that stood there walks again

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("trust_eyes", self.trust_eyes, "s", 0.f, 30.f);
    see("forget_ball", self.forget_ball, "s", 0.5f, 120.f);
    see("look_at_ball", self.look_at_ball, "s", 0.f, 30.f);
    see("look_away", self.look_away, "s", 0.f, 30.f);
    see("look_angle", self.look_angle, "rad", 0.f, 2.f);
    see("keep_clear", self.keep_clear, "m", 0.f, 3.f);
    see("avoid_radius", self.avoid_radius, "m", 0.f, 2.f);
    see("walk_tolerance", self.walk_tolerance, "m", 0.02f, 1.f);
    see("walk_again", self.walk_again, "m", 0.02f, 3.f);
  }
};

/// The places of players 1.. at a kick-off, as shares of half the field's length and width: {-1, 0} is the own goal,
/// {0, 1} the left touch line. A place against the rules is corrected.
struct Formation {
  Vec2 ours[kMaxPlayers] = {{-0.95f, 0},    {-0.09f, 0},     {-0.45f, -0.4f}, {-0.3f, 0.45f},
                            {-0.6f, 0.35f}, {-0.15f, -0.6f}, {-0.7f, -0.1f}};
  Vec2 theirs[kMaxPlayers] = {{-0.95f, 0},    {-0.32f, 0},     {-0.6f, -0.35f}, {-0.4f, 0.4f},
                              {-0.65f, 0.3f}, {-0.4f, -0.55f}, {-0.7f, 0}};
};

inline constexpr int kMaxNamedKicks = 8;

/// The kicks that the leaves of the tree name.
struct NamedKicks {
  int count = 0;
  char names[kMaxNamedKicks][sizeof motion::Kick::name] = {};
};

struct Settings {
  Roles roles;
  Habits habits;
  Formation formation;
  NamedKicks kicks;
};

}  // namespace sim::agent
