// What the referee decided.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/math/tick.h"
#include "sim/math/vec2.h"
#include "sim/world/world.h"

namespace sim::referee {

struct Event {
  enum class Kind : std::uint8_t {
    ready,
    set,
    playing,
    ball_free,  // phases
    goal,
    out,
    kick_in,
    goal_kick,
    corner_kick,  // the ball
    pushing,
    illegal_defender,
    leaving,
    local_stuck,
    global_stuck,
    illegal_kick,
    illegal_position,  // offences
    returned,          // a penalised robot comes back
    half_time,         // sides have changed, everybody stands at the touch lines again, nobody is penalised
    end,
    placed,  // a robot that stood illegally in set was carried to the nearest legal place
  };
  Kind kind;
  Side side = Side::home;        // who scored, whose kick it is, whose robot it was
  std::uint8_t robot = kNobody;  // index; kNobody: not about one robot
  Tick tick = 0;
  Vec2 at;  // [m, field] of the ball or the robot
};

/// As a sentence's words in a report: "goal", "kick-in", ...
const char* name_of(Event::Kind kind);

/// The decisions of one step; more than fit are counted and dropped (cannot happen: one rule decides once a step).
struct Events {
  std::array<Event, 32> list;
  int count = 0;

  void add(const Event& event) {
    if (count < static_cast<int>(list.size())) list[static_cast<std::size_t>(count)] = event;
    ++count;
  }
};

}  // namespace sim::referee
