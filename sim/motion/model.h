// The abilities of a robot's body, as data: walk, head, kicks, squat, falls.
#pragma once

#include "sim/motion/fall_table.h"

namespace sim::motion {

inline constexpr int kMaxKicks = 8;

/// The walk. Speeds are the greatest possible ones of the fastest robot; commands are clipped to them.
struct Walk {
  float forward;            // [m/s]
  float backward;           // [m/s]
  float sideward;           // [m/s]
  float turn_rate;          // [rad/s]
  float acceleration;       // [m/s²]
  float turn_acceleration;  // [rad/s²]
  float turn_cost;          // [0..1] share of the speed lost at the greatest turn rate, linear
  float slow_down;          // [m] distance from the destination of walk_to at which slowing down begins
  float step_duration;      // [s] the start of a step obeys a new command and draws the noise
  float spread;             // [0..1] share by which the slowest robot is slower; all between are equally likely
  float speed_noise;        // standard deviation per step, as share of the speed
  float turn_noise;         // [rad/s] standard deviation per step while walking
  float start_delay;        // [s] from the command to the first motion
  float stop_delay;         // [s] from the command to standing

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("forward", self.forward, "m/s", 0.01f, 3.f);
    see("backward", self.backward, "m/s", 0.01f, 3.f);
    see("sideward", self.sideward, "m/s", 0.01f, 3.f);
    see("turn_rate", self.turn_rate, "rad/s", 0.05f, 6.f);
    see("acceleration", self.acceleration, "m/s²", 0.05f, 20.f);
    see("turn_acceleration", self.turn_acceleration, "rad/s²", 0.05f, 60.f);
    see("turn_cost", self.turn_cost, "", 0.f, 1.f);
    see("slow_down", self.slow_down, "m", 0.01f, 2.f);
    see("step_duration", self.step_duration, "s", 0.1f, 2.f);
    see("spread", self.spread, "", 0.f, 0.9f);
    see("speed_noise", self.speed_noise, "", 0.f, 0.5f);
    see("turn_noise", self.turn_noise, "rad/s", 0.f, 1.f);
    see("start_delay", self.start_delay, "s", 0.f, 2.f);
    see("stop_delay", self.stop_delay, "s", 0.f, 2.f);
  }
};

/// The head's joints. Near the shoulders the yaw is limited further (Northern Bites, corpus/Kinematics.h).
struct Head {
  float yaw_limit;    // [rad] to each side
  float pitch_up;     // [rad] < 0
  float pitch_down;   // [rad] > 0
  float yaw_speed;    // [rad/s]
  float pitch_speed;  // [rad/s]

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("yaw_limit", self.yaw_limit, "rad", 0.1f, 3.1f);
    see("pitch_up", self.pitch_up, "rad", -1.5f, 0.f);
    see("pitch_down", self.pitch_down, "rad", 0.f, 1.5f);
    see("yaw_speed", self.yaw_speed, "rad/s", 0.1f, 20.f);
    see("pitch_speed", self.pitch_speed, "rad/s", 0.1f, 20.f);
  }
};

/// One kick, described for the left foot; the right foot's is its mirror image.
struct Kick {
  char name[16];
  float ball_x;               // [m, robot] best place of the ball
  float ball_y;               // [m, robot]
  float gate_x;               // [m] half size of the region round it with full quality
  float gate_y;               // [m]
  float delay;                // [s] from the command to the touch of the ball
  float duration;             // [s] from the command to the next walk
  float range;                // [m] mean rolling distance
  float range_deviation;      // standard deviation, as share of the range
  float direction;            // [rad, robot] mean direction of the ball
  float direction_deviation;  // [rad] standard deviation
  bool in_walk;               // with a step of the walk; otherwise the robot stops first

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("ball_x", self.ball_x, "m", -0.3f, 0.5f);
    see("ball_y", self.ball_y, "m", -0.3f, 0.3f);
    see("gate_x", self.gate_x, "m", 0.005f, 0.2f);
    see("gate_y", self.gate_y, "m", 0.005f, 0.2f);
    see("delay", self.delay, "s", 0.f, 3.f);
    see("duration", self.duration, "s", 0.1f, 6.f);
    see("range", self.range, "m", 0.1f, 12.f);
    see("range_deviation", self.range_deviation, "", 0.f, 0.6f);
    see("direction", self.direction, "rad", -3.15f, 3.15f);
    see("direction_deviation", self.direction_deviation, "rad", 0.f, 1.f);
    see("in_walk", self.in_walk, "", false, true);
  }
};

/// A squat with spread legs, as goalkeepers do. Its width is in the contact model.
struct Squat {
  float delay;     // [s] from the command to the ground
  float duration;  // [s] from the command to the next walk

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("delay", self.delay, "s", 0.f, 3.f);
    see("duration", self.duration, "s", 0.1f, 10.f);
  }
};

/// How well a foot hits the ball in a match. Some kicks hit it fully. The others hit it partly, beside its middle, and
/// give it a share of the speed: all shares are equally likely. The less it gets, the more its direction deviates.
struct Hits {
  float partial;  // [0..1] probability of a partial hit
  float spread;   // factor on the deviation of the direction after the weakest hit; 1 after a full one, linear between

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("partial", self.partial, "", 0.f, 1.f);
    see("spread", self.spread, "", 1.f, 10.f);
  }
};

/// Falls, which the thesis leaves out. The rate of falls is fitted to real games, or a table has what was measured.
struct Falls {
  float per_minute_walking;   // [1/min] while walking
  float per_second_touching;  // [1/s] more while in contact with another robot
  float lying;                // [s] before it begins to get up
  float getting_up;           // [s]
  float failure;              // [0..1] probability that an attempt fails and is repeated
  FallTable table;            // replaces all of these, if it is given

  /// Returns the time [s] from a fall until the robot stands, if its first attempt succeeds.
  float usual_time() const { return table.given ? table.usual_time() : lying + getting_up; }

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("per_minute_walking", self.per_minute_walking, "1/min", 0.f, 60.f);
    see("per_second_touching", self.per_second_touching, "1/s", 0.f, 10.f);
    see("lying", self.lying, "s", 0.f, 30.f);
    see("getting_up", self.getting_up, "s", 0.f, 30.f);
    see("failure", self.failure, "", 0.f, 0.95f);
  }
};

/// All abilities of a body.
struct Model {
  Walk walk;
  Head head;
  int kick_count;
  Kick kicks[kMaxKicks];
  Hits hits;
  Squat squat;
  Falls falls;
};

}  // namespace sim::motion
