// The physics of ball and contacts, as data.
#pragma once

namespace sim {

/// The ball on the carpet.
struct BallModel {
  float radius;             // [m]
  float deceleration;       // [m/s²] of rolling, constant
  float post_restitution;   // [0..1] share of the speed after a bounce off a post
  float robot_restitution;  // [0..1] likewise off a robot
  float stop_speed;         // [m/s] a slower ball stops at once, in a dimple of the carpet

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("radius", self.radius, "m", 0.01f, 0.2f);
    see("deceleration", self.deceleration, "m/s²", 0.01f, 3.f);
    see("post_restitution", self.post_restitution, "", 0.f, 1.f);
    see("robot_restitution", self.robot_restitution, "", 0.f, 1.f);
    see("stop_speed", self.stop_speed, "m/s", 0.f, 0.2f);
  }
};

/// The sizes of bodies as circles.
struct ContactModel {
  float robot_radius;      // [m] two robots touch at twice this distance
  float foot_radius;       // [m] of a robot against the ball: it touches at this plus the ball's radius
  float squatting_radius;  // [m] of a squatting robot, likewise
  float lying_radius;      // [m] of a fallen robot
  float hiding_radius;     // [m] of a standing robot that hides things behind it, mean over its headings
  float official_radius;   // [m] of the walking referee
  float push_deviation;    // [rad] standard deviation of the direction of a ball that a robot walks into
  float duel_gap;          // [m] between foot and ball up to which a robot takes part in a duel
  float duel_rate;         // [1/s] balls squeezed out while a duel lasts
  float duel_speed;        // [m/s] greatest speed of a ball squeezed out; all speeds up to it are equally likely

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("robot_radius", self.robot_radius, "m", 0.05f, 0.5f);
    see("foot_radius", self.foot_radius, "m", 0.02f, 0.5f);
    see("squatting_radius", self.squatting_radius, "m", 0.02f, 0.6f);
    see("lying_radius", self.lying_radius, "m", 0.05f, 0.6f);
    see("hiding_radius", self.hiding_radius, "m", 0.02f, 0.5f);
    see("official_radius", self.official_radius, "m", 0.05f, 0.6f);
    see("push_deviation", self.push_deviation, "rad", 0.f, 1.5f);
    see("duel_gap", self.duel_gap, "m", 0.f, 0.2f);
    see("duel_rate", self.duel_rate, "1/s", 0.f, 10.f);
    see("duel_speed", self.duel_speed, "m/s", 0.f, 3.f);
  }
};

}  // namespace sim
