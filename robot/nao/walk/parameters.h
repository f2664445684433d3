// The numbers of the walk.
//
// Most were found by hand, then by searches on simulated robots (tests/walk/tune_main.cpp): steps in 15 generations of 6
// robots from seed 2,100,000, the mean of the last generations, rounded. Kicks were tried by hand on robots from seeds 460,000,
// 461,000 and 470,000. No real robot has walked with them yet.
#pragma once

namespace robot::nao::walk {

/// Lengths in metres, times in seconds, angles in radians.
struct Parameters {
  // the step
  double period = 0.266;          // [s] planned duration of a step; B-Human have 0.25 s, HULKs 0.235 s
  double hip_height = 0.212;      // [m] height of the hip above the soles
  double ahead = 0.0135;          // [m] the hip stands this far in front of the middle of the ankles
  double wider = 0.00291;         // [m] each foot stands this far outside of its place under the hip
  double lift = 0.0222;           // [m] height of the swing foot
  double lift_per_stride = 0.08;  // [m/m] more for a longer step, forwards or backwards
  double lift_per_side = 0.06;    // [m/m] more for a step to the side
  double lift_per_turn = 0.01;    // [m/rad] more for a turning step
  double lift_per_catch = 0.15;   // [m/m] more for a step that catches a fall
  double landing = 0.962;         // [period] the swing foot moves with the ground from then on

  // the exchange of the support foot
  double share = 0.266;         // [0..1] share of the weight on the swing foot that ends the step
  double earliest = 0.671;      // [period] the exchange of the support foot comes no earlier
  double latest = 1.8;          // [period] then that exchange is forced
  double hanging = 0.8;         // [period] so much later while the robot hangs on an outer edge
  double hanging_share = 0.15;  // [0..1] it hangs while the swing foot carries less
  double lookahead = 0.842;     // [ticks] the weight on the swing foot is predicted for this time

  // angles and rates of the torso, fed back to the support leg
  double smoothing = 0.372;            // [0..1] share of the old value in the low pass of the gyroscope
  double rate_to_ankle_pitch = 0.106;  // [rad s/rad] feedback of the gyroscope to the support leg
  double rate_to_ankle_roll = 0.0132;  // [rad s/rad] feedback of the gyroscope to the support leg
  double rate_to_hip_pitch = 0.0812;   // [rad s/rad] feedback of the gyroscope to the support leg
  double tilt_to_ankle_pitch = 0.22;   // [rad/rad] feedback of the torso's angle to the support leg
  double tilt_to_ankle_roll = 0.0165;  // [rad/rad] feedback of the torso's angle to the support leg

  // steps that catch a fall
  double com_height = 0.27;            // [m] height of the centre of mass, for the pendulum
  double catch_forward = 0.467;        // [m/m] shift of the swing foot per error of the capture point
  double catch_forward_from = 0.023;   // [m] smaller errors have no effect
  double catch_forward_most = 0.0807;  // [m] bound of that shift
  double catch_side = 0.314;           // [m/m] shift of the swing foot to the side
  double catch_side_from = 0.0279;     // [m] smaller errors have no effect
  double catch_side_most = 0.07;       // [m] bound of that shift
  double counter = 1.8;                // [m/m] outward shift when the robot tips over the support foot
  double counter_from = 0.0466;        // [m] smaller errors have no effect
  double counter_most = 0.11;          // [m] bound of that shift
  double catch_speed = 0.645;          // [m/s] fastest shift of the swing foot
  double side_speed = 0.873;           // [m/s] fastest shift of the swing foot to the side
  double learning = 0.107;             // [0..1] share of a new measurement in the usual course of the error
  double usual_forward_most = 0.03;    // [m] bound of that course
  double usual_side_most = 0.05;       // [m] bound of that course to the side
  double fights_from = 0.032;          // [m] a larger shift counts as a fight for balance
  double calm_share = 0.277;           // [0..1] share of the commanded speed in a fight
  double calm_rise = 0.15;             // [0..1] share of the commanded speed, regained in each step
  double lean_learning = 0.02;         // [0..1] share of the mean error that moves the hip, in each step
  double lean_most = 0.03;             // [m] bound of that move

  // speed
  double forward_change = 0.05;   // [m/s] largest change in a step; twice as much for slowing down
  double side_change = 0.06;      // [m/s] largest change in a step
  double turn_change = 0.35;      // [rad/s] largest change in a step
  double longer = 0.12;           // [0..1] share by which strides are planned longer: legs fall short of their targets
  double speed_learning = 0.1;    // [0..1] share of the error of the speed that corrects the plan, in each step
  double correction_most = 0.06;  // [m/s] bound of that correction
  double heading_rate = 2;        // [1/s] return to the wanted heading
  double heading_most = 0.6;      // [rad/s] bound of that turn

  // kicks with a step
  double kick_speed = 0.13;    // [m/s] the robot walks into the ball: a kick on the spot is weaker and shorter
  double kick_reach = 0.2;     // [m] distance of the farthest ball from the torso, when the step begins
  double kick_period = 0.3;    // [s] duration of the step that kicks
  double kick_lift = 0.02;     // [m] the foot is lifted higher
  double kick_ahead = 0.12;    // [m] the foot swings ahead, beyond its place
  double kick_side = 0.11;     // [m] the foot swings outwards, beyond its place
  double kick_turn = 0.6;      // [rad] the foot turns inwards
  double kick_from = 0.23;     // [kick_period] the swing begins
  double kick_contact = 0.65;  // [kick_period] the foot is ahead
  double kick_over = 1.1;      // [kick_period] the foot would be at its place

  // servos
  double lag_share = 0.651;      // [0..1] share of the servos' lag that is led
  double lag_most = 0.09;        // [s] bound of the lag
  double lead_most = 0.11;       // [rad] bound of the lead
  double sag_learning = 0.0137;  // [0..1] share of the error of a carrying leg in its sag, in each tick
  double sag_most = 0.12;        // [rad] bound of the sag
  double sag_rise = 0.361;       // [period] the new support leg is raised until then, the other is let down

  // standing
  double stand_forward = 0.05;  // [m] error forwards or backwards that starts steps
  double stand_side = 0.045;    // [m] error to a side that starts steps
};

}  // namespace robot::nao::walk
