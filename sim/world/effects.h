// What of reality is simulated: each effect can be switched on its own.
#pragma once

namespace sim {

/// Off means ideal: without `limited_view` a robot sees the ball wherever it is, without `odometry_drift` it always
/// knows where it stands.
struct Effects {
  bool limited_view;    // the ball is seen only inside the camera's view and range
  bool missed_ball;     // and then only as often as the detection finds it
  bool occlusion;       // and never behind a robot
  bool false_balls;     // percepts of what is not a ball
  bool ball_noise;      // range and bearing noise
  bool latency;         // the camera's
  bool odometry_drift;  // and so all errors of localisation
  bool pose_flips;      // turned round on the symmetric field
  bool packet_limit;    // the year's budget and interval; off: every decision
  bool packet_delay;
  bool packet_loss;
  bool walk_acceleration;  // limits of acceleration and the cost of turning
  bool walk_noise;
  bool walk_delay;   // start and stop
  bool head_limits;  // speed and joints; off: the head looks anywhere at once
  bool kick_noise;
  bool kick_whiff;  // a kick misses the ball that lies off its gate; off: it always hits within reach
  bool push_noise;  // a ball that is walked into goes about
  bool falls;
  bool official;  // the referee walks on the field: an obstacle, and hides the ball

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("limited_view", self.limited_view, "", false, true);
    see("missed_ball", self.missed_ball, "", false, true);
    see("occlusion", self.occlusion, "", false, true);
    see("false_balls", self.false_balls, "", false, true);
    see("ball_noise", self.ball_noise, "", false, true);
    see("latency", self.latency, "", false, true);
    see("odometry_drift", self.odometry_drift, "", false, true);
    see("pose_flips", self.pose_flips, "", false, true);
    see("packet_limit", self.packet_limit, "", false, true);
    see("packet_delay", self.packet_delay, "", false, true);
    see("packet_loss", self.packet_loss, "", false, true);
    see("walk_acceleration", self.walk_acceleration, "", false, true);
    see("walk_noise", self.walk_noise, "", false, true);
    see("walk_delay", self.walk_delay, "", false, true);
    see("head_limits", self.head_limits, "", false, true);
    see("kick_noise", self.kick_noise, "", false, true);
    see("kick_whiff", self.kick_whiff, "", false, true);
    see("push_noise", self.push_noise, "", false, true);
    see("falls", self.falls, "", false, true);
    see("official", self.official, "", false, true);
  }
};

}  // namespace sim
