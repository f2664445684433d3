// The simulated effects of reality. Each one can be switched on and off.
#pragma once

namespace sim {

/// One switch per effect. Off is ideal: without `limited_view` a robot sees the ball wherever it is, and without
/// `odometry_drift` it always knows its exact pose.
struct Effects {
  bool limited_view;    // the ball is seen only inside the camera's view and range
  bool missed_ball;     // a ball in view is detected with a probability only
  bool occlusion;       // a ball behind a robot is not seen
  bool false_balls;     // percepts of other things as balls
  bool ball_noise;      // errors of range and bearing
  bool latency;         // of the camera
  bool odometry_drift;  // all errors of localisation
  bool pose_flips;      // poses turned round by 180° on the symmetric field
  bool packet_limit;    // the year's budget and interval; off: a packet with every decision
  bool packet_delay;
  bool packet_loss;
  bool walk_acceleration;  // limits of acceleration and the cost of turning
  bool walk_noise;
  bool walk_spread;  // each robot has its own top speed
  bool walk_delay;   // of starting and stopping
  bool head_limits;  // speed and range of the joints; off: the head looks anywhere at once
  bool kick_noise;
  bool kick_whiff;    // a kick misses a ball that lies outside its gate; off: it hits every ball within reach
  bool partial_hits;  // a foot may hit only a part of the ball, or slip over it
  bool push_noise;    // a random direction of a ball that a robot walks into
  bool falls;
  bool lost_pose;  // a fall turns and shifts the believed pose
  bool duels;      // a ball between two robots that push it from both sides may be squeezed out sideways
  bool official;   // a referee walks on the field, is an obstacle and hides the ball

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
    see("walk_spread", self.walk_spread, "", false, true);
    see("walk_delay", self.walk_delay, "", false, true);
    see("head_limits", self.head_limits, "", false, true);
    see("kick_noise", self.kick_noise, "", false, true);
    see("kick_whiff", self.kick_whiff, "", false, true);
    see("partial_hits", self.partial_hits, "", false, true);
    see("push_noise", self.push_noise, "", false, true);
    see("falls", self.falls, "", false, true);
    see("lost_pose", self.lost_pose, "", false, true);
    see("duels", self.duels, "", false, true);
    see("official", self.official, "", false, true);
  }
};

}  // namespace sim
