// The rules of a year, as data.
#pragma once

#include <cstdint>

#include "sim/field/field.h"

namespace sim {

inline constexpr int kMaxPlayers = 7;  // a side

namespace field {

/// The treatment of a ball that left the field.
enum class BallOut : std::uint8_t {
  placed_back,  // until 2017: an assistant puts it down inside the touch line, play goes on
  set_play,     // since 2018: kick-in, goal kick, corner kick
};

/// The rules of one year: times [s], lengths [m], counts.
struct Rules {
  Field field;
  BallOut ball_out;

  int players;  // a side, the goalkeeper included, 1..7
  int halves;
  float half_duration;
  float ready_duration;  // longest; READY ends earlier when all robots stand still
  float set_duration;
  float kick_off_duration;   // after this time both sides may touch the ball
  float set_play_duration;   // likewise; 0 in years without set plays
  bool kick_off_goal;        // a goal may be scored directly from the kick-off
  float clear_distance;      // opponents' distance from the ball of a kick-off or set play
  float goal_message_delay;  // from a goal to the GameController's message to the robots
  int mercy_goals;           // lead that ends a game; 0: no limit

  float out_inset;     // placed_back: distance of the ball from the touch line, inwards
  float out_set_back;  // placed_back: shift towards the own goal of the side that put the ball out

  float penalty_duration;
  float penalty_step;      // added for each earlier penalty of the same team
  float pushing_time;      // running into another robot for this long is punished; 0: never
  bool illegal_defender;   // only the goalkeeper may stay in its own goal area
  float stuck_local;       // time with several robots round a ball that does not get away; 0: no such rule
  float stuck_global;      // time without a touch of the ball; 0: no such rule
  float leaving_distance;  // beyond the edge of the carpet
  float ball_radius;       // of the league's ball; 0: that of the models

  int shoot_out_shots;         // of a side in the penalty shoot-out after a draw; 0: no shoot-out
  int shoot_out_sudden_shots;  // of a side in the sudden death that follows a draw
  float shoot_out_duration;    // longest, of one shot

  int message_budget;      // packets of a team in a game; 0: no limit
  float message_interval;  // least time between two packets of one robot

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("players", self.players, "robots", 1, 7);
    see("halves", self.halves, "", 1, 4);
    see("half_duration", self.half_duration, "s", 1.f, 36000.f);
    see("ready_duration", self.ready_duration, "s", 1.f, 120.f);
    see("set_duration", self.set_duration, "s", 0.f, 60.f);
    see("kick_off_duration", self.kick_off_duration, "s", 0.f, 60.f);
    see("kick_off_goal", self.kick_off_goal, "", false, true);
    see("set_play_duration", self.set_play_duration, "s", 0.f, 120.f);
    see("clear_distance", self.clear_distance, "m", 0.f, 3.f);
    see("goal_message_delay", self.goal_message_delay, "s", 0.f, 60.f);
    see("mercy_goals", self.mercy_goals, "goals", 0, 100);
    see("out_inset", self.out_inset, "m", 0.f, 2.f);
    see("out_set_back", self.out_set_back, "m", 0.f, 3.f);
    see("penalty_duration", self.penalty_duration, "s", 0.f, 300.f);
    see("penalty_step", self.penalty_step, "s", 0.f, 60.f);
    see("pushing_time", self.pushing_time, "s", 0.f, 60.f);
    see("illegal_defender", self.illegal_defender, "", false, true);
    see("stuck_local", self.stuck_local, "s", 0.f, 120.f);
    see("stuck_global", self.stuck_global, "s", 0.f, 120.f);
    see("leaving_distance", self.leaving_distance, "m", 0.f, 3.f);
    see("ball_radius", self.ball_radius, "m", 0.f, 0.15f);
    see("shoot_out_shots", self.shoot_out_shots, "shots", 0, 20);
    see("shoot_out_sudden_shots", self.shoot_out_sudden_shots, "shots", 0, 100);
    see("shoot_out_duration", self.shoot_out_duration, "s", 1.f, 300.f);
    see("message_budget", self.message_budget, "messages", 0, 100000);
    see("message_interval", self.message_interval, "s", 0.03f, 60.f);
  }
};

}  // namespace field
}  // namespace sim
