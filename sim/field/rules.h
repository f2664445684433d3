// The rules of a year, as data.
#pragma once

#include <cstdint>

#include "sim/field/field.h"

namespace sim {

inline constexpr int kMaxPlayers = 7;  // a side

namespace field {

/// What happens to a ball that left the field.
enum class BallOut : std::uint8_t {
  placed_back,  // until 2017: an assistant puts it down inside the touch line, play goes on
  set_play,     // since: kick-in, goal kick, corner kick
};

/// Times [s], lengths [m], counts.
struct Rules {
  Field field;
  BallOut ball_out;

  int players;  // a side, the goalkeeper included, 1..7
  int halves;
  float half_duration;
  float ready_duration;  // at most; ends early when everybody stands in place
  float set_duration;
  float kick_off_duration;   // after which everybody may touch the ball
  float set_play_duration;   // likewise; 0 where there are none
  bool kick_off_goal;        // a goal may be scored directly from the kick-off
  float clear_distance;      // opponents keep this far from the ball of a kick-off or set play
  float goal_message_delay;  // the GameController tells robots of a goal this much later
  int mercy_goals;           // a game ends at this difference; 0: never

  float out_inset;     // placed_back: how far inside the touch line the ball is put
  float out_set_back;  // placed_back: how far towards the own goal of whoever put it out

  float penalty_duration;
  float penalty_step;      // longer for each further one of the same team
  float pushing_time;      // a robot that runs into another for so long is removed; 0: nobody is
  bool illegal_defender;   // only the goalkeeper may stay in its own goal area
  float stuck_local;       // several robots round a ball that does not get away; 0: not a rule
  float stuck_global;      // nobody touches the ball; 0: not a rule
  float leaving_distance;  // beyond the border of the carpet

  int message_budget;      // packets of a team and game; 0: no limit
  float message_interval;  // between two of one robot, at least

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
    see("message_budget", self.message_budget, "messages", 0, 100000);
    see("message_interval", self.message_interval, "s", 0.03f, 60.f);
  }
};

}  // namespace field
}  // namespace sim
